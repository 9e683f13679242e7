// SPDX-License-Identifier: MIT
// Where rays leave a surface (cl/hits/departure.h), in float: not far from the point found, off every edge that a
// neighbour may share, on the side that the ray goes to; where nothing touches, exactly at the point.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "cl/host_features.h"

#define REAL_BITS 32
namespace f32 {
#include "math/vec3.h"
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the rest is written in.
#include "math/vec3_lanes.h"
// As above.
#include "rays/departing_lanes.h"
// As above.
#include "hits/surfaces_lanes.h"
}  // namespace f32

namespace {

using f32::real3;
constexpr double u = 0x1p-24;

struct Wide {
  double x, y, z;
};
Wide wide(const real3& a) { return {a.x, a.y, a.z}; }
Wide operator-(const Wide& a, const Wide& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Wide& a, const Wide& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Wide cross(const Wide& a, const Wide& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Wide& a) { return std::sqrt(dot(a, a)); }
double largest(const Wide& a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }
double ulp(double x) { return std::ldexp(1.0, std::ilogb(x) - 23); }

f32::Surface in_no_instance() {
  f32::Surface s{};
  s.instance = -1;
  return s;
}

/// The ray that leaves s towards d.
f32::Ray leaving(const f32::Surface& s, int id, real3 d) {
  f32::Surfaces_w_1 surfaces = f32::surfaces_none_w_1();
  f32::surface_to_w_1(&surfaces, 0, &s, id, 1);
  f32::Rays_w_1 rays;
  f32::rays_leaving_w_1(&surfaces, -1, d, 1, &rays);
  return f32::ray_of_w_1(&rays, 0);
}

class Random {
 public:
  float symmetric() { return static_cast<float>(uniform_(engine_) * 2 - 1); }
  double unit() { return uniform_(engine_); }
  real3 vector(float size) { return f32::vec3(size * symmetric(), size * symmetric(), size * symmetric()); }
  /// In [0, 1], every other time within rounding of an end.
  float weight() {
    const double near = std::ldexp(unit(), -20 - static_cast<int>(engine_() % 8));
    const auto kind = engine_() % 4;
    return static_cast<float>(kind == 0 ? near : kind == 1 ? 1 - near : unit());
  }

 private:
  std::mt19937 engine_{11};
  std::uniform_real_distribution<double> uniform_;
};

/// A polygon as a block of width 1, and a point of it as its surface function computes it.
struct Polygon {
  std::array<float, 12> prim;
  int corners;
  f32::Surface s = in_no_instance();

  [[nodiscard]] Wide corner(int i) const {
    const auto at = static_cast<std::size_t>(3 * (i % corners));
    return {prim[at], prim[at + 1], prim[at + 2]};
  }
};

void put(Polygon& polygon, int i, const real3& p) {
  const auto at = static_cast<std::size_t>(3 * i);
  polygon.prim[at] = p.x;
  polygon.prim[at + 1] = p.y;
  polygon.prim[at + 2] = p.z;
}

void draw(Polygon& polygon, Random& random, int corners) {
  const float size = std::ldexp(1.0F, static_cast<int>(random.unit() * 40) - 20);
  const float offset = random.unit() < 0.5 ? size : size * std::ldexp(1.0F, static_cast<int>(random.unit() * 16));
  const real3 a = random.vector(offset), e = random.vector(size);
  real3 f = random.vector(size);
  if (corners == 4) f = f32::scale3(size, f32::normalize3(f32::cross3(e, f)));
  polygon.corners = corners;
  put(polygon, 0, a);
  put(polygon, 1, f32::add3(a, e));
  put(polygon, 2, corners == 3 ? f32::add3(a, f) : f32::add3(f32::add3(a, e), f));
  if (corners == 4) put(polygon, 3, f32::add3(a, f));
  float v = random.weight(), w = random.weight();
  if (corners == 3 && v + w > 1) v = 1 - v, w = 1 - w;
  const real3 b = f32::corner_load(polygon.prim.data(), 1, 1);
  const real3 c = f32::corner_load(polygon.prim.data(), 1, corners - 1);
  const real3 e1 = f32::sub3(b, a), e2 = f32::sub3(c, a);
  polygon.s = in_no_instance();
  polygon.s.position = f32::add3(f32::fma3(v, e1, f32::scale3(w, e2)), a);
  polygon.s.normal = f32::normalize3(f32::cross3(e1, e2));
  if (random.unit() < 0.5) polygon.s.normal = f32::negate3(polygon.s.normal);
  polygon.s.outline = corners == 3 ? f32::OUTLINE_TRIANGLE : f32::OUTLINE_PARALLELOGRAM;
  polygon.s.prim = polygon.prim.data();
  polygon.s.stride = 1;
}

TEST_CASE("polygons: near the point, off the edges, on the ray's side") {
  Random random;
  Polygon polygon{};
  int moved_in = 0, behind = 0, cases = 0;
  double farthest = 0;
  for (int i = 0; i < 400000; ++i) {
    draw(polygon, random, 3 + i % 2);
    const int corners = polygon.corners;
    const Wide a = polygon.corner(0), n = cross(polygon.corner(1) - a, polygon.corner(corners - 1) - a);
    const double size = std::max(largest(polygon.corner(1) - a), largest(polygon.corner(corners - 1) - a));
    const double m = largest(wide(polygon.s.position)), bound = 1.75 * u * (m + size);
    // Slender ones have no room; sharp corners would take a longer way than is allowed.
    bool is_plain = true;
    for (int k = 0; k < corners; ++k) {
      const Wide e = polygon.corner(k + 1) - polygon.corner(k), f = polygon.corner(k + corners - 1) - polygon.corner(k);
      is_plain = is_plain && length(e) > 64 * bound && length(cross(e, f)) > 0.6 * length(e) * length(f);
    }
    if (!is_plain) continue;
    const real3 d = random.vector(1);
    const Wide o = wide(leaving(polygon.s, -1, d).o), p = wide(polygon.s.position);
    const double allowed = 4 * ulp(m) + 4 * u * size;
    farthest = std::max(farthest, largest(o - p) / allowed);

    const double side = dot(n, wide(d)) < 0 ? -1 : 1;
    // Points found and left are each rounded in three coordinates: of slanted polygons far off, a few stay behind.
    const double beyond = side * dot(n, o - a) / length(n);
    REQUIRE(beyond > -bound / 2);
    ++cases;
    behind += beyond <= 0 ? 1 : 0;
    for (int k = 0; k < corners; ++k) {
      const Wide from = polygon.corner(k), edge = polygon.corner(k + 1) - from;
      const Wide inward = cross(n, edge);
      const double before = dot(inward, p - from) / length(inward), after = dot(inward, o - from) / length(inward);
      moved_in += before < bound / 8 ? 1 : 0;
      // Where edges meet at an acute angle the way that is allowed does not lead off both by all of the rounding.
      REQUIRE(after > (corners == 4 ? 0 : -bound / 2));
    }
  }
  CHECK(farthest <= 1);
  CHECK(farthest > 0.5);
  CHECK(behind < cases / 1000);
  CHECK(moved_in > 5000);
}

/// A corner of the line through `near` with the direction `along`, in the plane z = height.
real3 on_line(const std::array<float, 2>& near, const std::array<float, 2>& along, float by, float height) {
  return f32::vec3(near[0] + by * along[0], near[1] + by * along[1], height);
}

TEST_CASE("near points of large polygons: off an edge by their own rounding, not by the corners'") {
  Random random;
  int moved_in = 0;
  double farthest = 0, nearest = 1;
  for (int i = 0; i < 100000; ++i) {
    // An edge at an angle, some units beside the origin; the third corner on either side of it.
    const float size = std::ldexp(1.0F, 10 + static_cast<int>(random.unit() * 20)), height = 3 * random.symmetric();
    const float turn = 3.2F * random.symmetric();
    const std::array<float, 2> near{3 * random.symmetric(), 3 * random.symmetric()},
        along{std::cos(turn), std::sin(turn)};
    Polygon polygon{{}, 3};
    put(polygon, 0, on_line(near, along, -size * (1 + std::fabs(random.symmetric())), height));
    put(polygon, 1, on_line(near, along, size * (1 + std::fabs(random.symmetric())), height));
    put(polygon, 2, on_line(near, {-along[1], along[0]}, random.unit() < 0.5 ? size : -size, height));
    f32::Surface& s = polygon.s;
    s.outline = f32::OUTLINE_TRIANGLE;
    s.prim = polygon.prim.data();
    s.stride = 1;
    s.normal = f32::vec3(0, 0, random.unit() < 0.5 ? 1.0F : -1.0F);
    // A point within some roundings of the edge, or anywhere near.
    const Wide from = polygon.corner(0), edge = polygon.corner(1) - from;
    const Wide across{-edge.y / length(edge), edge.x / length(edge), 0};
    const double over = -dot(across, from) + dot(across, wide(f32::vec3(0, 0, 0)));
    const double shift = -over + (i % 2 == 0 ? 1e-5 : 4) * random.symmetric(), slide = 4 * random.symmetric();
    s.position = f32::vec3(static_cast<float>(across.x * shift + across.y * slide),
                           static_cast<float>(across.y * shift - across.x * slide), height);
    const double m = largest(wide(s.position));
    s.off = static_cast<float>(4 * u * m);
    const Wide o = wide(leaving(s, -1, random.vector(1)).o), p = wide(s.position);
    const double inward = dot(across, polygon.corner(2) - from) < 0 ? -1 : 1;
    const double before = inward * dot(across, p - from), after = inward * dot(across, o - from);
    if (before < -64 * u * m) continue;  // Not a point of the polygon.
    moved_in += before < 0 ? 1 : 0;
    farthest = std::max(farthest, largest(o - p) / (u * m));
    nearest = std::min(nearest, after / (u * m));
  }
  CAPTURE(farthest, nearest);
  CHECK(farthest < 128);
  CHECK(nearest > 0);
  CHECK(moved_in > 1000);
}

TEST_CASE("boxes: the face's coordinate stays, the others lie strictly between the faces") {
  Random random;
  for (int i = 0; i < 100000; ++i) {
    const float size = std::ldexp(1.0F, static_cast<int>(random.unit() * 40) - 20);
    const real3 lo = random.vector(size * std::ldexp(1.0F, static_cast<int>(random.unit() * 12)));
    const real3 hi = f32::add3(lo, f32::abs3(random.vector(size)));
    const std::array<float, 6> prim{lo.x, hi.x, lo.y, hi.y, lo.z, hi.z};
    f32::Surface s = in_no_instance();
    s.outline = f32::OUTLINE_BOX;
    s.prim = prim.data();
    s.stride = 1;
    s.normal = f32::vec3(-1, 0, 0);
    s.position = f32::vec3(lo.x, lo.y + random.weight() * (hi.y - lo.y), lo.z + random.weight() * (hi.z - lo.z));
    const real3 o = leaving(s, -1, random.vector(1)).o;
    CHECK(o.x == lo.x);
    const auto check = [&](float from, float before, float low, float high) {
      const double m = std::max(std::fabs(low), std::fabs(high));
      if (high - low > 16 * u * (m + high - low)) REQUIRE((low < from && from < high));
      REQUIRE(std::fabs(double{from} - before) <= 4 * ulp(m) + 4 * u * (high - low));
    };
    check(o.y, s.position.y, lo.y, hi.y);
    check(o.z, s.position.z, lo.z, hi.z);
  }
}

TEST_CASE("where no neighbour touches, rays begin at the point found") {
  f32::Surface s = in_no_instance();
  s.position = f32::vec3(1.1F, -2.3F, 1e7F);
  const real3 o = leaving(s, 3, f32::vec3(0, 0, 1)).o;
  CHECK(o.x == s.position.x);
  CHECK(o.y == s.position.y);
  CHECK(o.z == s.position.z);
}

}  // namespace
