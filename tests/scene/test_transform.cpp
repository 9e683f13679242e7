// SPDX-License-Identifier: MIT
// <transform> against closed forms and against matrices that Mitsuba 3.9.1 printed for the same text.
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/model/transforms.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Transform to_world(const std::string& steps) {
  return load_text("<scene version=\"3.0.0\"><sensor type=\"orthographic\"><transform name=\"to_world\">" + steps +
                   "</transform></sensor></scene>")
      .scene.camera.world_from_camera;
}

void check_matrix(const Transform& t, const std::array<std::array<double, 4>, 3>& expected, double tolerance) {
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      INFO("row " << row << " column " << column);
      CHECK(t.m[row][column] == Approx(expected[row][column]).margin(tolerance));
    }
}

}  // namespace

TEST_CASE("both attribute forms") {
  const Transform expected{{{{1, 0, 0, 1}, {0, 1, 0, -2}, {0, 0, 1, 0.5}}}};
  CHECK(to_world("<translate x=\"1\" y=\"-2\" z=\".5\"/>").m == expected.m);
  CHECK(to_world("<translate value=\"1, -2, +0.5\"/>").m == expected.m);
  CHECK(to_world("<translate value=\" 1 -2\n5e-1 \"/>").m == expected.m);
  CHECK(to_world("<translate y=\"-2\"/>").translation() == Vec3{0, -2, 0});
  CHECK(to_world("<scale value=\"3\"/>").determinant() == 27);
  CHECK(to_world("<scale y=\"3\"/>").determinant() == 3);
}

TEST_CASE("each step is applied after those before it") {
  CHECK(to_world("<scale value=\"2\"/><translate x=\"1\"/>").point({1, 1, 1}) == Vec3{3, 2, 2});
  CHECK(to_world("<translate x=\"1\"/><scale value=\"2\"/>").point({1, 1, 1}) == Vec3{4, 2, 2});
}

TEST_CASE("quarter turns are exact") {
  CHECK(to_world("<rotate x=\"1\" angle=\"90\"/>").point({1, 2, 3}) == Vec3{1, -3, 2});
  CHECK(to_world("<rotate y=\"1\" angle=\"-90\"/>").point({1, 2, 3}) == Vec3{-3, 2, 1});
  CHECK(to_world("<rotate value=\"0 0 5\" angle=\"540\"/>").point({1, 2, 3}) == Vec3{-1, -2, 3});
}

TEST_CASE("a rotation is one, whatever the length of its axis") {
  const Transform t = to_world("<rotate x=\"1\" y=\"2\" z=\"3\" angle=\"30\"/>");
  CHECK(length(t.vector({1, 2, 3}) - Vec3{1, 2, 3}) < 1e-15);
  CHECK(t.determinant() == Approx(1).epsilon(1e-14));
  CHECK(dot(t.vector({3, 0, -1}), {3, 0, -1}) == Approx(10 * std::cos(std::acos(-1) / 6)).epsilon(1e-14));
}

TEST_CASE("as Mitsuba: lookat") {
  check_matrix(
      to_world("<lookat origin=\"1,2,3\" target=\"4,1,-2\" up=\"0,1,0\"/>"),
      {{{-0.857493, 0.0869657, 0.507093, 1}, {0, 0.985611, -0.169031, 2}, {-0.514496, -0.144943, -0.845154, 3}}}, 1e-6);
  check_matrix(
      to_world("<lookat origin=\"0,0,0\" target=\"0.3,1,0.2\"/>"),
      {{{0.223447, 0.932966, 0.282216, 0}, {-0.255178, -0.223447, 0.940721, 0}, {0.940721, -0.282216, 0.188144, 0}}},
      1e-6);
}

TEST_CASE("as Mitsuba: no up, and steps that change nothing") {
  const Transform any = to_world("<lookat origin=\"0,0,0\" target=\"0.3,1,0.2\"/>");
  for (const char* up : {"0 0 0", ""})
    CHECK(to_world("<lookat origin=\"0,0,0\" target=\"0.3,1,0.2\" up=\"" + std::string(up) + "\"/>").m == any.m);
  CHECK(to_world("<translate/><scale/>").m == Transform{}.m);
}

TEST_CASE("an axis that is no unit vector: what Mitsuba would do with it is said") {
  const auto said = [](const std::string& rotate) {
    return problems("<scene version=\"3.0.0\"><sensor type=\"orthographic\"><transform name=\"to_world\">" + rotate +
                    "</transform></sensor></scene>");
  };
  // c I + (1 - c) a a^T + s [a]_x with |a| = 2 and 90 degrees: 4 along the axis, a turn of 90 degrees and 2 across.
  const std::vector<std::string> warnings = said("<rotate z=\"2\" angle=\"90\"/>");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].rfind("1:", 0) == 0);
  for (const char* part :
       {": warning: ", "has length 2;", "turns by 90 degrees and scales by 4 along the axis, 2 across"})
    CHECK(warnings[0].find(part) != std::string::npos);
  // Half a unit and 60 degrees: tan' = 0.5 tan 60.
  const std::vector<std::string> shorter = said("<rotate x=\"0.5\" angle=\"60\"/>");
  REQUIRE(shorter.size() == 1);
  CHECK(shorter[0].find("turns by 40.89 degrees and scales by 0.625 along the axis, 0.6614 across") !=
        std::string::npos);
  // What is a unit vector as well as three decimals say it, and a turn that is none.
  CHECK(said("<rotate value=\"0.577 0.577 0.577\" angle=\"30\"/>").empty());
  CHECK(said("<rotate value=\"0.707 0.707 0\" angle=\"30\"/>").empty());
  CHECK(said("<rotate y=\"5\" angle=\"720\"/>").empty());
  CHECK(said("<rotate value=\"0.58 0.58 0.58\" angle=\"30\"/>").size() == 1);
}

TEST_CASE("matrices of 9 and 16 values") {
  const Transform expected{{{{1, 2, 3, 0}, {0, 1, 4, 0}, {5, 6, 0, 0}}}};
  CHECK(to_world("<matrix value=\"1 2 3 0 1 4 5 6 0\"/>").m == expected.m);
  CHECK(to_world("<matrix value=\"1 2 3 7 0 1 4 8 5 6 0 9 0 0 0 1\"/>").translation() == Vec3{7, 8, 9});
}

TEST_CASE("the largest stretch of a map") {
  const Transform turn = rotation({1, -2, 0.5}, 37);
  const auto scaled = [&](double x, double y, double z) {
    Transform map = turn;
    for (auto& row : map.m) {
      row[0] *= x;
      row[1] *= y;
      row[2] *= z;
    }
    return map;
  };
  CHECK(largest_stretch(scaled(1, 1, 1)) == Approx(1).epsilon(1e-7));
  CHECK(largest_stretch(scaled(3e-20, 3e-20, 3e-20)) == Approx(3e-20).epsilon(1e-7));
  CHECK(largest_stretch(scaled(50, -50, 1)) == Approx(50).epsilon(1e-7));
  CHECK(largest_stretch(scaled(1, 1e-3, 2)) == Approx(2).epsilon(1e-7));
  CHECK(largest_stretch(scaled(7e30, 1, 1)) == Approx(7e30).epsilon(1e-7));
  // A shear of 1: the golden ratio.
  CHECK(largest_stretch(Transform{{{{1, 1, 0, 4}, {0, 1, 0, 5}, {0, 0, 1, 6}}}}) == Approx((1 + std::sqrt(5.0)) / 2));
}

TEST_CASE("the nearest axes are perpendicular, and as far from these on either side") {
  const Transform turned = rotation({1, 2, -3}, 77);
  // Along one line and across it: a symmetric factor, which the decomposition takes off.
  for (const double mirrored : {1.0, -1.0}) {
    std::array<Vec3, 3> given, wanted;
    for (std::size_t i = 0; i < 3; ++i) {
      wanted[i] = mirrored * turned.column(static_cast<int>(i));
      const Vec3 line = normalized({3, -1, 2});
      given[i] = wanted[i] + (4e-4 * dot(line, wanted[i])) * line;
    }
    const auto found = nearest_axes(given);
    REQUIRE(found);
    for (std::size_t i = 0; i < 3; ++i) CHECK(length((*found)[i] - wanted[i]) < 1e-15);
  }
  CHECK(nearest_axes({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) ==
        std::array{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}});
  CHECK_FALSE(nearest_axes({Vec3{1, 0, 0}, Vec3{2e-3, 1, 0}, Vec3{0, 0, 1}}));
  CHECK_FALSE(nearest_axes({Vec3{}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}));
}
