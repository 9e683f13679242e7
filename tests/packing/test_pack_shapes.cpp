// SPDX-License-Identifier: MIT
// The numbers that each kind of primitive is packed as, before they are rounded.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "packing/pack_shapes.h"
#include "scene/model/build.h"

using namespace strahl;
using Primitive = std::vector<double>;

namespace {

std::vector<Primitive> planes(const Geometry& geometry, const Vec3& origin = {}, bool is_chosen = false) {
  std::vector<Primitive> all;
  primitive_planes(geometry, UploadFrame{origin, 1, is_chosen},
                   [&](std::span<const double> values) { all.emplace_back(values.begin(), values.end()); });
  return all;
}

Primitive only(const Geometry& geometry, const Vec3& origin = {}, bool is_chosen = false) {
  const std::vector<Primitive> all = planes(geometry, origin, is_chosen);
  REQUIRE(all.size() == 1);
  return all[0];
}

std::array<Vec3, 4> corners(const Primitive& p) {
  REQUIRE(p.size() == 12);
  return {Vec3{p[0], p[1], p[2]}, Vec3{p[3], p[4], p[5]}, Vec3{p[6], p[7], p[8]}, Vec3{p[9], p[10], p[11]}};
}

std::array<Vec3, 3> frame_of(const Geometry& geometry, const Vec3& origin = {}) {
  const auto f = surface_frame(geometry, UploadFrame{origin, 1});
  REQUIRE(f);
  return {Vec3{(*f)[0], (*f)[1], (*f)[2]}, Vec3{(*f)[3], (*f)[4], (*f)[5]}, Vec3{(*f)[6], (*f)[7], (*f)[8]}};
}

}  // namespace

TEST_CASE("In the world frame every number is packed as given, but for the power of two of normals") {
  CHECK(only(Sphere{{0.1, 0.2, 0.3}, 0.7}) == Primitive{0.1, 0.2, 0.3, 0.7});
  Plane plane = plane_through({0.1, 0.2, 0.3}, {0.3, -7, 0.1});
  CHECK(only(plane) == Primitive{0.1, 0.2, 0.3, 0.3 / 4, -7.0 / 4, 0.1 / 4});
  CHECK(only(Box{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}}) == Primitive{0.1, 1.1, 0.2, 1.2, 0.3, 1.3});
  CHECK(only(Triangle{{0.1, 0, 0}, {0, 0.2, 0}, {0, 0, 0.3}}) == Primitive{0.1, 0, 0, 0, 0.2, 0, 0, 0, 0.3});
}

TEST_CASE("Quadrics and parallelograms") {
  CHECK(only(Rectangle{{1, 2, 3}, {4, 0, 0}, {0, 5, 0}}) == Primitive{1, 2, 3, 5, 2, 3, 5, 7, 3, 1, 7, 3});
  // Centre, normal along axis_u x axis_v, squared radius.
  CHECK(only(Disk{{1, 2, 3}, {2, 0, 0}, {0, 2, 0}}) == Primitive{1, 2, 3, 0, 0, 1, 4});
  // The product of two lengths of 2^-520 is subnormal, and the power of two that makes it 1 is no double.
  CHECK(only(Disk{{1, 2, 3}, {0x1p-520, 0, 0}, {0, 0x1p-520, 0}}) == Primitive{1, 2, 3, 0, 0, 1, 0x1p-1040});
  // Foot, unit axis, height, radius.
  CHECK(only(Cylinder{{1, 2, 3}, {1, 2, 8}, 0.5, {1, 0, 0}}) == Primitive{1, 2, 3, 0, 0, 1, 5, 0.5});
}

TEST_CASE("A mesh's triangles in order, with their vertices in order") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
  CHECK(planes(mesh) == std::vector<Primitive>{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 0, 1, 0, 1, 0, 0}});
}

TEST_CASE("The frame's origin is subtracted from points, in double, and from nothing else") {
  const Vec3 far{1e15, -1e15, 1e15}, o = far;
  const auto at = [&](double x, double y, double z) { return far + Vec3{x, y, z}; };
  CHECK(only(Sphere{at(0.125, 0.25, 0.5), 3}, o) == Primitive{0.125, 0.25, 0.5, 3});
  CHECK(only(Box{at(0, 0, 0), at(1, 2, 4)}, o) == Primitive{0, 1, 0, 2, 0, 4});
  CHECK(only(Triangle{at(0, 0, 0), at(0.125, 0, 0), at(0, 0.5, 0)}, o) == Primitive{0, 0, 0, 0.125, 0, 0, 0, 0.5, 0});
  CHECK(only(Rectangle{at(1, 1, 1), {2, 0, 0}, {0, 2, 0}}, o) == Primitive{1, 1, 1, 3, 1, 1, 3, 3, 1, 1, 3, 1});
  CHECK(only(Disk{at(1, 0, 0), {2, 0, 0}, {0, 2, 0}}, o) == Primitive{1, 0, 0, 0, 0, 1, 4});
  CHECK(only(Cylinder{at(1, 0, 0), at(1, 0, 8), 2, {1, 0, 0}}, o) == Primitive{1, 0, 0, 0, 0, 1, 8, 2});
}

TEST_CASE("In a chosen frame a plane is held by its point nearest the frame's origin, be that the world's, too") {
  const Plane floor = plane_through({1e8, -1, 1e8}, {0, 3, 0});
  CHECK(only(floor, {7, 4, 7}, true) == Primitive{0, -5, 0, 0, 1.5, 0});
  const Plane slanted = plane_through({4, 0, 0}, {1, 1, 0});
  for (const double z : {9, 0}) {
    const Primitive p = only(slanted, {0, 0, z}, true);
    CHECK(p[0] == Approx(2));
    CHECK(p[1] == Approx(2));
    CHECK(p[2] == Approx(0).margin(1e-15));
  }
}

TEST_CASE("A cube's faces share their corners to the bit and look outwards, whatever its handedness") {
  for (const double mirror : {1.0, -1.0}) {
    const Cube cube{{0.1, 0.2, 0.3}, {{{0.7 * mirror, 0.01, 0.02}, {0.03, 0.9, 0.04}, {0.05, 0.06, 1.1}}}};
    const Vec3 middle = cube.corner + 0.5 * (cube.edge[0] + cube.edge[1] + cube.edge[2]);
    const Vec3 origin{0.3, 0.3, 0.3};
    const std::vector<Primitive> faces = planes(cube, origin);
    REQUIRE(faces.size() == 6);
    std::set<std::array<double, 3>> distinct;
    for (std::size_t face = 0; face < 6; ++face) {
      const auto [a, b, c, d] = corners(faces[face]);
      for (const Vec3& p : {a, b, c, d}) distinct.insert({p.x, p.y, p.z});
      CHECK(length(a + c - b - d) < 1e-15);  // a parallelogram, corners around it
      const Vec3 normal = cross(b - a, d - a), outward = 0.5 * (a + c) - (middle - origin);
      CHECK((dot(normal, outward) > 0) != faces_inward(cube));
      // -x, +x, -y, +y, -z, +z of the cube's own axes.
      CHECK((dot(outward, cube.edge[face / 2]) > 0) == (face % 2 == 1));
      CHECK(length(outward) == Approx(0.5 * length(cube.edge[face / 2])));
    }
    CHECK(distinct.size() == 8);
  }
}

TEST_CASE("u and v run over a cube's faces as over the mesh that is Mitsuba's cube") {
  const std::vector<Primitive> faces = planes(Cube{{-1, -1, -1}, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}}, {0, 0, 0});
  // Where u and v are 0, and where u is 1: Mesh::compute_surface_interaction of Mitsuba 3.9.1's cube.
  const std::array<std::array<Vec3, 3>, 6> of_mitsuba{{{{{-1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}},
                                                       {{{1, -1, 1}, {1, 1, 1}, {1, -1, -1}}},
                                                       {{{-1, -1, -1}, {-1, -1, 1}, {1, -1, -1}}},
                                                       {{{1, 1, 1}, {-1, 1, 1}, {1, 1, -1}}},
                                                       {{{-1, 1, -1}, {-1, -1, -1}, {1, 1, -1}}},
                                                       {{{-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}}}}};
  for (std::size_t face = 0; face < 6; ++face) {
    const auto [a, b, c, d] = corners(faces[face]);
    CHECK(length(a - of_mitsuba.at(face)[0]) == 0);
    CHECK(length(b - of_mitsuba.at(face)[1]) == 0);
    CHECK(length(d - of_mitsuba.at(face)[2]) == 0);
    CHECK(length(a + c - b - d) == 0);
  }
}

TEST_CASE("A plane's frame holds the duals of u and v, and the point that they count from") {
  const Plane plane{{1, 2, 3}, {0, 0, 5}, {2, 0, 0}, {1, 4, 0}};
  const auto [du, dv, point] = frame_of(plane, {1, 1, 1});
  CHECK(dot(du, plane.u) == Approx(1));
  CHECK(dot(du, plane.v) == Approx(0).margin(1e-15));
  CHECK(dot(dv, plane.u) == Approx(0).margin(1e-15));
  CHECK(dot(dv, plane.v) == Approx(1));
  CHECK(point == Vec3{0, 1, 2});
}

TEST_CASE("Frames of sphere, disk and cylinder; the others have none") {
  const Sphere turned{{0, 0, 0}, 1, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}};
  CHECK(frame_of(turned, {5, 5, 5}) == turned.frame);
  const auto [u, v, unused] = frame_of(Disk{{1, 2, 3}, {2, 0, 0}, {0, 2, 0}});
  CHECK(u == Vec3{0.5, 0, 0});
  CHECK(v == Vec3{0, 0.5, 0});
  CHECK(unused == Vec3{});
  const auto [zero, quarter, rest] = frame_of(Cylinder{{0, 0, 0}, {0, 0, 3}, 2, {1, 0, 0}});
  CHECK(zero == Vec3{1, 0, 0});
  CHECK(quarter == Vec3{0, 1, 0});
  CHECK(rest == Vec3{});
  for (const Geometry& geometry :
       {Geometry(Box{}), Geometry(Triangle{}), Geometry(Rectangle{}), Geometry(Cube{}), Geometry(Mesh{})})
    CHECK_FALSE(surface_frame(geometry, {}));
}
