// SPDX-License-Identifier: MIT
// A pilot render before the render begins: it measures the time of samples and how the error falls with their number.
#pragma once

#include <cstdint>
#include <functional>

#include "render/prediction.h"
#include "render/renderer.h"

namespace strahl {

struct Pilot {
  std::vector<Look> looks;       ///< In the order of their samples; none with fewer than 4 samples.
  std::vector<PassCost> passes;  ///< Of the whole picture, though only a part may have been rendered.
  double spread = 0;             ///< Relative standard deviation of their seconds.
  double common_spread = 0;      ///< Of the looks' errors, caused by differences between the rows that were rendered.
  double look_seconds = 0;       ///< To read the film of the whole picture and estimate its error.
  double seconds = 0;            ///< That the pilot took.
  double share = 1;              ///< Of the picture's rows that it looked at.
  std::uint64_t not_finite = 0;  ///< Samples that were saturated or not a number: then errors are not known.
  double mean = 0;               ///< Of the values of the latest look, all channels alike.
};

/// Renders the whole picture with few samples, then with four times as many and so on, while that is quick; else some
/// of its rows, evenly spread, and some of them with four times as many. most_spp: more samples are of no use; no
/// more than Renderer::most_samples(). most_seconds: the time that the pilot may take, from what is known so far. It
/// ends within one launch of that, but renders at least three parts of the picture.
[[nodiscard]] Pilot run_pilot(Renderer& renderer, int most_spp,
                              const std::function<double(const Pilot&)>& most_seconds);

}  // namespace strahl
