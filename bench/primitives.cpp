// SPDX-License-Identifier: MIT
#include "bench/primitives.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "oracle/oracle.h"
#include "oracle/random.h"
#include "program/kernel_source.h"
#include "selftest/questions.h"
#include "selftest/shape_proof.h"

namespace strahl::bench {
namespace {

using oracle::Random;
using Meets = std::function<bool(const oracle::Ray&)>;

/// A shape as the scene has it, and the oracle's word on it.
struct Drawn {
  Geometry geometry;
  Meets meets;
};

/// On a lattice of 2^-12, which float holds: every tier and the oracle see the same numbers.
double on_lattice(double x) { return std::round(x * 4096) / 4096; }

Vec3 point(Random& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach), z = random.uniform(-reach, reach);
  return {on_lattice(x), on_lattice(y), on_lattice(z)};
}

double size(Random& random) { return on_lattice(random.uniform(0.25, 0.75)); }

template <typename Shape, typename Answer>
Meets by(Answer answer, const Shape& shape) {
  return [=](const oracle::Ray& ray) { return answer(ray, shape, oracle::Arithmetic::filtered).hit; };
}

/// Of a kind that the lines below do not know.
Drawn by_proof(const std::string& kind, Random& random) {
  selftest::Question q = selftest::draw_question(kind, oracle::Law::aimed, random);
  const auto is_met = [q](const oracle::Ray& ray) mutable {
    q.ray = ray;
    return selftest::exact_answer(q).hit;
  };
  return {selftest::proof_of(kind).geometry(q.planes.data()), is_met};
}

Drawn draw(const std::string& name, Random& random) {
  const Vec3 at = point(random, 4);
  if (name == "sphere") {
    const double radius = size(random);
    return {Sphere{at, radius}, by(oracle::sphere, oracle::Sphere{at, radius})};
  }
  if (name == "plane") {
    const Vec3 normal = point(random, 1);
    const auto [u, v] = orthonormal_basis(normalized(normal));
    return {Plane{at, normal, u, v}, by(oracle::plane, oracle::Plane{at, normal})};
  }
  if (name == "box") {
    const Vec3 extent{size(random), size(random), size(random)};
    return {Box{at, at + extent}, by(oracle::aabb, oracle::Aabb{at, at + extent})};
  }
  if (name == "cylinder") {
    const Vec3 axis = point(random, 1);
    const double radius = size(random);
    return {Cylinder{at, at + axis, radius, orthonormal_basis(normalized(axis))[0]},
            by(oracle::cylinder, oracle::Cylinder{at, axis, radius})};
  }
  if (name == "disk") {
    const auto [u, v] = orthonormal_basis(normalized(point(random, 1)));
    const double radius = size(random);
    return {Disk{at, radius * u, radius * v}, by(oracle::disk, oracle::Disk{at, u, v, radius})};
  }
  if (name == "triangle" || name == "rectangle") {
    const Vec3 e = point(random, 1), f = point(random, 1);
    if (name == "triangle")
      return {Triangle{at, at + e, at + f}, by(oracle::triangle, oracle::Triangle{at, at + e, at + f})};
    return {Rectangle{at, e, f}, by(oracle::parallelogram, oracle::Parallelogram{at, e, f})};
  }
  return by_proof(name, random);
}

}  // namespace

const std::vector<std::string>& primitive_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> kinds = list_entries("shapes");
    std::replace(kinds.begin(), kinds.end(), std::string("parallelogram"), std::string("rectangle"));
    return kinds;
  }();
  return names;
}

Workload primitive_workload(const std::string& name, std::size_t rays) {
  const auto& names = primitive_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw UsageError(fmt::format("unknown primitive \"{}\"; known: {}", name, fmt::join(names, ", ")));
  Random random(4);
  Workload workload;
  workload.name = name;
  std::vector<Meets> meets;
  for (int i = 0; i < (name == "plane" ? 16 : 64); ++i) {
    Drawn drawn = draw(name, random);
    workload.scene.shapes.emplace_back().geometry = drawn.geometry;
    meets.push_back(std::move(drawn.meets));
  }
  for (std::size_t i = 0; i < rays; ++i) {
    Ray ray;
    ray.origin = point(random, 16);
    ray.direction = point(random, 5) - ray.origin;
    const oracle::Ray exact{ray.origin, ray.direction};
    workload.rays.push_back(ray);
    workload.hits.push_back(
        std::any_of(meets.begin(), meets.end(), [&exact](const Meets& is_met) { return is_met(exact); }));
  }
  return workload;
}

}  // namespace strahl::bench
