// SPDX-License-Identifier: MIT
// A prediction in words.
#include <fmt/format.h>

#include <algorithm>

#include "cli/dry_run.h"

namespace strahl::cli {
namespace {

/// The interval, or one number where both ends read alike.
std::string range_text(const Range& range, const char* format) {
  const std::string low = fmt::format(fmt::runtime(format), range.low),
                    high = fmt::format(fmt::runtime(format), range.high);
  return low == high ? low : low + " to " + high;
}

std::string why_unpredicted(const Prediction& prediction, const Pilot& pilot) {
  if (pilot.not_finite > 0) return "samples of the pilot were not finite";
  if (prediction.spp.middle < 4) return "a pixel has fewer than 4 samples";
  return "the pilot had no time for 4 samples of a pixel";
}

}  // namespace

double pilot_seconds(double render_seconds) { return std::max(1.0, 0.1 * render_seconds); }

std::string prediction_text(const Prediction& prediction, const Pilot& pilot) {
  if (!prediction.has_end)
    return fmt::format("time     not known: {}, and the error alone ends the render; state --spp or --time\n",
                       why_unpredicted(prediction, pilot));
  std::string text = fmt::format("time     {} s, likely {:.2f} s\nsamples  {} a pixel, likely {:.0f}\n",
                                 range_text(prediction.seconds, "{:.2f}"), prediction.seconds.middle,
                                 range_text(prediction.spp, "{:.0f}"), prediction.spp.middle);
  text += prediction.rmse ? fmt::format("error    RMSE {}, likely {:.2g}\n", range_text(*prediction.rmse, "{:.2g}"),
                                        prediction.rmse->middle)
                          : fmt::format("error    not known: {}\n", why_unpredicted(prediction, pilot));
  return text + fmt::format("Each interval is to hold in {:.0f} of 100 runs on a machine as busy as now.\n",
                            100 * prediction_confidence);
}

}  // namespace strahl::cli
