// SPDX-License-Identifier: MIT
// The robust tier has the host's bits on every device, at every width: t, ids, u, v and normal.
#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>

#include "opencl/program.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "render/intersector.h"
#include "robust/ask_host.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;
using oracle::Law;
using selftest::to_float;

namespace {

struct Traced {
  Scene scene;
  std::vector<Ray> rays;
};

/// One shape of every case that is drawn, scene and rays together; every third ray leaves the shape it is aimed at.
template <class Draw, class MakeGeometry>
void add(Traced& traced, int count, Draw draw, MakeGeometry make) {
  oracle::Random random(5);
  for (const Law law : {Law::aimed, Law::border})
    for (int i = 0; i < count; ++i) {
      const auto drawn = draw(random, law, oracle::Rounding::to_float);
      traced.scene.shapes.emplace_back().geometry = make(drawn.shape);
      for (int k = 0; k < 40; ++k) {
        Ray ray;
        const double off = k * 0x1p-10;
        ray.origin = {to_float(drawn.ray.origin.x + off), drawn.ray.origin.y, drawn.ray.origin.z};
        ray.direction = {drawn.ray.direction.x, to_float(drawn.ray.direction.y + off * 0x1p-6), drawn.ray.direction.z};
        if (k % 3 == 0) ray.shape = static_cast<int>(traced.scene.shapes.size()) - 1, ray.primitive = 0;
        traced.rays.push_back(ray);
      }
    }
}

Geometry geometry(const oracle::Sphere& s) {
  Sphere sphere;
  sphere.center = s.center;
  sphere.radius = s.radius;
  return sphere;
}
Geometry geometry(const oracle::Cylinder& s) {
  return Cylinder{s.p0, s.p0 + s.axis, s.radius, orthonormal_basis(normalized(s.axis))[0]};
}
Geometry geometry(const oracle::Plane& s) {
  const auto [a, b] = orthonormal_basis(normalized(s.normal));
  return Plane{s.point, s.normal, a, b};
}
Geometry geometry(const oracle::Disk& s) {
  const auto [a, b] = orthonormal_basis(normalized(cross(s.axis_u, s.axis_v)));
  return Disk{s.center, s.radius * a, s.radius * b};
}
Geometry geometry(const oracle::Triangle& s) { return Triangle{s.p0, s.p1, s.p2}; }
Geometry geometry(const oracle::Parallelogram& s) { return Rectangle{s.corner, s.edge_u, s.edge_v}; }

Traced everything(int count) {
  Traced traced;
  const auto make = [](const auto& shape) { return geometry(shape); };
  add(traced, count, oracle::sphere_case, make);
  add(traced, count, oracle::cylinder_case, make);
  add(traced, count / 4, oracle::plane_case, make);
  add(traced, count, oracle::disk_case, make);
  add(traced, count, oracle::triangle_case, make);
  add(traced, count, oracle::parallelogram_case, make);
  return traced;
}

/// A ball 2^20 of its radius away, and rays by the least distances from its silhouette.
Traced tangents() {
  Traced traced;
  traced.scene.shapes.emplace_back().geometry = Sphere{};
  const double slope = to_float(3e-7);
  for (int k = -200; k < 200; ++k) {
    Ray ray;
    ray.origin = {-0x1p20, to_float(1 - 0x1p20 * slope) + k * 0x1p-24, 0};
    ray.direction = {1, slope, 0};
    traced.rays.push_back(ray);
  }
  return traced;
}

/// Rays that begin beside a tilted plane, far from the point that it is given by.
Traced from_a_plane() {
  Traced traced;
  const Vec3 normal = normalized(Vec3{1, 0.7, 0.4});
  const auto [a, b] = orthonormal_basis(normal);
  traced.scene.shapes.emplace_back().geometry = Plane{{0, 0, 0}, normal, a, b};
  oracle::Random random(6);
  for (int i = 0; i < 400; ++i) {
    const double x = random.uniform(-0x1p20, 0x1p20), y = random.uniform(-0x1p20, 0x1p20);
    const Vec3 beside = x * a + y * b - 0.5 * normal;
    Ray ray;
    ray.origin = {to_float(beside.x), to_float(beside.y), to_float(beside.z)};
    ray.direction = {1, to_float(random.uniform(0, 1)), to_float(random.uniform(0, 1))};
    traced.rays.push_back(ray);
  }
  return traced;
}

/// Rays whose t lies exactly between two reals.
Traced ties() {
  Traced traced;
  for (int i = 0; i < 32; ++i) {
    traced.scene.shapes.emplace_back().geometry = Rectangle{{2.0 * i, 0, 1 + i * 0x1p-23}, {1, 0, 0}, {0, 1, 0}};
    Ray ray;
    ray.origin = {2 * i + 0.5, 0.5, -0x1p-24};
    ray.direction = {0, 0, 1};
    traced.rays.push_back(ray);
  }
  return traced;
}

std::vector<Hit> trace_on_host(Scene scene, const std::vector<Ray>& rays, int lanes) {
  scene.integrator.name = "emission";
  scene.materials.emplace_back();
  RenderSettings settings;
  settings.generic = true;
  const auto packed = pack_scene<float>(scene, features_of(scene, settings), {lanes, UploadFrame{}});
  const std::vector<std::int64_t> ids = first_ids(scene);
  std::vector<Hit> hits;
  for (const Ray& ray : rays) {
    const auto reals = reals_of({ray.origin, ray.direction, ray.t_min, ray.t_max});
    const std::int32_t left[layout::DEPARTED_INTS] = {
        ray.shape < 0 ? -1 : static_cast<std::int32_t>(ids.at(static_cast<std::size_t>(ray.shape))), -1};
    std::array<float, layout::HIT_REALS> out;
    std::array<std::int32_t, layout::HIT_INTS> found;
    robust_intersect(lanes, packed.geometry.data(), packed.shading.data(), packed.index.data(), reals.data(), left, 1,
                     out.data(), found.data());
    Hit hit;
    hit.t = out[layout::HIT_T];
    hit.u = out[layout::HIT_U];
    hit.v = out[layout::HIT_V];
    hit.normal = {out[layout::HIT_NORMAL], out[layout::HIT_NORMAL + 1], out[layout::HIT_NORMAL + 2]};
    hit.shape = found[layout::HIT_SHAPE];
    hit.primitive = found[layout::HIT_PRIMITIVE];
    hits.push_back(hit);
  }
  return hits;
}

int differing(const std::vector<Hit>& a, const std::vector<Hit>& b) {
  REQUIRE(a.size() == b.size());
  const auto bits = [](const Hit& h) {
    std::vector<std::uint64_t> all;
    for (const double x : {h.t, h.u, h.v, h.normal.x, h.normal.y, h.normal.z})
      all.push_back(std::bit_cast<std::uint64_t>(x));
    return all;
  };
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += a[i].shape != b[i].shape || a[i].primitive != b[i].primitive || bits(a[i]) != bits(b[i]);
  return count;
}

/// generic: one program holds everything; else what the scene calls for. turns: as RenderSettings::loop_turns.
void hold(const std::string& selector, const std::vector<int>& widths, const Traced& traced, bool generic,
          std::optional<std::uint64_t> turns = std::nullopt) {
  const Device device = Device::open(selector);
  const std::vector<Hit> expected = trace_on_host(traced.scene, traced.rays, 1);
  std::set<int> shapes;
  for (const Hit& hit : expected) shapes.insert(hit.shape);
  CHECK(4 * shapes.size() > traced.scene.shapes.size());
  for (const int lanes : widths) {
    INFO(device.info().text() << ", " << lanes << " lanes");
    CHECK(differing(trace_on_host(traced.scene, traced.rays, lanes), expected) == 0);
    RenderSettings settings;
    settings.precision = Precision::robust;
    settings.lanes = lanes;
    settings.generic = generic;
    settings.loop_turns = turns;
    CHECK(differing(Intersector(device, traced.scene, settings).trace(traced.rays), expected) == 0);
  }
}

}  // namespace

TEST_CASE("PoCL has the host's bits in the robust tier") {
  require_pocl_and_rusticl();
  for (const Traced& traced : {tangents(), from_a_plane(), ties()}) hold("pocl", {16}, traced, true);
  hold("pocl", {1, 16}, everything(40), true);
}

TEST_CASE("PoCL has the host's bits in the robust tier, at eight lanes", "[slow]") {
  require_pocl_and_rusticl();
  for (const Traced& traced : {tangents(), from_a_plane(), ties(), everything(40)}) hold("pocl", {8}, traced, true);
}

TEST_CASE("PoCL has the same bits in double words") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl");
  const auto text = [&] { return completed_for(device, {"\n", ""}).text; };
  CHECK(text().find("WIDE_IS_DOUBLE 1") != std::string::npos);
  setenv("STRAHL_DOUBLE_WORDS", "1", 1);
  CHECK(text().find("WIDE_IS_DOUBLE") == std::string::npos);
  hold("pocl", {16}, everything(40), true);
  for (const Traced& traced : {tangents(), from_a_plane(), ties()}) hold("pocl", {16}, traced, true);
  unsetenv("STRAHL_DOUBLE_WORDS");
}

// Its compiler takes minutes for everything at once.
TEST_CASE("rusticl has the host's bits for robust spheres") {
  require_pocl_and_rusticl();
  Traced spheres;
  add(spheres, 20, oracle::sphere_case, [](const auto& shape) { return geometry(shape); });
  hold("llvmpipe", {1}, spheres, false);
}

// Programs as users have them there: functions stay functions (cl/portable.h, INLINE_FN).
TEST_CASE("rusticl has the host's bits where it ends loops") {
  require_pocl_and_rusticl();
  hold("llvmpipe", {1}, everything(40), false, 65534);
}

TEST_CASE("every other device has the host's bits in the robust tier") {
  for (const std::string& selector : present_devices())
    if (selector != "pocl" && selector != "llvmpipe" && selector != "oclgrind")
      hold(selector, {1, 8, 16}, everything(40), true);
}
