// SPDX-License-Identifier: MIT
// Closed rooms of perfect mirrors with light outside: a pixel that is not black is a ray that got out. The mirrors are
// two-sided, so a ray that steps behind a wall flies off instead of ending there. Around the eye in the middle of a
// room rays through the picture's diagonals run along edges into corners.
//
// One room sends 10,000 rays over 10,000 mirrors, all of them 1,024 over 200.
// STRAHL_MIRRORS: that many mirrors in every room and tier, for 10,000 rays; STRAHL_PIXELS: for its square of rays.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "packing/cl_layout.h"
#include "render/pictures.h"
#include "scene/model/build.h"
#include "scene/model/transforms.h"

namespace strahl::test {
namespace {

struct Count {
  int pixels = 32, mirrors = 200;
};

Count asked_for() {
  const char *mirrors = std::getenv("STRAHL_MIRRORS"), *pixels = std::getenv("STRAHL_PIXELS");
  if (mirrors == nullptr) return {};
  return {pixels != nullptr ? std::stoi(pixels) : 100, std::stoi(mirrors)};
}

struct Place {
  const char* name;
  Transform to_world;  ///< Of the room [-1, 1]^3.
  Vec3 eye;            ///< Within it.
};

Transform placed(const Transform& turn, const Vec3& scale, const Vec3& at) {
  Transform t = turn;
  for (std::size_t row = 0; row < 3; ++row) {
    t.m.at(row)[0] *= scale.x;
    t.m.at(row)[1] *= scale.y;
    t.m.at(row)[2] *= scale.z;
  }
  t.m[0][3] = at.x;
  t.m[1][3] = at.y;
  t.m[2][3] = at.z;
  return t;
}

std::vector<Place> places() {
  const Transform turn = rotation({1, 2, 0.5}, 37);
  return {{"around the eye", {}, {0, 0, 0}},
          {"turned", turn, {0.1, 0.2, -0.3}},
          {"turned, large, far off", placed(turn, {3, 3, 3}, {1e6, -1e6, 5e5}), {0.3, 0.1, 0.2}},
          {"a hall", placed({}, {100, 1, 30}, {0, 0, 0}), {0.9, 0.2, 0.1}}};
}

const std::array<std::array<int, 4>, 6> faces{
    {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};

Vec3 corner(int i) { return {(i & 1) != 0 ? 1. : -1., (i & 2) != 0 ? 1. : -1., (i & 4) != 0 ? 1. : -1.}; }

Geometry mesh_room(const Transform& t) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back(t.point(corner(i)));
  for (const auto& face : faces) {
    mesh.triangles.push_back({face[0], face[1], face[2]});
    mesh.triangles.push_back({face[0], face[2], face[3]});
  }
  return mesh;
}

/// walls: 6, or fewer for a room that is open.
std::vector<Geometry> rectangles_room(const Transform& t, std::size_t walls) {
  std::vector<Geometry> room;
  for (std::size_t i = 0; i < walls; ++i) {
    const Vec3 a = t.point(corner(faces.at(i)[0]));
    room.emplace_back(Rectangle{a, t.point(corner(faces.at(i)[1])) - a, t.point(corner(faces.at(i)[3])) - a});
  }
  return room;
}

Scene scene_of(const std::vector<Geometry>& room, const Place& place, const Count& count) {
  Scene scene;
  const int mirror = add(scene, Conductor{}, true);
  for (const Geometry& wall : room) add(scene, wall, mirror);
  add(scene, ConstantLight{});
  scene.camera = perspective_camera(place.to_world.point(place.eye), place.to_world.point({0, 0, -1}), {0, 1, 0}, 90);
  scene.film.width = scene.film.height = count.pixels;
  scene.sampler.kind = SamplerKind::centre;
  scene.sampler.sample_count = 1;
  scene.integrator.name = "whitted";
  scene.integrator.max_depth = count.mirrors + 1;
  return scene;
}

/// Pixels that are not black.
std::size_t escaped(const Scene& scene, Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  settings.work_group = {4, 1};  // A launch of long paths has few pixels: some for every core.
  return lit_pixels(render("pocl", scene, settings).color);
}

void require_closed(const std::vector<Geometry>& room, const Place& place) {
  for (const Precision precision : asked_tiers()) {
    INFO(place.name << ", " << precision_name(precision));
    CHECK(escaped(scene_of(room, place, asked_for()), precision) == 0);
  }
}

TEST_CASE("a cube") {
  require_pocl();
  for (const Place& place : places()) {
    const Vec3 a = place.to_world.point({-1, -1, -1});
    const auto edge = [&](const Vec3& to) { return place.to_world.point(to) - a; };
    require_closed({Cube{a, {edge({1, -1, -1}), edge({-1, 1, -1}), edge({-1, -1, 1})}}}, place);
  }
}

TEST_CASE("six rectangles", "[slow]") {
  require_pocl();
  for (const Place& place : places()) require_closed(rectangles_room(place.to_world, 6), place);
}

TEST_CASE("twelve triangles") {
  require_pocl();
  for (const Place& place : places()) require_closed({mesh_room(place.to_world)}, place);
}

TEST_CASE("a box") {
  require_pocl();
  require_closed({Box{{-1, -1, -1}, {1, 1, 1}}}, {"around the eye", {}, {0, 0, 0}});
  const Place off{"large, far off", placed({}, {3, 3, 3}, {1e6, -1e6, 5e5}), {0.3, 0.1, 0.2}};
  require_closed({Box{off.to_world.point({-1, -1, -1}), off.to_world.point({1, 1, 1})}}, off);
}

TEST_CASE("ten thousand rays, ten thousand mirrors") {
  require_pocl();
  const Place place = places()[1];
  CHECK(escaped(scene_of(rectangles_room(place.to_world, 6), place, {100, 10000}), Precision::robust) == 0);
}

TEST_CASE("rays are reflected as often as is asked for, and an open room is lit") {
  require_pocl();
  const Place place = places()[1];
  RenderSettings settings;
  settings.count_rays = true;
  const Scene closed = scene_of(rectangles_room(place.to_world, 6), place, {8, 100});
  CHECK(render("pocl", closed, settings).stats.bounce_rays == 8 * 8 * 100);
  CHECK(escaped(scene_of(rectangles_room(place.to_world, 5), place, {8, 100}), Precision::robust) == 8 * 8);
}

TEST_CASE("glass among mirrors: rays that split without an end are counted and told") {
  require_pocl();
  const Place place{"around the eye", {}, {0, 0, 0.8}};
  RenderSettings settings;
  settings.count_rays = true;
  Dielectric glass;
  glass.int_ior = 1.5;
  constexpr std::uint64_t pixels = 4, rays = layout::WHITTED_MOST_RAYS, longest = layout::WHITTED_LONGEST;
  for (const std::size_t walls : {6U, 1U}) {
    Scene scene = scene_of(rectangles_room(place.to_world, walls), place, {2, 0});
    scene.integrator.max_depth = -1;
    add(scene, Sphere{{0, 0, 0}, 0.5}, add(scene, glass, false));
    const RunStats stats = render("pocl", scene, settings).stats;
    CHECK((stats.unusual.lost_branches > 0) == (walls == 6));
    CHECK(stats.unusual.weak_branches > 0);
    CHECK(*stats.bounce_rays < pixels * (rays + 22 * longest));
    if (walls == 6) CHECK(*stats.bounce_rays > rays);
  }
}

}  // namespace
}  // namespace strahl::test
