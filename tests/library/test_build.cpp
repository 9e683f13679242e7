// SPDX-License-Identifier: MIT
// Scenes built in C++: valid as they come, and what each function puts into them.
#include <catch2/catch.hpp>

#include "scene/model/build.h"
#include "scene/validate.h"

using namespace strahl;

TEST_CASE("A scene without anything in it is valid: grey default material, a camera, a film") {
  const Scene scene;
  CHECK(validate(scene).empty());
  REQUIRE(scene.materials.size() == 1);
  CHECK(std::get<Diffuse>(scene.materials[0].bsdf).reflectance.color == Rgb{0.5, 0.5, 0.5});
  CHECK_FALSE(scene.materials[0].twosided);
}

TEST_CASE("Whatever is added stands at the index that add returns") {
  Scene scene;
  const int red = add(scene, Diffuse{{{1, 0, 0}}});
  const int sheet = add(scene, Diffuse{{{0, 1, 0}}}, true);
  CHECK(red == 1);
  CHECK(sheet == 2);
  CHECK(std::get<Diffuse>(scene.materials[1].bsdf).reflectance.color == Rgb{1, 0, 0});
  CHECK_FALSE(scene.materials[1].twosided);
  CHECK(scene.materials[2].twosided);

  CHECK(add(scene, Sphere{{0, 0, -5}, 2}) == 0);
  CHECK(add(scene, Box{{0, 0, 0}, {1, 1, 1}}, red) == 1);
  CHECK(add(scene, emitting(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {3, 4, 5})) == 2);
  CHECK(scene.shapes[0].material == 0);
  CHECK_FALSE(scene.shapes[0].radiance);
  CHECK(std::get<Sphere>(scene.shapes[0].geometry).radius == 2);
  CHECK(scene.shapes[1].material == red);
  CHECK(scene.shapes[2].radiance == Rgb{3, 4, 5});
  CHECK(std::get<Triangle>(scene.shapes[2].geometry).p1 == Vec3{1, 0, 0});

  CHECK(add(scene, PointLight{{1, 2, 3}, {4, 4, 4}}) == 0);
  CHECK(add(scene, ConstantLight{}) == 1);
  CHECK(std::get<PointLight>(scene.lights[0].emitter).position == Vec3{1, 2, 3});
  CHECK(validate(scene).empty());
}

TEST_CASE("A plane's own frame lies in the plane, whatever its normal") {
  for (const Vec3& normal : {Vec3{0, 1, 0}, Vec3{0, 0, -3}, Vec3{1e-3, -2, 5}}) {
    const Plane plane = plane_through({1, 2, 3}, normal);
    CHECK(plane.point == Vec3{1, 2, 3});
    CHECK(plane.normal == normal);
    CHECK(length(plane.u) == Approx(1));
    CHECK(length(plane.v) == Approx(1));
    CHECK(dot(plane.u, plane.v) == Approx(0).margin(1e-15));
    CHECK(dot(plane.u, normal) == Approx(0).margin(1e-15));
    CHECK(dot(cross(plane.u, plane.v), normal) == Approx(length(normal)));
  }
}

TEST_CASE("A camera looks along +z of its frame at the target, +x to the left, y up") {
  const Camera camera = perspective_camera({0, 0, 9}, {0, 0, 0}, {0, 2, 0}, 40);
  CHECK(camera.projection == Projection::perspective);
  CHECK(camera.fov_degrees == 40);
  CHECK(camera.fov_axis == FovAxis::x);
  CHECK(camera.world_from_camera.translation() == Vec3{0, 0, 9});
  CHECK(camera.world_from_camera.column(0) == Vec3{-1, 0, 0});
  CHECK(camera.world_from_camera.column(1) == Vec3{0, 1, 0});
  CHECK(camera.world_from_camera.column(2) == Vec3{0, 0, -1});
}

TEST_CASE("A camera without a view is refused") {
  CHECK_THROWS_AS(perspective_camera({1, 2, 3}, {1, 2, 3}, {0, 1, 0}, 40), SceneError);
  CHECK_THROWS_AS(perspective_camera({0, 0, 0}, {0, 5, 0}, {0, 1, 0}, 40), SceneError);
  CHECK_THROWS_AS(perspective_camera({0, 0, 0}, {0, 0, 5}, {0, 0, 0}, 40), SceneError);
}
