// SPDX-License-Identifier: MIT
#include "bench/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "bench/peers/embree.h"
#include "bench/peers/embree_tree.h"
#include "bench/strahl_contender.h"
#include "errors.h"
#include "kinds/entries.h"
#include "on_threads.h"
#include "program/features.h"
#include "scene/loader.h"
#include "study/generated/scenes.h"

namespace strahl::bench {
namespace {

constexpr int tree_rounds = 7;

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
    for (const std::optional<int>& width : or_default(options.widths)) {
      if (tier == Precision::fp64 && width == 16) continue;
      RenderSettings settings;
      settings.precision = tier;
      settings.bvh_width = width;
      contenders.push_back(std::make_unique<StrahlContender>(device, scene, settings));
      settings.coherent = true;
      contenders.push_back(std::make_unique<StrahlContender>(device, scene, settings));
    }
}

void add_peers(Contenders& contenders, const Scene& scene, unsigned threads) {
  const bool has_spheres = std::any_of(scene.shapes.begin(), scene.shapes.end(),
                                       [](const Shape& shape) { return shape_kind(shape) == "sphere"; });
  for (const bool robust : {false, true}) {
    contenders.push_back(embree_contender(scene, {robust, 1, false, threads}));
    if (has_spheres) contenders.push_back(embree_contender(scene, {robust, 1, true, threads}));
    for (const int packet : {8, 16}) contenders.push_back(embree_contender(scene, {robust, packet, true, threads}));
  }
}

/// strahl's own and, where it is there, Embree's in two qualities; in turns.
void measure_trees(Traversal& all, const Device& device, const Scene& scene, std::size_t primitives,
                   const TraversalOptions& options) {
  std::vector<Tree> trees{{scene.name, primitives, "strahl", {}, 0}};
  if (options.peers && has_embree()) {
    trees.push_back({scene.name, primitives, "Embree medium", {}, 0});
    trees.push_back({scene.name, primitives, "Embree high", {}, 0});
  }
  for (int round = 0; round < std::min(options.rounds, tree_rounds); ++round) {
    const RunStats stats = Intersector(device, scene, RenderSettings{}).stats();
    if (stats.tree.nodes == 0) return;
    trees[0].seconds.push_back(stats.seconds.bvh);
    trees[0].sah_cost = stats.tree.sah_cost;
    for (std::size_t i = 1; i < trees.size(); ++i) {
      const PeerTree peer = embree_tree(scene, i == 2, options.threads, static_cast<unsigned>(stats.lanes));
      trees[i].seconds.push_back(peer.seconds);
      trees[i].sah_cost = peer.sah_cost;
    }
  }
  all.trees.insert(all.trees.end(), trees.begin(), trees.end());
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

Scene bench_scene(const std::string& name, const std::function<void(const std::string&)>& say) {
  if (name.find_first_of("./") == std::string::npos) return generated_scene(name);
  LoadedScene loaded = load_scene(name);
  for (const Diagnostic& warning : loaded.warnings) say(warning.text());
  Scene& scene = loaded.scene;
  if (!scene.instances.empty())
    throw SceneError(
        {{Severity::error, scene.instances.front().where,
          "the programs that strahl is compared with are given shapes, not instances; choose a scene without"}});
  scene.film.width = scene.film.height = 1024;
  add_missing_point_light(scene);
  return std::move(loaded.scene);
}

Traversal measure_traversal(const Device& device, const TraversalOptions& asked,
                            const std::function<void(const std::string&)>& say) {
  TraversalOptions options = asked;
  if (options.tiers.empty()) {
    options.tiers = {Precision::robust, Precision::stable, Precision::fast};
    if (device.info().fp64) options.tiers.push_back(Precision::fp64);
  }
  if (options.threads == 0) options.threads = hardware_threads();
  Traversal all{device.info().text(), machine(), STRAHL_VERSION, options.threads, options.rounds, {}, {}};
  for (const std::string& name : options.scenes) {
    Scene scene = bench_scene(name, say);
    scene.film.width = scene.film.height = options.pixels;
    std::size_t primitives = 0;
    for (const Shape& shape : scene.shapes) primitives += static_cast<std::size_t>(primitive_count(shape));
    say(fmt::format("{}, trees", name));
    measure_trees(all, device, scene, primitives, options);
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
      one.scene = scene.name;
      one.primitives = primitives;
      all.races.push_back(std::move(one));
    }
  }
  return all;
}

}  // namespace strahl::bench
