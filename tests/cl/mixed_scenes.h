// SPDX-License-Identifier: MIT
// Scenes with many primitives of every kind, so that every width has several blocks and a padded last one; some are
// there twice or three times, so that the smallest id must win. And rays at their insides, edges and vertices.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "oracle/generators.h"
#include "render/intersector.h"
#include "scene/model/scene.h"
#include "selftest/questions.h"
#include "selftest/shape_proof.h"

namespace strahl::test {

/// "sphere", "plane", ...: every alternative of Geometry but clouds, whose primitives are the sphere's.
inline const std::vector<std::string>& geometry_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (std::string name : {
#define SHAPE_KIND(S, kind, area, types) #S,
#include "kinds/shapes.def"
#undef SHAPE_KIND
         }) {
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
      if (name != "spherecloud") all.push_back(name);
    }
    return all;
  }();
  return names;
}

class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : random_(seed) { scene_.materials.emplace_back(); }

  /// Every third is repeated at once, every fifth at the end, after all others.
  void add(const std::string& name, int count) {
    std::vector<Geometry> again;
    for (int i = 0; i < count; ++i) {
      const Geometry geometry = make(name);
      put(geometry);
      if (i % 3 == 0) put(geometry);
      if (i % 5 == 0) again.push_back(geometry);
    }
    for (const Geometry& geometry : again) put(geometry);
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// At random points of the shapes, at their corners and centres; along axes now and then; from anywhere.
  [[nodiscard]] std::vector<Ray> rays(std::size_t count) {
    std::vector<Ray> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
      Ray& ray = rays[i];
      const Vec3 target = targets_[random_.bits() % targets_.size()];
      const Vec3 wanted = i % 4 == 0 ? target + random_.uniform(0, 0.5) * direction() : target;
      ray.origin = i % 7 == 0 ? wanted : rounded(random_.uniform(0, 30) * direction());
      ray.direction = wanted - ray.origin;
      if (i % 7 == 0 || i % 11 == 0) ray.direction = axis_direction();
      if (i % 11 == 0) ray.origin = wanted - random_.integer(1, 8) * ray.direction;
      if (i % 5 == 0) ray.direction = std::ldexp(1.0, random_.integer(-30, 30)) * ray.direction;
      if (i % 9 == 0) ray.t_max = random_.uniform(0.5, 1.5);
      if (i % 10 == 0) ray.t_min = random_.uniform(0, 1.1);
      if (length(ray.direction) == 0) ray.direction = direction();
    }
    return rays;
  }

 private:
  void put(const Geometry& geometry) {
    Shape& shape = scene_.shapes.emplace_back();
    shape.geometry = geometry;
    shape.flip_normals = scene_.shapes.size() % 3 == 0;
  }

  // To the quarter: exact in float, so that edges and faces coincide to the bit.
  static Vec3 rounded(const Vec3& p) {
    const auto quarter = [](double x) { return std::nearbyint(4 * x) / 4; };
    return {quarter(p.x), quarter(p.y), quarter(p.z)};
  }
  Vec3 direction() { return {random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)}; }
  Vec3 axis_direction() {
    const double zero = random_.sign() * 0.0, one = random_.sign();
    const int axis = random_.integer(0, 2);
    return {axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
  }
  Vec3 target(const Vec3& p) {
    targets_.push_back(p);
    return p;
  }
  Vec3 place() { return target(rounded(20 * direction())); }
  Vec3 edge() {
    for (;;)
      if (const Vec3 e = rounded(4 * direction()); length(e) > 0.5) return e;
  }

  Geometry make(const std::string& name) {
    const Vec3 at = place(), u = edge(), n = normalized(u);
    const auto [across, along] = orthonormal_basis(n);
    Vec3 v = edge();
    while (length(cross(u, v)) < 0.5) v = edge();
    const double radius = random_.integer(1, 8) / 4.0;
    if (name == "sphere") {
      Sphere s;
      s.center = at;
      s.radius = radius;
      s.frame = {across, along, n};
      target(at + radius * across);
      return s;
    }
    if (name == "plane")
      return random_.integer(0, 1) ? Plane{at, cross(u, v), u, v} : Plane{at, {0, 0, 3}, {1, 0, 0}, {3, -1, 0}};
    if (name == "box") {
      const Vec3 size{std::fabs(u.x), std::fabs(u.y), std::fabs(u.z)};
      target(at + size);
      target(at + 0.5 * size);
      return Box{at, at + size};
    }
    if (name == "disk") {
      target(at + radius * across);
      return Disk{at, radius * across, radius * along};
    }
    if (name == "cylinder") {
      target(at + 0.5 * u + radius * across);
      target(at + radius * along);
      return Cylinder{at, at + u, radius, across};
    }
    target(at + 0.25 * u + 0.25 * v);
    target(at + 0.5 * u);
    target(at + u);
    target(at + v);
    if (name == "triangle") return Triangle{at, at + u, at + v};
    if (name == "rectangle") return Rectangle{at, u, v};
    const Vec3 w = rounded(2 * cross(u, v));
    if (name == "cube") return Cube{at, {u, v, w}};
    if (name != "mesh") return drawn(name);
    // A pyramid without its base and a triangle without area.
    Mesh mesh;
    mesh.positions = {at, at + u, at + u + v, at + v, target(at + 0.5 * w)};
    mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 1, 1}};
    return mesh;
  }

  /// Of a kind that no lines above know: as its proof draws it.
  Geometry drawn(const std::string& name) {
    const selftest::Question q = selftest::draw_question(name, oracle::Law::aimed, random_);
    if (q.expected == selftest::Expected::hit) target(q.ray.origin + q.t.value * q.ray.direction);
    return selftest::proof_of(name).geometry(q.planes.data());
  }

  oracle::Random random_;
  Scene scene_;
  std::vector<Vec3> targets_;
};

}  // namespace strahl::test
