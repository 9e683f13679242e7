// SPDX-License-Identifier: MIT
#include "program/path_lanes.h"

#include <fmt/format.h>

#include <algorithm>

#include "program/kernel_files.h"

namespace strahl {

bool has_packet_body(const std::string& shape_kind) {
  const std::string text = kernel_files().at(fmt::format("shapes/{0}/{0}_lanes.h", shape_kind));
  return text.find(fmt::format("PACKET_BODY_{}_w = PACKET_BODY_NONE", shape_kind)) == std::string::npos;
}

int path_lanes(const Features& features, const RenderSettings& settings, int lanes) {
  // Where the device may end loops samples are counted one after the other.
  if (settings.precision == Precision::fp64 || settings.loop_turns) return 1;
  if (settings.paths_in_lanes) return *settings.paths_in_lanes ? lanes : 1;
  const auto& kinds = features.entries.at("shapes");
  if (settings.precision != Precision::robust && !std::all_of(kinds.begin(), kinds.end(), has_packet_body)) return 1;
  return features.entries.at("samplers").empty() && !features.flag("PIXEL_FILTER") ? 1 : lanes;
}

}  // namespace strahl
