// SPDX-License-Identifier: MIT
// Statistics of a run as the JSON object of docs/stats.md.
#include "render/stats.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "json_text.h"

namespace strahl {
namespace {

using Json = nlohmann::ordered_json;

Json count_or_null(const std::optional<std::uint64_t>& count) { return count ? Json(*count) : Json(nullptr); }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json canary_or_null(const std::optional<CanaryStats>& canary) {
  if (!canary) return nullptr;
  return {{"verdict", canary->verdict}, {"why", text_or_null(canary->why)}, {"instead", text_or_null(canary->instead)}};
}

/// error_budget.h
Json error_or_null(const std::optional<ErrorBudget>& error) {
  if (!error) return nullptr;
  return {{"rmse", error->rmse()},
          {"rmse_low", error->rmse_low()},
          {"rmse_high", error->rmse_high()},
          {"relmse", error->noise.relmse},
          {"budget",
           {{"noise", error->noise.rmse},
            {"output", error->output},
            {"clipping", error->clipping},
            {"float_rounding", error->rounding ? Json(*error->rounding) : Json(nullptr)}}}};
}

Json shares_of(const std::vector<DeviceShare>& shares) {
  if (shares.empty()) return nullptr;
  Json all = Json::array();
  for (const DeviceShare& share : shares)
    all.push_back({{"device", share.device},
                   {"samples", share.samples},
                   {"seconds", share.seconds},
                   {"fault", text_or_null(share.fault)}});
  return all;
}

}  // namespace

double RunStats::longest_launch() const {
  return kernel_runs.empty() ? 0 : std::max(longest_of_more, *std::max_element(kernel_runs.begin(), kernel_runs.end()));
}

void RunStats::add_launch(double run_seconds) {
  if (kernel_runs.size() < most_kept_runs) return kernel_runs.push_back(run_seconds);
  ++more_runs;
  longest_of_more = std::max(longest_of_more, run_seconds);
}

void RunStats::add_launches(const RunStats& part) {
  for (const double run_seconds : part.kernel_runs) add_launch(run_seconds);
  more_runs += part.more_runs;
  longest_of_more = std::max(longest_of_more, part.longest_of_more);
}

std::string RunStats::json() const {
  Json json;
  json["seconds"] = {
      {"start", seconds.start},
      {"exit", seconds.exit},
      {"device", seconds.device},
      {"load", seconds.load},
      {"bvh", seconds.bvh},
      {"program", seconds.program},
      {"upload", seconds.upload},
      {"kernel", seconds.kernel},
      {"surface", seconds.surface},
      {"readback", seconds.readback},
      {"error", seconds.error},
      {"encode", seconds.encode},
      {"other", std::max(0.0, seconds.other())},
      {"total", seconds.total},
  };
  json["kernel_runs"] = kernel_runs;
  json["launches"] = launches();
  json["longest_launch"] = longest_launch();
  json["rays"] = {
      {"camera", camera_rays}, {"shadow", count_or_null(shadow_rays)}, {"bounce", count_or_null(bounce_rays)}};
  json["weak_branches"] = unusual.weak_branches;
  json["lost_branches"] = unusual.lost_branches;
  json["lost_interfaces"] = unusual.lost_interfaces;
  json["visits"] = {{"nodes", count_or_null(nodes_visited)}, {"primitives", count_or_null(primitives_tested)}};
  json["bytes"] = {{"device", device_bytes}, {"host", host_bytes}};
  json["device"] = device;
  json["shares"] = shares_of(shares);
  json["precision"] = precision;
  json["canary"] = canary_or_null(canary);
  json["lanes"] = lanes;
  json["path_lanes"] = path_lanes;
  json["tree"] = {{"width", tree_width},
                  {"primitives", tree.primitives},
                  {"nodes", tree.nodes},
                  {"leaves", tree.leaves},
                  {"sah_cost", tree.sah_cost},
                  {"bytes", tree.bytes},
                  {"bytes_per_primitive",
                   tree.primitives > 0 ? Json(static_cast<double>(tree.bytes) / static_cast<double>(tree.primitives))
                                       : Json(nullptr)}};
  json["spp"] = spp;
  json["least_spp"] = least_spp;
  json["most_spp"] = most_spp;
  json["ending"] = text_or_null(ending);
  json["error"] = error_or_null(error);
  json["clipped_pixels"] = clipped_pixels ? Json(*clipped_pixels) : Json(nullptr);
  json["seed"] = seed;
  json["features"] = features;
  json["texture_lod"] = texture_lod;
  json["disabled"] = disabled;
  json["program"] = program;
  json["program_bytes"] = program_bytes;
  json["program_from_cache"] = program_from_cache;
  json["saturated_samples"] = unusual.saturated;
  json["invalid_samples"] = unusual.invalid;
  // A device may name itself in any encoding; JSON is UTF-8. Non-finite numbers become null.
  return json_text(json);
}

}  // namespace strahl
