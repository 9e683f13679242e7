// SPDX-License-Identifier: MIT
#include "settings/require_settings.h"

#include <fmt/format.h>

#include "errors.h"

namespace strahl {
namespace {

void require_widths(const RenderSettings& settings) {
  const bool is_double = settings.precision == Precision::fp64;
  const char* const in_double = is_double ? " in double" : "";
  if (settings.lanes && !is_lane_count(*settings.lanes, settings.precision))
    throw UsageError(
        fmt::format("lanes is {}{}; it can be {}", *settings.lanes, in_double, is_double ? "1 or 8" : "1, 8 or 16"));
  if (!settings.bvh_width) return;
  const int width = *settings.bvh_width, tested = lanes_of_tree(width);
  if (!is_tree_width(width, settings.precision))
    throw UsageError(
        fmt::format("bvh_width is {}{}; it can be {}", width, in_double, is_double ? "2, 4 or 8" : "2, 4, 8 or 16"));
  if (settings.lanes && *settings.lanes != tested)
    throw UsageError(fmt::format("a bvh_width of {} tests {} at a time, and lanes is {}: state one of them", width,
                                 tested, *settings.lanes));
}

}  // namespace

bool is_lane_count(int lanes, Precision precision) {
  return lanes == 1 || lanes == 8 || (lanes == 16 && precision != Precision::fp64);
}

bool is_tree_width(int width, Precision precision) {
  return width == 2 || width == 4 || width == 8 || (width == 16 && precision != Precision::fp64);
}

void require_settings(const RenderSettings& settings) {
  require_widths(settings);
  if (settings.passes && *settings.passes < 1)
    throw UsageError(fmt::format("passes is {}; samples are split into 1 or more", *settings.passes));
  for (const Aov aov : settings.aovs.plain())
    if (!is_of_first_sample(aov))
      throw UsageError(
          fmt::format("the AOV {} is of all samples of a pixel, and has a layer only by a name: add it as "
                      "NamedAov{{\"name\", Aov::{}}}",
                      aov_name(aov), aov_name(aov)));
  if (const std::vector<std::string> faults = aov_faults(settings.aovs.named()); !faults.empty())
    throw UsageError(faults.front());
}

}  // namespace strahl
