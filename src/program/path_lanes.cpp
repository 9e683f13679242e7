// SPDX-License-Identifier: MIT
#include "program/path_lanes.h"

namespace strahl {

int path_lanes(const Features& features, const RenderSettings& settings, int lanes) {
  // Where the device may end loops samples are counted one after the other.
  if (settings.loop_turns) return 1;
  if (settings.paths_in_lanes) return *settings.paths_in_lanes ? lanes : 1;
  return features.entries.at("samplers").empty() && !features.flag("PIXEL_FILTER") ? 1 : lanes;
}

}  // namespace strahl
