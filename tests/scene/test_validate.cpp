// SPDX-License-Identifier: MIT
// Scenes built by hand: every broken invariant is named.
#include <catch2/catch.hpp>
#include <limits>
#include <utility>

#include "scene/model/build.h"
#include "scene/one_problem.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Scene scene_with(const Geometry& geometry) {
  Scene scene;
  Shape shape;
  shape.geometry = geometry;
  scene.shapes.push_back(shape);
  return scene;
}

template <class Change>
void check_changed(const std::string& words, const Change& change) {
  Scene scene = scene_with(Sphere{});
  change(scene);
  check_one_problem(scene, words);
}

Mesh triangle_mesh() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("sound scenes have no faults") {
  const Geometry sound[] = {Sphere{},
                            Plane{},
                            Box{},
                            Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                            Rectangle{{}, {1, 0, 0}, {0, 1, 0}},
                            Cube{{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}},
                            Disk{{}, {1, 0, 0}, {0, 1, 0}},
                            Cylinder{{}, {0, 0, 1}, 1, {1, 0, 0}},
                            triangle_mesh()};
  for (const Geometry& geometry : sound) {
    INFO(geometry.index());
    CHECK(validate(scene_with(geometry)).empty());
  }
}

TEST_CASE("faults of geometry") {
  check_one_problem(scene_with(Sphere{{}, 0}), "radius");
  check_one_problem(scene_with(Sphere{{nan_value, 0, 0}}), "finite");
  check_one_problem(scene_with(Sphere{{}, 1, {{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}}}), "orthonormal");
  check_one_problem(scene_with(Plane{{}, {0, 0, 0}}), "not zero");
  check_one_problem(scene_with(Plane{{}, {0, 1e-310, 0}}), "the normal's length is 1e-310");
  CHECK(validate(scene_with(Plane{{}, {0, 1e-307, 0}})).empty());
  check_one_problem(scene_with(Disk{{}, {1e-170, 0, 0}, {0, 1e-170, 0}}), "span an area");
  check_one_problem(scene_with(Plane{{}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}}), "span");
  // Readers shear planes whose u and v then lie close to each other, and keep them in the plane.
  check_one_problem(scene_with(Plane{{0, 0, -14}, {0, 0, 1}}), "plane_through()");
  check_one_problem(scene_with(Plane{{}, {0, 1e-300, 0}, {1, 0.01, 0}, {0, 0, 1}}), "lie in the plane");
  CHECK(validate(scene_with(Plane{{}, {0, -1e300, 0}, {1e-9, 0, 0}, {1e9, 0, 1e-3}})).empty());
  CHECK(validate(scene_with(plane_through({1, 2, 3}, {3e5, -4e-5, 7}))).empty());
  check_one_problem(scene_with(Box{{1, 0, 0}, {0, 0, 0}}), "min");
  check_one_problem(scene_with(Triangle{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), "line");
  check_one_problem(scene_with(Rectangle{{}, {1, 0, 0}, {1, 0, 0}}), "area");
  check_one_problem(scene_with(Cube{{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}}), "volume");
  check_one_problem(scene_with(Disk{{}, {1, 0, 0}, {0, 2, 0}}), "equally long");
  check_one_problem(scene_with(Cylinder{{}, {0, 0, 1}, 1, {0, 0, 1}}), "reference");
  check_one_problem(scene_with(Cylinder{{}, {}, 1, {1, 0, 0}}), "differ");
  Mesh mesh = triangle_mesh();
  mesh.triangles[0][1] = 3;
  check_one_problem(scene_with(mesh), "triangle 0");
  mesh = triangle_mesh();
  mesh.normals.resize(1);
  check_one_problem(scene_with(mesh), "normal for every vertex");
  mesh = triangle_mesh();
  mesh.parts = {{0, {}}};
  mesh.part_of_triangle = {1};
  check_one_problem(scene_with(mesh), "part_of_triangle");
  mesh.part_of_triangle = {0};
  mesh.parts[0].material = 4;
  check_one_problem(scene_with(mesh), "material 4");
  mesh = triangle_mesh();
  mesh.triangles.clear();
  check_one_problem(scene_with(mesh), "no triangles");
}

TEST_CASE("faults of everything else") {
  check_changed("material 1", [](Scene& s) { s.shapes[0].material = 1; });
  check_changed("radiance", [](Scene& s) { s.shapes[0].radiance = Rgb{-1, 0, 0}; });
  check_changed("reflectance", [](Scene& s) { s.materials[0].bsdf = Diffuse{{{2, 0, 0}}}; });
  check_changed("specular_transmittance", [](Scene& s) {
    Dielectric glass;
    glass.transmittance.color.g = -1;
    s.materials[0].bsdf = glass;
  });
  for (const double ior : {0.0, -1.5, nan_value, 1e300 * 1e300})
    check_changed("int_ior", [&](Scene& s) { s.materials[0].bsdf = Dielectric{ior}; });
  check_changed("ratio", [](Scene& s) { s.materials[0].bsdf = Dielectric{1e-300, 1e300}; });
  check_changed("largest float", [](Scene& s) { s.shapes[0].radiance = Rgb{0, 1e300, 0}; });
  check_changed("intensity must be at most", [](Scene& s) {
    s.lights.resize(1);
    s.lights[0].emitter = PointLight{{0, 0, 9}, {1e300, 1e300, 1e300}};
  });
  check_changed("position", [](Scene& s) { s.lights.push_back({"", PointLight{{nan_value, 0, 0}, {}}, {}}); });
  check_changed("direction", [](Scene& s) { s.lights.push_back({"", DirectionalLight{{0, 0, 0}, {}}, {}}); });
  const auto spot = [](const Vec3& x, const Vec3& y) {
    SpotLight light;
    light.axis = {0, 3, 0};
    light.texture = 0;
    light.x = x;
    light.y = y;
    return [light](Scene& s) {
      s.textures.resize(1);
      s.lights.push_back({"", light, {}});
    };
  };
  for (const auto& [x, y] : {std::pair{Vec3{1, 0, 0}, Vec3{0, 1, 0}},
                             {{1, 0, 0}, {1, 0, 0}},
                             {{1, 0, 0}, {0, 0, 2}},
                             {{1, 0.01, 0}, {0, 0, 1}}})
    check_changed("perpendicular to its axis", spot(x, y));
  Scene lit = scene_with(Sphere{});
  spot({1, 0, 0}, {0, 0, 1})(lit);
  CHECK(validate(lit).empty());
  check_changed("\"a\" and \"a\" have the channel a.X in common", [](Scene& s) {
    s.integrator.aovs = {{"a", Aov::position}, {"b", Aov::normal}, {"a", Aov::normal}};
  });
  check_changed("has 251 bytes; a file holds 250", [](Scene& s) {
    s.integrator.aovs = {{std::string(251, 'x'), Aov::depth}};
  });
  check_changed("numeric_error, which scenes cannot name", [](Scene& s) {
    s.integrator.aovs = {{"a", Aov::numeric_error}};
  });
  check_changed("one constant", [](Scene& s) { s.lights.assign(2, {"", ConstantLight{}, {}}); });
  check_changed("fov", [](Scene& s) { s.camera.fov_degrees = 180; });
  check_changed("singular", [](Scene& s) { s.camera.world_from_camera.m[2] = {0, 0, 0, 0}; });
  check_changed("near_clip", [](Scene& s) { s.camera.far_clip = 0; });
  check_changed("crop", [](Scene& s) { s.film.crop = Window{5, 0, 5, 9}; });
  check_changed("stddev", [](Scene& s) { s.film.filter.stddev = 0; });
  check_changed("stddev is 1000000000 pixels; at most 256", [](Scene& s) { s.film.filter.stddev = 1e9; });
  check_changed("radius is 1000000000 pixels; at most 1024", [](Scene& s) { s.film.filter.radius = 1e9; });
  check_changed("seed must be at least 0", [](Scene& s) { s.sampler.seed = -1; });
  check_changed("sample_count", [](Scene& s) { s.sampler.sample_count = 0; });
  check_changed("max_depth", [](Scene& s) { s.integrator.max_depth = -2; });
  check_changed("no name", [](Scene& s) { s.integrator.name.clear(); });
  check_changed("no integrator \"pth\" (did you mean \"path\"?)", [](Scene& s) { s.integrator.name = "pth"; });
  check_changed("group 0 does not exist", [](Scene& s) { add_instance(s, 0, Transform{}); });
  for (const double weight : {-1.0, nan_value, 1e300 * 1e300}) {
    check_changed("sampling_weight", [&](Scene& s) { s.shapes[0].sampling_weight = weight; });
    check_changed("sampling_weight", [&](Scene& s) {
      s.lights.push_back({"", PointLight{}, {}});
      s.lights[0].sampling_weight = weight;
    });
  }
  // Of two that are each other's backs both are named.
  check_changed("backs of backs", [](Scene& s) { s.materials[0].back = 0; });
  Scene circle = scene_with(Sphere{});
  circle.materials.resize(2);
  circle.materials[0].back = 1;
  CHECK(validate(circle).empty());
  circle.materials[1].back = 0;
  CHECK(validate(circle).size() == 2);
  Scene wide = scene_with(Sphere{});
  wide.film.width = 65537;
  check_one_problem(wide, "65536");
}
