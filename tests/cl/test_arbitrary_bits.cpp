// SPDX-License-Identifier: MIT
// Rays and shapes of random bit patterns (NaN, infinity, denormals, zero directions among the rays'): no NaN comes out,
// infinity only as t of a miss, a NaN in a ray misses, any hit agrees with closest hit, and it ends.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "cl/host_tracer.h"
#include "cl/mixed_scenes.h"
#include "packing/pack_shapes.h"
#include "scene/validate_geometry.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// Any bits one time in four; else a value that other ones meet: a special one, or one at the scene's scale.
template <class Real>
double draw(oracle::Random& random) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  using Limits = std::numeric_limits<Real>;
  constexpr Real special[] = {
      Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), 0, -Real(0), Limits::denorm_min(),
      Limits::min(),       Limits::max(),      -Limits::max(),      1, -1};
  const int choice = random.integer(0, 15);
  if (choice < 4) return static_cast<double>(std::bit_cast<Real>(static_cast<Bits>(random.bits())));
  if (choice == 4) return static_cast<double>(special[random.integer(0, 10)]);
  if (choice < 7) return 0;
  return random.uniform(-20, 20);
}

template <class Real>
std::vector<Ray> any_rays(std::size_t count) {
  oracle::Random random(77);
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) {
    for (double* x :
         {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y, &ray.direction.z})
      *x = draw<Real>(random);
    if (random.integer(0, 3) == 0) ray.t_min = draw<Real>(random);
    if (random.integer(0, 3) == 0) ray.t_max = draw<Real>(random);
    if (random.integer(0, 3) == 0) ray.shape = random.integer(0, 30), ray.primitive = 0;
  }
  return rays;
}

bool is_usable(const Ray& r) {
  const double sum = r.origin.x + r.origin.y + r.origin.z + r.direction.x + r.direction.y + r.direction.z;
  return !std::isnan(sum) && !std::isnan(r.t_min) && !std::isnan(r.t_max) && length(r.direction) > 0;
}

/// What is wrong with an answer; nothing: "".
std::string fault(const Ray& ray, const Hit& hit, const Hit& any) {
  const bool is_hit = hit.shape >= 0;
  if (is_hit ? !std::isfinite(hit.t) : !(std::isinf(hit.t) && hit.t > 0)) return "t";
  if (!std::isfinite(hit.u) || !std::isfinite(hit.v) || !is_finite(hit.normal)) return "u, v or normal";
  if (is_hit && !is_usable(ray)) return "hit by an unusable ray";
  if (is_hit && !(ray.t_min <= hit.t && hit.t <= ray.t_max)) return "t is out of range";
  if (any.t != (is_hit ? 0 : INFINITY) || any.shape != -1) return "any hit differs";
  return "";
}

template <class Trace>
void hold(const std::vector<Ray>& rays, Trace trace) {
  const std::vector<Hit> closest = trace(rays, false), any = trace(rays, true);
  int hits = 0, faults = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& r = rays[i];
    const Hit& hit = closest[i];
    hits += hit.shape >= 0;
    const std::string wrong = fault(r, hit, any[i]);
    if (wrong.empty() || ++faults > 3) continue;
    UNSCOPED_INFO(wrong << ": ray " << i << " o " << r.origin.x << " " << r.origin.y << " " << r.origin.z << " d "
                        << r.direction.x << " " << r.direction.y << " " << r.direction.z << " t " << r.t_min << " "
                        << r.t_max << ": shape " << hit.shape << " t " << hit.t << " u " << hit.u << " v " << hit.v);
  }
  CHECK(faults == 0);
  CHECK(hits > static_cast<int>(rays.size()) / 200);
}

/// Some of every kind; with planes, which nearly every ray hits, and without.
Scene scene(bool with_planes) {
  SceneMaker maker(45);
  for (const std::string& name : geometry_names())
    if (name != "plane" || with_planes) maker.add(name, 4);
  return maker.scene();
}

Geometry any_geometry(const std::string& name, oracle::Random& random) {
  const auto any = [&] { return Vec3{draw<float>(random), draw<float>(random), draw<float>(random)}; };
  const Vec3 a = any(), b = any(), c = any();
  const double size = std::fabs(draw<float>(random));
  const auto [across, along] = orthonormal_basis(length(b) > 0 && is_finite(b) ? normalized(b) : Vec3{0, 0, 1});
  if (name == "sphere") return Sphere{a, size};
  if (name == "plane") return Plane{a, b, across, along};
  if (name == "box") return Box{{a.x, a.y, a.z}, {a.x + std::fabs(b.x), a.y + std::fabs(b.y), a.z + std::fabs(b.z)}};
  if (name == "triangle") return Triangle{a, b, c};
  if (name == "rectangle") return Rectangle{a, b, c};
  if (name == "cube") return Cube{a, {b, c, any()}};
  if (name == "disk") return Disk{a, size * across, size * along};
  if (name == "cylinder") return Cylinder{a, a + size * (length(b) > 0 ? b : c), std::fabs(c.x), across};
  if (name != "mesh") {  // A kind that no lines above know: any planes.
    std::vector<double> planes(static_cast<std::size_t>(planes_of(name)));
    for (double& x : planes) x = draw<float>(random);
    return selftest::proof_of(name).geometry(planes.data());
  }
  Mesh mesh;
  mesh.positions = {a, b, c, any(), a};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}, {0, 0, 1}, {0, 4, 2}};
  return mesh;
}

/// Ten of every kind, such as the loader accepts.
Scene any_scene() {
  oracle::Random random(78);
  Scene scene;
  scene.materials.emplace_back();
  for (const std::string& name : geometry_names())
    for (int accepted = 0; accepted < 10;) {
      Shape shape;
      shape.geometry = any_geometry(name, random);
      if (!geometry_faults(shape.geometry).empty()) continue;
      scene.shapes.push_back(shape);
      ++accepted;
    }
  return scene;
}

std::vector<Scene> all_scenes() { return {scene(false), scene(true), any_scene()}; }

void hold_on_pocl(const std::vector<Precision>& tiers) {
  require_pocl();
  const Device device = Device::open("pocl", {true});
  const std::vector<Ray> rays = any_rays<float>(30000);
  for (const Precision precision : tiers)
    for (const Scene& scene : all_scenes()) {
      INFO(scene.shapes.size() << " shapes, " << precision_name(precision));
      RenderSettings settings;
      settings.generic = true;
      settings.precision = precision;
      Intersector intersector(device, scene, settings);
      hold(rays, [&](const std::vector<Ray>& r, bool any_hit) { return intersector.trace(r, any_hit); });
    }
}

}  // namespace

TEMPLATE_TEST_CASE("arbitrary bits, on the host", "", float, double) {
  const std::vector<Ray> rays = any_rays<TestType>(100000);
  for (const Scene& scene : all_scenes()) {
    INFO(scene.shapes.size() << " shapes");
    const HostTracer<TestType> host(scene, 8);
    hold(rays, [&](const std::vector<Ray>& r, bool any_hit) { return host.trace(r, any_hit); });
  }
}

TEST_CASE("arbitrary bits, on PoCL") { hold_on_pocl({Precision::stable, Precision::robust}); }

TEST_CASE("arbitrary bits, on PoCL, in fast and double", "[slow]") { hold_on_pocl({Precision::fast, Precision::fp64}); }
