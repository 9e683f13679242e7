// SPDX-License-Identifier: MIT
// Every shape, every law of the generators, both tiers, against the exact answer for what the device holds. The large
// numbers run on the host, whose bits test_host_equals_device.cpp holds equal to every device's; a sample runs on PoCL.
//
// What a tier of roundoff u promises (u = 2^-24 stable, 2^-53 double), with scale, cosine and band of shape_cases.h:
//   hit or miss  as the oracle says where |margin| > 8 u band
//   t            within K u scale / (cosine |d|): K last places of the numbers that it was computed from, seen along
//                the ray. K by shape below: the largest seen was 4.87 over 20,000 cases a law. Box: ulps of t.
// Left out of these two, never of "no NaN": rays with cosine < 64 u, those whose crossing is within that error of t_min
// or t_max, and in the stable tier the law `extreme`, whose products leave the range of float. A sphere with
// r / distance < 1e-6 is within its own band: the stable tier cannot see it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "cl/host_tracer.h"
#include "cl/shape_cases.h"
#include "scene/validate.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr int cases_per_law = 1500;

/// What t may be off by: K; and the ulps of t itself that follow at ordinary scale, the law `aimed` where the cosine is
/// 1/4 or more and t |d| makes up a quarter of the scale or more (elsewhere t is small by cancellation, or ill-posed).
struct Bounds {
  double units;
  double ordinary_ulps;
};

template <class Cases>
constexpr bool is_box = std::is_same_v<Cases, BoxCases>;

template <class Real>
constexpr double roundoff = sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53;

template <class Real>
double ulp_error(double t, const oracle::Exact& exact) {
  return sizeof(Real) == 4 ? oracle::ulp_error_f32(static_cast<float>(t), exact) : oracle::ulp_error_f64(t, exact);
}

Ray ray_of(const oracle::Ray& r) {
  Ray ray;
  ray.origin = r.origin;
  ray.direction = r.direction;
  ray.t_min = r.t_min;
  ray.t_max = r.t_max;
  return ray;
}

bool has_nan(const Hit& hit) {
  return std::isnan(hit.t + hit.u + hit.v) || std::isnan(hit.normal.x + hit.normal.y + hit.normal.z);
}

/// One case as the oracle sees it.
template <class Cases, class Real>
struct Judgement {
  bool is_promised = false;  ///< outside everything that is left out
  bool is_hit = false, is_ordinary = false;
  oracle::Exact t;
  double unit = 0;  ///< error of t per K

  Judgement(const oracle::Ray& ray, const typename Cases::Shape& shape) {
    constexpr double u = roundoff<Real>;
    oracle::Ray line = ray;
    line.t_min = -INFINITY;
    line.t_max = INFINITY;
    const auto whole = Cases::answer(line, shape);
    double before = 4 * u * std::fabs(ray.t_min), after = 4 * u * std::fabs(ray.t_max);
    if constexpr (is_box<Cases>) {
      if (!(std::fabs(whole.margin) > 8 * u)) return;
    } else {
      const double cosine = Cases::cosine(ray, shape, whole);
      unit = u * Cases::scale(ray, shape, whole) / (cosine * length(ray.direction));
      before = after = 8 * unit;
      if (!(cosine >= 64 * u) || !(std::fabs(whole.margin) > 8 * u * Cases::band(ray, shape, whole))) return;
    }
    oracle::Ray narrow = ray, wide = ray;
    if (std::isfinite(ray.t_min)) narrow.t_min += before, wide.t_min -= before;
    if (std::isfinite(ray.t_max)) narrow.t_max -= after, wide.t_max += after;
    const auto inner = Cases::answer(narrow, shape), outer = Cases::answer(wide, shape);
    is_promised = inner.hit == outer.hit && (!inner.hit || inner.t.value == outer.t.value);
    is_hit = inner.hit;
    t = inner.t;
    if constexpr (!is_box<Cases>) {
      const double scale = Cases::scale(ray, shape, whole);
      is_ordinary =
          Cases::cosine(ray, shape, whole) >= 0.25 && std::fabs(t.value) * length(ray.direction) >= 0.25 * scale;
    }
  }
};

template <class Cases>
struct Drawn {
  std::vector<oracle::Case<typename Cases::Shape>> cases;
  Scene scene;

  Drawn(Law law, Rounding rounding, int count) {
    Random random(7000 + static_cast<std::uint64_t>(law));
    for (int i = 0; i < count; ++i) {
      cases.push_back(Cases::draw(random, law, rounding));
      scene.shapes.emplace_back().geometry = Cases::geometry(cases.back().shape);
    }
  }
};

template <class Cases, class Real>
void hold(Rounding rounding, const Bounds& bounds) {
  int promised = 0, hits = 0;
  for (const Law law : oracle::all_laws) {
    Drawn<Cases> drawn(law, rounding, cases_per_law);
    PrimitiveTracer<Real> tracer(drawn.scene, Cases::kind);
    const bool leaves_range = law == Law::extreme && sizeof(Real) == 4;
    double worst = 0, worst_ordinary = 0;
    for (std::size_t i = 0; i < drawn.cases.size(); ++i) {
      const oracle::Ray& ray = drawn.cases[i].ray;
      INFO(Cases::kind << ", law " << static_cast<int>(law) << ", case " << i);
      const Hit hit = tracer.trace(i, ray_of(ray));
      if (has_nan(hit) || (hit.shape >= 0) != std::isfinite(hit.t)) FAIL("NaN, or inf other than as t of a miss");
      if (leaves_range) continue;
      const Judgement<Cases, Real> truth(ray, Cases::asked(tracer.planes(i)));
      if (!truth.is_promised) continue;
      ++promised;
      if ((hit.shape >= 0) != truth.is_hit) FAIL("hit should be " << truth.is_hit);
      if (!truth.is_hit) continue;
      ++hits;
      const double ulps = ulp_error<Real>(hit.t, truth.t);
      const double error = std::fabs((hit.t - truth.t.value) - truth.t.rest);
      worst = std::max(worst, is_box<Cases> ? ulps : error / truth.unit);
      if (law == Law::aimed && truth.is_ordinary) worst_ordinary = std::max(worst_ordinary, ulps);
    }
    INFO(Cases::kind << ", law " << static_cast<int>(law));
    CHECK(worst <= bounds.units);
    CHECK(worst_ordinary <= bounds.ordinary_ulps);
  }
  // So that leaving out cannot swallow the test.
  CHECK(promised > 2 * cases_per_law);
  CHECK(2 * hits > 3 * cases_per_law);
}

/// The double tier on float input is as good as a correctly rounded float, cancellation at t near 0 apart.
template <class Cases>
void hold_rounded_to_float(double units) {
  for (const Law law : oracle::all_laws) {
    Drawn<Cases> drawn(law, Rounding::to_float, cases_per_law);
    PrimitiveTracer<double> tracer(drawn.scene, Cases::kind);
    for (std::size_t i = 0; i < drawn.cases.size(); ++i) {
      const oracle::Ray& ray = drawn.cases[i].ray;
      const Judgement<Cases, double> truth(ray, Cases::asked(tracer.planes(i)));
      if (!truth.is_promised) continue;
      INFO(Cases::kind << ", law " << static_cast<int>(law) << ", case " << i);
      const Hit hit = tracer.trace(i, ray_of(ray));
      if ((hit.shape >= 0) != truth.is_hit) FAIL("hit should be " << truth.is_hit);
      if (!truth.is_hit) continue;
      const double error = std::fabs((hit.t - truth.t.value) - truth.t.rest);
      if (ulp_error<float>(hit.t, truth.t) > 1 && error > units * truth.unit) FAIL("t " << hit.t);
    }
  }
}

/// Integers times a power of two: no operation rounds except the last.
template <class Cases, class Real>
void hold_exact(std::initializer_list<Law> laws) {
  for (const Law law : laws) {
    Drawn<Cases> drawn(law, Rounding::to_float, cases_per_law);
    PrimitiveTracer<Real> tracer(drawn.scene, Cases::kind);
    for (std::size_t i = 0; i < drawn.cases.size(); ++i) {
      const oracle::Ray& ray = drawn.cases[i].ray;
      const auto truth = Cases::answer(ray, Cases::asked(tracer.planes(i)));
      const Hit hit = tracer.trace(i, ray_of(ray));
      INFO(Cases::kind << ", law " << static_cast<int>(law) << ", case " << i);
      if ((hit.shape >= 0) != truth.hit) FAIL("hit should be " << truth.hit);
      if (truth.hit && ulp_error<Real>(hit.t, truth.t) > 0.5) FAIL("t " << hit.t << " is not the nearest number");
    }
  }
}

/// One case a scene, so few; test_host_equals_device.cpp has the large numbers.
template <class Cases>
void sample_on_device(const Device& device) {
  RenderSettings settings;
  settings.precision = Precision::stable;
  for (const Law law : oracle::all_laws) {
    Drawn<Cases> drawn(law, Rounding::to_float, 3);
    for (const auto& one : drawn.cases) {
      Scene scene;
      scene.materials.emplace_back();
      scene.shapes.emplace_back().geometry = Cases::geometry(one.shape);
      if (!validate(scene).empty()) continue;  // such as a cylinder whose ends have become one point
      PrimitiveTracer<float> host(scene, Cases::kind);
      const Ray ray = ray_of(one.ray);
      const Hit expected = host.trace(0, ray), hit = Intersector(device, scene, settings).trace({ray}).front();
      INFO(Cases::kind << ", law " << static_cast<int>(law));
      CHECK(hit.t == expected.t);
      CHECK(hit.shape == expected.shape);
      CHECK(hit.normal == expected.normal);
      CHECK(hit.u == expected.u);
      CHECK(hit.v == expected.v);
    }
  }
}

}  // namespace

//                                                                                        K   ulps
TEST_CASE("stable: sphere") { hold<SphereCases, float>(Rounding::to_float, {5, 6}); }
TEST_CASE("stable: cylinder") { hold<CylinderCases, float>(Rounding::to_float, {5, 7}); }
TEST_CASE("stable: plane") { hold<PlaneCases, float>(Rounding::to_float, {5, 6}); }
TEST_CASE("stable: disk") { hold<DiskCases, float>(Rounding::to_float, {5, 5}); }
TEST_CASE("stable: triangle") { hold<TriangleCases, float>(Rounding::to_float, {5, 5}); }
TEST_CASE("stable: parallelogram") { hold<ParallelogramCases, float>(Rounding::to_float, {5, 6}); }
TEST_CASE("stable: box") { hold<BoxCases, float>(Rounding::to_float, {1.5, 0}); }

TEST_CASE("double: sphere") { hold<SphereCases, double>(Rounding::to_double, {5, 6}); }
TEST_CASE("double: cylinder") { hold<CylinderCases, double>(Rounding::to_double, {5, 7}); }
TEST_CASE("double: plane") { hold<PlaneCases, double>(Rounding::to_double, {5, 6}); }
TEST_CASE("double: disk") { hold<DiskCases, double>(Rounding::to_double, {5, 5}); }
TEST_CASE("double: triangle") { hold<TriangleCases, double>(Rounding::to_double, {5, 5}); }
TEST_CASE("double: parallelogram") { hold<ParallelogramCases, double>(Rounding::to_double, {5, 6}); }
TEST_CASE("double: box") { hold<BoxCases, double>(Rounding::to_double, {1.5, 0}); }

TEMPLATE_TEST_CASE("double on float input: t within 1 ulp of float", "", SphereCases, CylinderCases, PlaneCases,
                   DiskCases, TriangleCases, ParallelogramCases) {
  hold_rounded_to_float<TestType>(5);
}
TEST_CASE("double on float input: box within 1 ulp of float") { hold_rounded_to_float<BoxCases>(0); }

TEMPLATE_TEST_CASE("what fits into the significand is answered exactly, tangents and parallel rays included", "", float,
                   double) {
  hold_exact<SphereCases, TestType>({Law::exact_border, Law::in_surface});
  hold_exact<PlaneCases, TestType>({Law::exact_border, Law::in_surface});
  hold_exact<DiskCases, TestType>({Law::exact_border});
  hold_exact<BoxCases, TestType>({Law::exact_border});
}

TEMPLATE_TEST_CASE("t of a triangle lies between its vertices, also where products underflow", "", float, double) {
  constexpr double u = roundoff<TestType>, least = static_cast<double>(std::numeric_limits<TestType>::denorm_min());
  // At the smaller scale edge functions are subnormal and their products with a distance 0.
  for (const double scale : {1.0, sizeof(TestType) == 4 ? 0x1p-66 : 0x1p-530}) {
    oracle::Random random(31);
    Scene scene;
    std::vector<Ray> rays;
    for (int i = 0; i < 4 * cases_per_law; ++i) {
      const auto drawn = TriangleCases::draw(random, i % 2 ? Law::aimed : Law::border, Rounding::to_float);
      rays.push_back({scale * drawn.ray.origin, drawn.ray.direction});
      scene.shapes.emplace_back().geometry =
          Triangle{scale * drawn.shape.p0, scale * drawn.shape.p1, scale * drawn.shape.p2};
    }
    PrimitiveTracer<TestType> tracer(scene, "triangle");
    int outside = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit hit = tracer.trace(i, rays[i]);
      if (hit.shape < 0) continue;
      ++hits;
      const Extent range =
          TriangleCases::extent({rays[i].origin, rays[i].direction}, TriangleCases::asked(tracer.planes(i)));
      // Difference, reciprocal, product; and a subnormal's last place.
      const double slack = 4 * u * std::fmax(std::fabs(range.low), std::fabs(range.high)) + 4 * least;
      outside += !(hit.t >= range.low - slack && hit.t <= range.high + slack);
    }
    INFO("scale " << scale);
    CHECK(outside == 0);
    CHECK(hits > 100);
  }
}

TEMPLATE_TEST_CASE("the rims of a cylinder belong to it, from outside and inside", "", float, double) {
  Scene scene;
  scene.shapes.emplace_back().geometry = Cylinder{{0, 0, 0}, {0, 0, 2}, 1, {1, 0, 0}};
  PrimitiveTracer<TestType> tracer(scene, "cylinder");
  for (const double z : {0.0, 2.0}) {
    CHECK(tracer.trace(0, Ray{{-4, 0, z}, {1, 0, 0}}).t == 3);
    CHECK(tracer.trace(0, Ray{{0, 0, z}, {0, 1, 0}}).t == 1);
  }
  CHECK(tracer.trace(0, Ray{{-4, 0, 2.001}, {1, 0, 0}}).shape == -1);
  CHECK(tracer.trace(0, Ray{{-4, 0, -0.001}, {1, 0, 0}}).shape == -1);
}

TEST_CASE("a sample on the device has the host's answers") {
  require_pocl();
  const Device pocl = Device::open("pocl");
  sample_on_device<SphereCases>(pocl);
  sample_on_device<CylinderCases>(pocl);
  sample_on_device<PlaneCases>(pocl);
  sample_on_device<DiskCases>(pocl);
  sample_on_device<TriangleCases>(pocl);
  sample_on_device<ParallelogramCases>(pocl);
  sample_on_device<BoxCases>(pocl);
}
