// SPDX-License-Identifier: MIT
#include "device/uv_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace strahl {
namespace {

/// Of the weights of two edges: one over the heights of the parallelogram that they span.
Vec2 rates_of_edges(const Vec3& u, const Vec3& v) {
  const double area = length(cross(u, v));
  return area > 0 ? Vec2{length(v) / area, length(u) / area} : Vec2{};
}

Vec2 larger(const Vec2& a, const Vec2& b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

Vec2 rates_of_mesh(const Mesh& mesh) {
  double u = 0, v = 0, count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const Vec2 edges =
        rates_of_edges(mesh.positions[at(b)] - mesh.positions[at(a)], mesh.positions[at(c)] - mesh.positions[at(a)]);
    Vec2 along_b{1, 0}, along_c{0, 1};
    if (!mesh.uvs.empty()) {
      along_b = {mesh.uvs[at(b)].x - mesh.uvs[at(a)].x, mesh.uvs[at(b)].y - mesh.uvs[at(a)].y};
      along_c = {mesh.uvs[at(c)].x - mesh.uvs[at(a)].x, mesh.uvs[at(c)].y - mesh.uvs[at(a)].y};
    }
    u += std::hypot(along_b.x * edges.x, along_c.x * edges.y);
    v += std::hypot(along_b.y * edges.x, along_c.y * edges.y);
    ++count;
  }
  return count > 0 ? Vec2{u / count, v / count} : Vec2{};
}

struct Rates {
  static constexpr double turn = 2 * std::numbers::pi;

  Vec2 operator()(const Sphere& s) const { return {1 / (turn * s.radius), 2 / (turn * s.radius)}; }
  Vec2 operator()(const Plane& p) const { return rates_of_edges(p.u, p.v); }
  Vec2 operator()(const Box&) const { return {}; }
  Vec2 operator()(const Triangle& t) const { return rates_of_edges(t.p1 - t.p0, t.p2 - t.p0); }
  Vec2 operator()(const Rectangle& r) const { return rates_of_edges(r.edge_u, r.edge_v); }
  Vec2 operator()(const Cube& c) const {
    Vec2 rates;
    for (unsigned i = 0; i < 3; ++i)
      rates = larger(rates, rates_of_edges(c.edge.at((i + 1) % 3), c.edge.at((i + 2) % 3)));
    const double largest = std::max(rates.x, rates.y);
    return {largest, largest};
  }
  Vec2 operator()(const Disk& d) const { return {1 / length(d.axis_u), 1 / (turn * length(d.axis_u))}; }
  Vec2 operator()(const Cylinder& c) const { return {1 / (turn * c.radius), 1 / length(c.p1 - c.p0)}; }
  Vec2 operator()(const Mesh& mesh) const { return rates_of_mesh(mesh); }
  /// The mean, as a mesh's triangles.
  Vec2 operator()(const SphereCloud& cloud) const {
    double sum = 0;
    for (const auto& [center, radius] : cloud.spheres) sum += 1 / (turn * radius);
    const double u = sum / static_cast<double>(cloud.spheres.size());
    return {u, 2 * u};
  }
};

/// Finite also in single precision: a shape thinner than its numbers has no filter worth the name.
double usable(double rate) {
  const double most = std::numeric_limits<float>::max();
  return rate > 0 ? std::min(rate, most) : 0;
}

}  // namespace

Vec2 uv_rates(const Geometry& geometry, const Frame& frame) {
  const Vec2 rates = std::visit(Rates{}, geometry);
  return {usable(rates.x / frame.scale), usable(rates.y / frame.scale)};
}

}  // namespace strahl
