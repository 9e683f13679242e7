// SPDX-License-Identifier: MIT
#include "cli/picture_metadata.h"

#include <fmt/format.h>

namespace strahl::cli {

std::map<std::string, std::string> metadata_of(const RenderOptions& options, const Invocation& invocation,
                                               const RunStats& stats) {
  std::map<std::string, std::string> metadata{
      {"Software", "strahl " STRAHL_VERSION}, {"command", invocation.command_line},
      {"scene", options.scene.path},          {"device", stats.device},
      {"precision", stats.precision},         {"spp", std::to_string(stats.spp)},
      {"seed", std::to_string(stats.seed)},
  };
  if (stats.texture_lod) metadata["texture_lod"] = "true";
  if (!stats.disabled.empty()) metadata["disabled"] = fmt::format("{}", fmt::join(stats.disabled, ", "));
  return metadata;
}

std::map<std::string, std::string> metadata_of(const RenderOptions& options, const Invocation& invocation,
                                               const RenderResult& result) {
  std::map<std::string, std::string> metadata = metadata_of(options, invocation, result.stats);
  if (result.stats.error) metadata["rmse"] = rmse_text(result.stats.error->noise);
  if (!result.complete) metadata["incomplete"] = "interrupted";
  return metadata;
}

std::string rmse_text(const ErrorEstimate& noise) {
  return fmt::format("{:.4g} ({:.4g} to {:.4g})", noise.rmse, noise.rmse_low, noise.rmse_high);
}

}  // namespace strahl::cli
