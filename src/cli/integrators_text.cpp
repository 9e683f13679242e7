// SPDX-License-Identifier: MIT
#include "cli/integrators_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string time_text(const IntegratorCost& cost) {
  if (!cost.has_finite_samples) return "not known: samples were not finite";
  if (!cost.seconds || !cost.spp) return "no noise seen";
  if (cost.is_beyond_film)
    return fmt::format("more than {:.3g} s: {:.3g} spp, all that the film holds, are too few", cost.seconds->middle,
                       cost.spp->middle);
  return fmt::format("{:.3g} s ({:.2g} to {:.2g}), {:.3g} spp", cost.seconds->middle, cost.seconds->low,
                     cost.seconds->high, cost.spp->middle);
}

Json range_json(const std::optional<Range>& range) {
  return range ? Json{{"low", range->low}, {"middle", range->middle}, {"high", range->high}} : Json(nullptr);
}

}  // namespace

std::string integrators_text(const IntegratorCosts& costs) {
  std::string text = fmt::format(
      "integrators: until the RMSE is {:.3g}, {:.3g} of the mean, building aside; by pilots of {:.3g} s each, {} x {}; "
      "what is rare a pilot may not have seen\n",
      costs.rmse, costs.share, costs.pilot_seconds, costs.width, costs.height);
  for (const IntegratorCost& cost : costs.integrators) {
    if (!cost.refused.empty()) {
      text += fmt::format("  {:<8}  refused: {}\n", cost.integrator, cost.refused);
      continue;
    }
    std::string line =
        fmt::format("  {:<8}  {:<36}  {:.3g} s a sample", cost.integrator, time_text(cost), cost.sample_seconds);
    if (!cost.misses.empty()) line += fmt::format("  misses or finds with noise: {}", fmt::join(cost.misses, "; "));
    text += line + "\n";
  }
  return text;
}

Json integrators_json(const IntegratorCosts& costs) {
  Json rows = Json::array();
  for (const IntegratorCost& cost : costs.integrators) {
    const bool is_measured = cost.refused.empty();
    rows.push_back({{"integrator", cost.integrator},
                    {"refused", is_measured ? Json(nullptr) : Json(cost.refused)},
                    {"misses", cost.misses},
                    {"build_seconds", cost.build_seconds ? Json(*cost.build_seconds) : Json(nullptr)},
                    {"sample_seconds", is_measured ? Json(cost.sample_seconds) : Json(nullptr)},
                    {"mean", is_measured ? Json(cost.mean) : Json(nullptr)},
                    {"has_finite_samples", is_measured ? Json(cost.has_finite_samples) : Json(nullptr)},
                    {"seconds", range_json(cost.seconds)},
                    {"spp", range_json(cost.spp)},
                    {"is_beyond_film", is_measured ? Json(cost.is_beyond_film) : Json(nullptr)}});
  }
  return {{"rmse", costs.rmse},   {"share", costs.share},   {"pilot_seconds", costs.pilot_seconds},
          {"width", costs.width}, {"height", costs.height}, {"confidence", prediction_confidence},
          {"integrators", rows}};
}

}  // namespace strahl::cli
