// SPDX-License-Identifier: MIT
// SPD's balls.c: the nine directions are three triples about an axis; every ball turns them from z to where it points.
#include <cmath>
#include <numbers>

#include "study/generated/scenes.h"
#include "study/generated/stage.h"

namespace strahl {
namespace {

/// v turned about the unit `axis` (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& axis, double sine, double cosine) {
  return cosine * v + sine * cross(axis, v) + ((1 - cosine) * dot(axis, v)) * axis;
}

std::vector<Vec3> nine_directions() {
  const double d = 1 / std::numbers::sqrt2;
  const Vec3 axis = normalized({1, -1, 0});
  // The rows are multiplied from the left there: the turn goes the other way.
  const double sine = 2 / std::sqrt(6.0), cosine = std::sqrt(1 - sine * sine);
  std::vector<Vec3> directions;
  for (int i = 0; i < 3; ++i)
    for (const Vec3& v : {Vec3{d, d, 0}, Vec3{d, 0, -d}, Vec3{0, d, -d}}) {
      const double angle = 2 * std::numbers::pi * i / 3;
      directions.push_back(turned(turned(v, axis, sine, cosine), {0, 0, 1}, std::sin(angle), std::cos(angle)));
    }
  return directions;
}

struct Flake {
  std::vector<Vec3> directions = nine_directions();
  std::vector<Shape>& shapes;

  void grow(int depth, const Vec3& center, const Vec3& direction, double radius) {
    shapes.emplace_back().geometry = Sphere{to_float(center), static_cast<double>(static_cast<float>(radius))};
    if (depth == 0) return;
    Vec3 axis = cross({0, 0, 1}, direction);
    double sine = length(axis);
    if (sine > 0x1p-20) {
      axis = normalized(axis);
    } else {  // SPD turns what points straight down about y; the axis of such a sine is rounding.
      sine = 0;
      axis = {0, 1, 0};
    }
    for (const Vec3& one : directions) {
      const Vec3 out = turned(one, axis, sine, direction.z);
      grow(depth - 1, center + (radius + radius / 3) * out, out, radius / 3);
    }
  }
};

}  // namespace

Scene sphereflake(int depth) {
  Scene scene = stage("sphereflake-" + std::to_string(depth), {2.1, 1.3, 1.7}, {}, {0, 0, 1}, 45, {4, 3, 2});
  scene.shapes.emplace_back().geometry = Rectangle{{-12, -12, -0.5}, {24, 0, 0}, {0, 24, 0}};
  Flake{.shapes = scene.shapes}.grow(depth, {}, {0, 0, 1}, 0.5);
  return scene;
}

}  // namespace strahl
