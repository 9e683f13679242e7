// SPDX-License-Identifier: MIT
#include "bench/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "bench/peers/embree.h"
#include "bench/strahl_contender.h"
#include "scene/loader.h"
#include "study/generated/scenes.h"

namespace strahl::bench {
namespace {

using Contenders = std::vector<std::unique_ptr<Contender>>;

std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

template <typename T>
std::vector<std::optional<T>> or_default(const std::vector<T>& values) {
  if (values.empty()) return {std::nullopt};
  return {values.begin(), values.end()};
}

void add_strahl(Contenders& contenders, const Device& device, const Scene& scene, const TraversalOptions& options) {
  for (const Precision tier : options.tiers)
    for (const std::optional<int>& lanes : or_default(options.lanes)) {
      RenderSettings settings;
      settings.precision = tier;
      settings.lanes = lanes;
      contenders.push_back(std::make_unique<StrahlContender>(device, scene, settings));
    }
}

void add_peers(Contenders& contenders, const Scene& scene, unsigned threads) {
  const bool has_spheres = std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) {
    return std::holds_alternative<Sphere>(shape.geometry);
  });
  for (const bool robust : {false, true}) {
    contenders.push_back(embree_contender(scene, {robust, 1, false, threads}));
    if (has_spheres) contenders.push_back(embree_contender(scene, {robust, 1, true, threads}));
    for (const int packet : {8, 16}) contenders.push_back(embree_contender(scene, {robust, packet, true, threads}));
  }
}

RaySet rays_of(RayKind kind, const Scene& scene, const RaySet& primary, const std::vector<Hit>& hits) {
  switch (kind) {
    case RayKind::primary:
      return primary;
    case RayKind::shadow:
      return shadow_rays(scene, primary, hits);
    case RayKind::diffuse:
      return diffuse_rays(primary, hits);
  }
  return primary;
}

}  // namespace

Scene bench_scene(const std::string& name) {
  if (name.find_first_of("./") == std::string::npos) return generated_scene(name);
  Scene scene = load_scene(name).scene;
  scene.film.width = scene.film.height = 1024;
  if (scene.lights.empty()) {  // Over the camera's right shoulder.
    const Transform& camera = scene.camera.world_from_camera;
    scene.lights.push_back({"", PointLight{camera.point({-1, 1, 0})}, {}});
  }
  return scene;
}

Traversal measure_traversal(const Device& device, const TraversalOptions& asked,
                            const std::function<void(const std::string&)>& say) {
  TraversalOptions options = asked;
  if (options.tiers.empty()) {
    options.tiers = {Precision::robust, Precision::stable, Precision::fast};
    if (device.info().fp64) options.tiers.push_back(Precision::fp64);
  }
  if (options.threads == 0) options.threads = std::max(1U, std::thread::hardware_concurrency());
  Traversal all{device.info().text(), machine(), STRAHL_VERSION, options.threads, options.rounds, {}};
  for (const std::string& name : options.scenes) {
    Scene scene = bench_scene(name);
    scene.film.width = scene.film.height = options.pixels;
    std::size_t primitives = 0;
    for (const Shape& shape : scene.shapes) primitives += static_cast<std::size_t>(primitive_count(shape));
    Contenders contenders;
    add_strahl(contenders, device, scene, options);
    if (options.peers && has_embree()) add_peers(contenders, scene, options.threads);

    const RaySet primary = primary_rays(scene);
    auto& first = dynamic_cast<StrahlContender&>(*contenders.front());
    first.load(primary);
    static_cast<void>(first.trace());
    const std::vector<Hit> hits = first.hits();
    for (const RayKind kind : options.kinds) {
      say(fmt::format("{}, {} rays", name, ray_kind_name(kind)));
      Race one = race(contenders, rays_of(kind, scene, primary, hits), options.rounds);
      one.scene = name;
      one.primitives = primitives;
      all.races.push_back(std::move(one));
    }
  }
  return all;
}

}  // namespace strahl::bench
