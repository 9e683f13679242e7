// SPDX-License-Identifier: MIT
// What measure_effects found, for people and for programs.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/effects.h"
#include "bench/race.h"
#include "json_text.h"

namespace strahl::bench {
namespace {

using Json = nlohmann::ordered_json;

Json times(const VariantTimes& times) {
  return {{"program", times.program},
          {"program_bytes", times.bytes},
          {"build_seconds", times.build_seconds},
          {"kernel_seconds", times.kernel_seconds},
          {"specialised_seconds", times.first_seconds}};
}

double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return median(ratios);
}

std::string frames(double count) { return std::isfinite(count) ? fmt::format("{:.0f}", std::ceil(count)) : "never"; }

}  // namespace

std::string json(const Effects& effects) {
  Json scenes = Json::array(), spheres = Json::array();
  for (const SceneEffects& row : effects.scenes)
    scenes.push_back({{"scene", row.scene},
                      {"picture", {row.width, row.height, row.spp}},
                      {"timed", {row.study.width, row.study.height, row.study.spp}},
                      {"specialised", times(row.study.variants[0])},
                      {"generic", times(row.study.variants[1])},
                      {"without_sums", times(row.without_sums())}});
  for (const TenSpheres& row : effects.spheres)
    spheres.push_back({{"precision", precision_name(row.precision)},
                       {"lanes", row.lanes},
                       {"pixels", row.pixels},
                       {"scalar_differs", row.scalar_differs},
                       {"strahl", row.strahl},
                       {"minimal_lanes", row.minimal_lanes},
                       {"minimal_scalar", row.minimal_scalar},
                       {"generic", row.generic}});
  const Json all{{"device", effects.device},
                 {"strahl", effects.version},
                 {"rounds", effects.rounds},
                 {"generic_build_seconds", effects.generic.build_seconds},
                 {"generic_program_bytes", effects.generic.bytes},
                 {"ten_spheres", spheres},
                 {"scenes", scenes}};
  return json_text(all);
}

std::string markdown(const Effects& effects) {
  std::string text;
  if (!effects.scenes.empty())
    text = fmt::format(
        "{}; medians of {} rounds. The generic program: {:.2f} s to build, {:.0f} KiB.\n\n"
        "| scene | picture | specialised, s | generic, s | generic : specialised | build, s | KiB | pays off after "
        "frames | "
        "sub-sums add |\n|---|---|--:|--:|--:|--:|--:|--:|--:|\n",
        effects.device, effects.rounds, effects.generic.build(), static_cast<double>(effects.generic.bytes) / 1024);
  for (const SceneEffects& row : effects.scenes) {
    const VariantTimes& own = row.study.variants[0];
    const double seconds = row.whole(own), factor = row.study.variants[1].ratio();
    text += fmt::format("| {} | {} × {} × {} | {:.3g} | {:.3g} | {:.2f} | {:.2f} | {:.0f} | {} | {:+.1f} % |\n",
                        row.scene, row.width, row.height, row.spp, seconds, seconds * factor, factor, own.build(),
                        static_cast<double>(own.bytes) / 1024, frames(row.break_even()), 100 * row.sums_cost());
  }
  text +=
      "\n| ten glowing spheres, 1024 × 1024 | strahl, ms | minimal kernel, ms | strahl : minimal | generic : strahl |\n"
      "|---|--:|--:|--:|--:|\n";
  for (const TenSpheres& row : effects.spheres)
    text += fmt::format("| {}, {} lanes | {:.1f} | {:.1f} ({}) | {:.3f} | {:.2f} |\n", precision_name(row.precision),
                        row.lanes, 1e3 * median(row.strahl), 1e3 * median(row.minimal()),
                        row.is_scalar_faster() ? "scalar loop" : "lanes", ratio(row.strahl, row.minimal()),
                        ratio(row.generic, row.strahl));
  return text;
}

}  // namespace strahl::bench
