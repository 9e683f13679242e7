// SPDX-License-Identifier: MIT
// The camera's affine map, in closed form.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "packing/cl_layout.h"
#include "packing/pack_camera.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

class Packed {
 public:
  Packed(const Camera& camera, const Film& film, const UploadFrame& frame = {})
      : reals_(camera_reals(camera, film, frame)) {
    REQUIRE(reals_.size() == layout::CAMERA_REALS);
  }
  [[nodiscard]] Vec3 vector(std::size_t at) const { return {reals_[at], reals_[at + 1], reals_[at + 2]}; }
  [[nodiscard]] double operator[](std::size_t at) const { return reals_[at]; }

 private:
  std::vector<double> reals_;
};

/// At the origin, looking along -z, y up, with x to the right.
Camera plain(double fov_degrees, FovAxis axis = FovAxis::x) {
  Camera camera = perspective_camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, fov_degrees);
  camera.fov_axis = axis;
  return camera;
}

Film film(int width, int height) {
  Film film;
  film.width = width;
  film.height = height;
  return film;
}

void check_near(const Vec3& a, const Vec3& b) {
  CHECK(a.x == Approx(b.x).margin(1e-14));
  CHECK(a.y == Approx(b.y).margin(1e-14));
  CHECK(a.z == Approx(b.z).margin(1e-14));
}

}  // namespace

TEST_CASE("A right angle gives tangents of exactly 1") {
  const Packed reals(plain(90), film(64, 64));
  CHECK(reals.vector(layout::CAMERA_O) == Vec3{});
  CHECK(reals.vector(layout::CAMERA_OX) == Vec3{});
  CHECK(reals.vector(layout::CAMERA_OY) == Vec3{});
  CHECK(reals.vector(layout::CAMERA_D) == Vec3{0, 0, -1});
  CHECK(reals.vector(layout::CAMERA_DX) == Vec3{1, 0, 0});
  CHECK(reals.vector(layout::CAMERA_DY) == Vec3{0, -1, 0});
}

TEST_CASE("fov_axis says which extent of the picture the angle spans") {
  const double tangent = std::tan(30 * std::numbers::pi / 180);
  struct Case {
    FovAxis axis;
    int width, height;
    double x, y;  // half extents at depth 1
  };
  for (const Case& c :
       {Case{FovAxis::x, 400, 300, tangent, tangent * 0.75}, Case{FovAxis::y, 400, 300, tangent / 0.75, tangent},
        Case{FovAxis::diagonal, 400, 300, tangent * 0.8, tangent * 0.6},
        Case{FovAxis::smaller, 400, 300, tangent / 0.75, tangent},
        Case{FovAxis::larger, 400, 300, tangent, tangent * 0.75}, Case{FovAxis::x, 300, 400, tangent, tangent / 0.75},
        Case{FovAxis::y, 300, 400, tangent * 0.75, tangent},
        Case{FovAxis::diagonal, 300, 400, tangent * 0.6, tangent * 0.8},
        Case{FovAxis::smaller, 300, 400, tangent, tangent / 0.75},
        Case{FovAxis::larger, 300, 400, tangent * 0.75, tangent}}) {
    INFO("axis " << static_cast<int>(c.axis) << ", " << c.width << " x " << c.height);
    const Packed reals(plain(60, c.axis), film(c.width, c.height));
    check_near(reals.vector(layout::CAMERA_DX), {c.x, 0, 0});
    check_near(reals.vector(layout::CAMERA_DY), {0, -c.y, 0});
  }
}

TEST_CASE("The principal point moves every ray by picture widths and heights") {
  Camera camera = plain(90);
  camera.principal_point_offset_x = 0.25;
  camera.principal_point_offset_y = -0.5;
  const Packed reals(camera, film(200, 100));
  check_near(reals.vector(layout::CAMERA_D), {2 * 0.25 * 1, 2 * 0.5 * 0.5, -1});
  check_near(reals.vector(layout::CAMERA_DX), {1, 0, 0});
}

TEST_CASE("The frame's origin is subtracted before anything is rounded") {
  Camera camera = plain(90);
  camera.world_from_camera.m[0][3] = 1e15 + 0.125;
  const Packed reals(camera, film(8, 8), {1e15, 2, 3});
  CHECK(reals.vector(layout::CAMERA_O) == Vec3{0.125, -2, -3});
  CHECK(reals.vector(layout::CAMERA_D) == Vec3{0, 0, -1});
}

TEST_CASE("Clipping distances count along the viewing axis, whatever the camera's scale") {
  Camera camera = plain(90);
  for (auto& row : camera.world_from_camera.m)
    for (std::size_t i = 0; i < 3; ++i) row[i] *= 8;
  camera.near_clip = 2;
  camera.far_clip = 50;
  const Packed reals(camera, film(8, 8));
  CHECK(reals.vector(layout::CAMERA_D) == Vec3{0, 0, -1});
  CHECK(reals.vector(layout::CAMERA_DX) == Vec3{1, 0, 0});
  CHECK(reals.vector(layout::CAMERA_DY) == Vec3{0, -1, 0});
  CHECK(reals[layout::CAMERA_NEAR] == 2);
  CHECK(reals[layout::CAMERA_FAR] == 50);
}

TEST_CASE("A lens is two radii at right angles, and the rays of a place meet at the plane of focus") {
  Camera camera = plain(90);
  CHECK(Packed(camera, film(64, 64)).vector(layout::CAMERA_LENS_U) == Vec3{});
  camera.aperture_radius = 0.5;
  camera.focus_distance = 4;
  const Packed reals(camera, film(64, 64), {{0, 0, 0}, 2});
  CHECK(reals.vector(layout::CAMERA_LENS_U) == Vec3{1, 0, 0});
  CHECK(reals.vector(layout::CAMERA_LENS_V) == Vec3{0, -1, 0});
  CHECK(reals[layout::CAMERA_FOCUS] == 0.125);
}

TEST_CASE("An orthographic picture spans [-1, 1] of the camera's x, times its scale") {
  Camera camera = plain(60);
  camera.projection = Projection::orthographic;
  for (auto& row : camera.world_from_camera.m)
    for (std::size_t i = 0; i < 3; ++i) row[i] *= 4;
  const Packed reals(camera, film(400, 300));
  CHECK(reals.vector(layout::CAMERA_O) == Vec3{});
  CHECK(reals.vector(layout::CAMERA_OX) == Vec3{4, 0, 0});
  CHECK(reals.vector(layout::CAMERA_OY) == Vec3{0, -3, 0});
  CHECK(reals.vector(layout::CAMERA_D) == Vec3{0, 0, -1});
  CHECK(reals.vector(layout::CAMERA_DX) == Vec3{});
  CHECK(reals.vector(layout::CAMERA_DY) == Vec3{});
}
