// SPDX-License-Identifier: MIT
#include "bench/effect_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "json_text.h"
#include "program/disabled.h"
#include "program/features.h"
#include "scene/loader.h"

namespace strahl::bench {
namespace {

constexpr int row_pixels = 64;
constexpr int row_samples = 256;

/// Small, with samples enough for a launch to take a while.
Scene small(Scene scene) {
  const double scale = static_cast<double>(row_pixels) / std::max(scene.film.width, scene.film.height);
  scene.film.width = std::max(8, static_cast<int>(std::lround(scale * scene.film.width)));
  scene.film.height = std::max(8, static_cast<int>(std::lround(scale * scene.film.height)));
  scene.film.crop.reset();
  scene.sampler.sample_count = row_samples;
  return scene;
}

std::string last_part(const std::string& effect) { return effect.substr(effect.rfind('/') + 1); }

/// Scene file -> the effects that are measured by it.
std::map<std::string, std::set<std::string>> chosen(const std::vector<std::string>& scenes) {
  std::map<std::string, std::string> scene_of;
  for (const std::string& path : scenes) {
    const std::string stem = std::filesystem::path(path).stem().string();
    for (const FeatureReport& row : features_of(load_scene(path).scene, {}).report) {
      if (!row.on || !needed_because(row.name).empty()) continue;
      const bool has_its_name = stem == last_part(row.name);
      if (has_its_name || !scene_of.contains(row.name)) scene_of[row.name] = path;
    }
  }
  std::map<std::string, std::set<std::string>> effects_of;
  for (const auto& [effect, path] : scene_of) effects_of[path].insert(effect);
  return effects_of;
}

}  // namespace

std::vector<EffectRow> measure_effect_rows(const Device& device, const EffectsOptions& options,
                                           const EffectsProgress& progress) {
  std::vector<EffectRow> rows;
  VariantRounds rounds;
  rounds.builds = 1;
  rounds.frames = options.rounds;
  rounds.frame_seconds = options.frame_seconds;
  if (device.info().type == "CPU") rounds.clock = StudyClock::processor;
  for (const auto& [path, effects] : chosen(options.scenes)) {
    const std::string name = path.starts_with(options.folder) ? path.substr(options.folder.size()) : path;
    progress(fmt::format("{}: {}", name, fmt::join(effects, ", ")));
    const EffectCosts costs = measure_effects(device, small(load_scene(path).scene), {}, rounds, {}, effects);
    for (const auto& [effect, cost] : costs.effects) {
      rows.push_back({effect, name, costs.study.variants.front(), cost});
      rows.back().own.color = {};
    }
  }
  std::sort(rows.begin(), rows.end(), [](const EffectRow& a, const EffectRow& b) { return a.effect < b.effect; });
  return rows;
}

std::string json(const std::vector<EffectRow>& rows, const Device& device) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const EffectRow& row : rows)
    all.push_back({{"effect", row.effect},
                   {"scene", row.scene},
                   {"kernel_seconds", row.own.kernel()},
                   {"build_seconds", row.own.build()},
                   {"program_bytes", row.own.bytes},
                   {"private_bytes", row.own.private_bytes},
                   {"adds",
                    {{"kernel_seconds", row.cost.kernel_seconds},
                     {"kernel_share", row.cost.kernel_share},
                     {"build_seconds", row.cost.build_seconds},
                     {"program_bytes", row.cost.program_bytes},
                     {"private_bytes", row.cost.private_bytes}}},
                   {"needed", row.cost.needed},
                   {"frame_needed", row.cost.frame_needed}});
  const Json whole{{"device", device.info().text()}, {"strahl", STRAHL_VERSION}, {"effects", all}};
  return json_text(whole);
}

std::string markdown(const std::vector<EffectRow>& rows, const Device& device) {
  std::string text = fmt::format(
      "{}; {}.\n\n| effect | scene | kernels, ms | without it | build, s | without it | KiB | without it | private "
      "bytes | "
      "without it |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
      device.info().text(), device.info().type == "CPU" ? "seconds of the processor" : "seconds of the clock");
  for (const EffectRow& row : rows) {
    if (!row.cost.needed.empty()) continue;
    const double kernel = 1e3 * row.own.kernel(), bytes = static_cast<double>(row.own.bytes);
    const std::string less =
        row.cost.frame_needed.empty()
            ? fmt::format("{:.1f} ({:+.0f} %)", kernel * (1 - row.cost.kernel_share), -100 * row.cost.kernel_share)
            : "black";
    text += fmt::format("| {} | {} | {:.1f} | {} | {:.2f} | {:.2f} | {:.0f} | {:.0f} | {} | {:.0f} |\n", row.effect,
                        row.scene, kernel, less, row.own.build(), row.own.build() - row.cost.build_seconds,
                        bytes / 1024, (bytes - row.cost.program_bytes) / 1024, row.own.private_bytes,
                        static_cast<double>(row.own.private_bytes) - row.cost.private_bytes);
  }
  return text;
}

}  // namespace strahl::bench
