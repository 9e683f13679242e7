// SPDX-License-Identifier: MIT
// A ray that names the primitive it has left: not hit again where it was left, without any epsilon, at sizes from 10^-3
// to 10^3 and up to 10^3 away; but a quadric's other root and a box's far side are.
#include <catch2/catch.hpp>
#include <cmath>

#include "cl/host_tracer.h"
#include "selftest/closed_meshes.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

constexpr int shape_count = 40, rays_per_shape = 250;

/// Rays that have left a shape where an earlier ray hit it, each with the outward normal of that side; into every
/// direction, the grazing ones too.
struct Departure {
  Ray ray;
  Vec3 normal;
};

class Departures {
 public:
  explicit Departures(std::uint64_t seed) : random_(seed) {}

  double size = 1;
  Vec3 center;

  void next_shape() {
    size = std::fabs(random_.log_uniform(-3, 3));
    center = to_float(std::fabs(random_.log_uniform(-3, 3)) * direction());
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
      if (length(v) > 0.1 && length(v) <= 1) return normalized(v);
    }
  }
  /// A size times a factor, a float.
  double sized(double low, double high) { return to_float(size * random_.uniform(low, high)); }
  Vec3 sized_edge() { return to_float(sized(0.5, 1) * direction()); }

  template <class Real>
  std::vector<Departure> from(const HostTracer<Real>& tracer, const Vec3& around, double radius) {
    std::vector<Departure> departures;
    while (departures.size() < rays_per_shape) {
      Ray in;
      in.origin = to_float(around + 3 * radius * direction());
      in.direction = to_float(around + radius * random_.uniform(0, 1) * direction() - in.origin);
      const Hit hit = tracer.trace(in);
      if (hit.shape < 0) continue;
      Departure departure{{}, hit.normal};
      departure.ray.origin = to_float(in.origin + hit.t * in.direction);
      departure.ray.direction = to_float(direction());
      // Grazing one time in four, down to 10^-6.
      if (departures.size() % 4 == 0) {
        const Vec3 along = cross(hit.normal, direction());
        departure.ray.direction = to_float(along + random_.log_uniform(-6, -1) * hit.normal);
      }
      departure.ray.shape = hit.shape;
      departure.ray.primitive = hit.primitive;
      departures.push_back(departure);
    }
    return departures;
  }

 private:
  oracle::Random random_;
};

template <class Real>
HostTracer<Real> tracer_of(const Geometry& geometry) {
  Scene scene;
  scene.shapes.emplace_back().geometry = geometry;
  return HostTracer<Real>(scene, 8);
}

/// Every departure from `shape_count` shapes drawn by `draw`.
template <class Real, class Draw, class Check>
void over_departures(Draw draw, Check check) {
  Departures departures(9);
  for (int i = 0; i < shape_count; ++i) {
    departures.next_shape();
    const auto shape = draw(departures);
    const HostTracer<Real> tracer = tracer_of<Real>(shape);
    for (const Departure& departure : departures.from(tracer, departures.center, departures.size)) {
      INFO("size " << departures.size);
      check(shape, departure, tracer.trace(departure.ray));
    }
  }
}

template <class Real, class Draw>
void require_never_again(Draw draw) {
  int again = 0;
  over_departures<Real>(draw, [&](const auto&, const Departure&, const Hit& hit) { again += hit.shape >= 0; });
  CHECK(again == 0);
}

/// Roundoff of the tier, of the numbers that f = o - c is made of, relative to f.
template <class Real>
double doubt(const Departure& departure, double f) {
  return 8 * (sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53) * (1 + length(departure.ray.origin) / f);
}

}  // namespace

TEMPLATE_TEST_CASE("what is flat is never hit again", "", float, double) {
  require_never_again<TestType>([](Departures& d) { return Plane{d.center, d.sized_edge(), {1, 0, 0}, {0, 1, 0}}; });
  require_never_again<TestType>([](Departures& d) {
    return Triangle{to_float(d.center + d.sized_edge()), to_float(d.center + d.sized_edge()),
                    to_float(d.center - d.sized_edge())};
  });
  require_never_again<TestType>([](Departures& d) { return Rectangle{d.center, d.sized_edge(), d.sized_edge()}; });
  require_never_again<TestType>([](Departures& d) {
    const auto [u, v] = orthonormal_basis(d.direction());
    const double radius = d.sized(0.5, 1);
    return Disk{d.center, radius * u, radius * v};
  });
}

TEMPLATE_TEST_CASE("a sphere is hit again at the other root, exactly from within", "", float, double) {
  int inward = 0, outward = 0;
  over_departures<TestType>(
      [](Departures& d) {
        Sphere s;
        s.center = d.center;
        s.radius = d.sized(0.5, 1);
        return s;
      },
      [&](const Sphere& s, const Departure& departure, const Hit& hit) {
        const Vec3 f = departure.ray.origin - s.center, &d = departure.ray.direction;
        const double other = -2 * dot(f, d) / dot(d, d), cosine = dot(f, d) / (length(f) * length(d));
        if (std::fabs(cosine) < doubt<TestType>(departure, length(f))) return;
        REQUIRE((hit.shape >= 0) == (other > 0));
        ++(other > 0 ? inward : outward);
        if (other > 0)
          REQUIRE(std::fabs(hit.t - other) <= doubt<TestType>(departure, length(f)) * 2 * length(f) / length(d));
      });
  CHECK(inward > 1000);
  CHECK(outward > 1000);
}

TEMPLATE_TEST_CASE("a cylinder is hit again at the other root, if that lies between its ends", "", float, double) {
  int inward = 0, outward = 0, beyond = 0;
  over_departures<TestType>(
      [](Departures& d) {
        const Vec3 axis = d.sized_edge();
        return Cylinder{d.center, to_float(d.center + axis), d.sized(0.3, 0.5), orthonormal_basis(normalized(axis))[0]};
      },
      [&](const Cylinder& c, const Departure& departure, const Hit& hit) {
        const Vec3 axis = c.p1 - c.p0, u = normalized(axis), from = departure.ray.origin - c.p0;
        const Vec3 f = from - dot(from, u) * u, d = departure.ray.direction - dot(departure.ray.direction, u) * u;
        const double other = -2 * dot(f, d) / dot(d, d), cosine = dot(f, d) / (length(f) * length(d));
        const double slack = doubt<TestType>(departure, length(f)) * length(departure.ray.direction) / length(d);
        if (!(std::fabs(cosine) >= slack)) return;
        const double place = dot(from + other * departure.ray.direction, u) / length(axis);
        if (std::fabs(place) < 1e-3 || std::fabs(place - 1) < 1e-3) return;
        const bool is_within = place > 0 && place < 1;
        REQUIRE((hit.shape >= 0) == (other > 0 && is_within));
        ++(other <= 0 ? outward : is_within ? inward : beyond);
        if (hit.shape >= 0) REQUIRE(std::fabs(hit.t - other) <= slack * 4 * length(f) / length(d));
      });
  CHECK(inward > 1000);
  CHECK(outward > 1000);
  CHECK(beyond > 100);
}

TEMPLATE_TEST_CASE("a box is left outwards for good, and met inwards at its far side", "", float, double) {
  int inward = 0, outward = 0;
  over_departures<TestType>(
      [](Departures& d) {
        const Vec3 half{d.sized(0.2, 0.6), d.sized(0.2, 0.6), d.sized(0.2, 0.6)};
        return Box{to_float(d.center - half), to_float(d.center + half)};
      },
      [&](const Box& box, const Departure& departure, const Hit& hit) {
        const Vec3 &o = departure.ray.origin, &d = departure.ray.direction;
        const double o_of[] = {o.x, o.y, o.z}, d_of[] = {d.x, d.y, d.z}, lo[] = {box.min.x, box.min.y, box.min.z},
                     hi[] = {box.max.x, box.max.y, box.max.z};
        double leave = INFINITY, to_edge = INFINITY;
        const double n_of[] = {departure.normal.x, departure.normal.y, departure.normal.z};
        for (int i = 0; i < 3; ++i) {
          if (d_of[i] != 0) leave = std::fmin(leave, ((d_of[i] > 0 ? hi[i] : lo[i]) - o_of[i]) / d_of[i]);
          if (n_of[i] == 0)
            to_edge = std::fmin(to_edge, std::fmin(std::fabs(hi[i] - o_of[i]), std::fabs(o_of[i] - lo[i])));
        }
        // Within rounding of an edge the nearest face may be the neighbour's.
        if (to_edge < 1e-3 * length(box.max - box.min)) return;
        const bool is_inward = dot(departure.normal, d) < 0;
        ++(is_inward ? inward : outward);
        REQUIRE((hit.shape >= 0) == (is_inward && leave > 0));
        if (is_inward && leave > 0)
          REQUIRE(std::fabs(hit.t - leave) <= 2 * (sizeof(TestType) == 4 ? 0x1p-24 : 0x1p-53) * leave);
      });
  CHECK(inward > 1000);
  CHECK(outward > 1000);
}
