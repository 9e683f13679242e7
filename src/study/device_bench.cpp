// SPDX-License-Identifier: MIT
#include "study/device_bench.h"

#include <algorithm>
#include <cmath>

#include "render/median.h"

namespace strahl {
namespace {

constexpr double seconds_a_round = 1.0 / 8;

Scene of_side(Scene scene, int side) {
  scene.film.width = scene.film.height = side;
  scene.film.crop.reset();
  return scene;
}

/// Of a square picture with as many pixels as take about a round.
int fitting_side(Intersector& intersector, const Scene& scene) {
  constexpr int probe_side = 128;
  const RaySet probe = primary_rays(of_side(scene, probe_side));
  static_cast<void>(intersector.trace(probe.rays, false, 3));
  const double seconds = intersector.stats().seconds.kernel;
  const double side = probe_side * std::sqrt(seconds_a_round / std::max(seconds, 1e-6));
  return std::clamp(static_cast<int>(side) / 16 * 16, 64, 1024);
}

}  // namespace

std::vector<Precision> tiers_of(const Device& device) {
  std::vector<Precision> tiers{Precision::fast, Precision::stable, Precision::robust};
  if (device.info().fp64) tiers.push_back(Precision::fp64);
  return tiers;
}

std::size_t primitives_of(const Scene& scene) {
  std::size_t primitives = 0;
  for_each_shape(scene, [&](const Shape& shape) { primitives += static_cast<std::size_t>(primitive_count(shape)); });
  return primitives;
}

BenchRays bench_rays(Intersector& intersector, const Scene& scene, int side) {
  const Scene framed = of_side(scene, side > 0 ? side : fitting_side(intersector, scene));
  const RaySet primary = primary_rays(framed);
  const std::vector<Hit> hits = intersector.trace(primary.rays);
  BenchRays sets{primary, shadow_rays(framed, primary, hits), diffuse_rays(primary, hits)};
  if (sets[1].rays.empty()) throw InputError("no camera ray hits the scene; nothing can be measured");
  return sets;
}

std::vector<double> median_seconds(std::vector<Intersector>& intersectors, const RaySet& set,
                                   const std::function<void()>& before_round) {
  std::vector<std::vector<double>> seconds(intersectors.size());
  for (Intersector& one : intersectors) static_cast<void>(one.trace(set.rays, set.any_hit()));
  for (int round = 0; round < bench_rounds; ++round) {
    before_round();
    for (std::size_t i = 0; i < intersectors.size(); ++i) {
      static_cast<void>(intersectors[i].trace(set.rays, set.any_hit()));
      seconds[i].push_back(intersectors[i].stats().seconds.kernel);
    }
  }
  std::vector<double> medians;
  for (const std::vector<double>& all : seconds) medians.push_back(median(all));
  return medians;
}

DeviceBench bench_device(const Device& device, const Scene& scene, int side, const BenchProgress& progress) {
  const std::vector<Precision> tiers = tiers_of(device);
  const int total = static_cast<int>(tiers.size()) + 1 + static_cast<int>(all_ray_kinds.size()) * bench_rounds;
  int done = 0;
  const auto step = [&] {
    if (progress) progress(done, total);
    ++done;
  };
  DeviceBench bench;
  bench.device = device.info().text();
  bench.scene = scene.name;
  bench.primitives = primitives_of(scene);

  std::vector<Intersector> intersectors;
  for (const Precision tier : tiers) {
    step();
    RenderSettings settings;
    settings.precision = tier;
    const RunStats& stats = intersectors.emplace_back(device, scene, settings).stats();
    bench.tiers.emplace_back(precision_name(tier));
    if (tier == Precision::robust) bench.tree_seconds = stats.seconds.bvh;
  }
  step();
  bench.bandwidth = measure_bandwidth(device);

  for (const RaySet& set : bench_rays(intersectors[2], scene, side)) {
    const std::string kind = ray_kind_name(set.kind);
    bench.rays[kind] = set.rays.size();
    const std::vector<double> seconds = median_seconds(intersectors, set, step);
    for (std::size_t i = 0; i < tiers.size(); ++i)
      bench.mrays[kind][bench.tiers[i]] = static_cast<double>(set.rays.size()) / seconds[i] / 1e6;
  }
  for (std::size_t i = 0; i < bench.tiers.size(); ++i) {
    const RunStats& stats = intersectors[i].stats();
    bench.program_seconds[bench.tiers[i]] = stats.seconds.program;
    bench.program_from_cache[bench.tiers[i]] = stats.program_from_cache;
  }
  return bench;
}

}  // namespace strahl
