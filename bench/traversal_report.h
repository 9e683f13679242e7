// SPDX-License-Identifier: MIT
// What measure_traversal found, for people.
#pragma once

#include <map>

#include "bench/traversal.h"

namespace strahl::bench {

/// Tables: for every scene and kind of rays each of strahl's variants against each peer's, and what the tiers cost.
/// Shows the plots of `plots`, expected in the folder `plot_folder`.
[[nodiscard]] std::string markdown(const Traversal& traversal, const std::map<std::string, std::string>& plots,
                                   const std::string& plot_folder);

/// SVG by file name: Mrays/s against primitives for every family of scenes of several sizes, ratios to the peers, what
/// the tiers cost.
[[nodiscard]] std::map<std::string, std::string> traversal_plots(const Traversal& traversal);

}  // namespace strahl::bench
