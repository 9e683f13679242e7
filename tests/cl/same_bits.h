// SPDX-License-Identifier: MIT
// Holds a device to the bits of the kernels' headers compiled on the host, hit by hit: t, ids, u, v, normal.
#pragma once

#include <array>
#include <bit>
#include <catch2/catch.hpp>

#include "cl/host_tracer.h"
#include "cl/mixed_scenes.h"

namespace strahl::test {

/// rusticl does not keep the sign of zero: it takes -0 * x and x - x for what suits it.
[[nodiscard]] inline bool keeps_sign_of_zero(const Device& device) {
  return device.info().platform.find("rusticl") == std::string::npos;
}

[[nodiscard]] inline bool is_same(const Hit& a, const Hit& b, bool with_sign_of_zero) {
  const auto reals = [](const Hit& h) { return std::array{h.t, h.u, h.v, h.normal.x, h.normal.y, h.normal.z}; };
  const auto bits = [&](const Hit& h) { return std::bit_cast<std::array<std::uint64_t, 6>>(reals(h)); };
  return a.instance == b.instance && a.shape == b.shape && a.primitive == b.primitive &&
         (with_sign_of_zero ? bits(a) == bits(b) : reals(a) == reals(b));
}

inline void require_same(const std::vector<Hit>& hits, const std::vector<Hit>& expected, const std::vector<Ray>& rays,
                         bool with_sign_of_zero = true) {
  REQUIRE(hits.size() == expected.size());
  int differing = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (is_same(hits[i], expected[i], with_sign_of_zero)) continue;
    if (++differing > 1) continue;
    const Hit &a = hits[i], &b = expected[i];
    const Ray& r = rays[i];
    UNSCOPED_INFO("ray " << i << ": o " << r.origin.x << " " << r.origin.y << " " << r.origin.z << " d "
                         << r.direction.x << " " << r.direction.y << " " << r.direction.z << ": " << a.shape << "/"
                         << a.primitive << " t " << a.t << " where the host has " << b.shape << "/" << b.primitive
                         << " t " << b.t);
  }
  CHECK(differing == 0);
}

struct Traced {
  Scene scene;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
};

/// The rays, and as many again that go on from where the first ones ended, with the primitive that they left.
template <class Real>
Traced trace_on_host(SceneMaker& maker, std::size_t count) {
  Traced traced{maker.scene(), maker.rays(count / 2), {}};
  const HostTracer<Real> host(traced.scene, 1);
  const std::vector<Hit> first = host.trace(traced.rays);
  const std::vector<Ray> fresh = maker.rays(count / 2);
  int hits = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    Ray ray = fresh[i];
    if (first[i].shape >= 0) {
      ++hits;
      ray.origin = traced.rays[i].origin + first[i].t * traced.rays[i].direction;
      ray.instance = first[i].instance;
      ray.shape = first[i].shape;
      ray.primitive = first[i].primitive;
      if (i % 2) ray.direction = traced.rays[i].direction;
    }
    traced.rays.push_back(ray);
  }
  CHECK(hits > static_cast<int>(count) / 16);
  traced.hits = host.trace(traced.rays);
  return traced;
}

/// The device against the host at one width. `settings` says which program.
template <class Real>
void hold_same(const Device& device, const std::string& name, const Traced& traced, const RenderSettings& settings) {
  INFO(device.info().text() << ", " << precision_name(settings.precision) << ", width " << *settings.lanes << ", "
                            << name);
  const HostTracer<Real> host(traced.scene, *settings.lanes);
  require_same(host.trace(traced.rays), traced.hits, traced.rays);
  Intersector intersector(device, traced.scene, settings);
  require_same(intersector.trace(traced.rays), traced.hits, traced.rays, keeps_sign_of_zero(device));
  const std::vector<Hit> any = intersector.trace(traced.rays, true);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < any.size(); ++i) differing += (any[i].t == 0) != (traced.hits[i].shape >= 0);
  CHECK(differing == 0);
}

/// A scene of every kind of shape alone with the program for just that kind, `count` rays each.
inline void hold_kinds(const Device& device, int lanes, std::size_t count) {
  for (const std::string& name : geometry_names()) {
    if (name == "cube" || name == "mesh") continue;  // the programs of rectangle and triangle
    SceneMaker maker(44);
    maker.add(name, 20);
    RenderSettings settings;
    settings.lanes = lanes;
    settings.precision = Precision::stable;
    hold_same<float>(device, name, trace_on_host<float>(maker, count), settings);
  }
}

}  // namespace strahl::test
