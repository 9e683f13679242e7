// SPDX-License-Identifier: MIT
// Which samples each of a pixel's sums in the film holds (cl/core/sample_blocks.h does it on the device).
//
// Independent samples are added in turns: four sums that are alike. Of one sequence the sums hold consecutive blocks:
// its newest octave [2^k, 2^(k+1)), as far as it is there, the two octaves before it, and all before those. When the
// next octave begins, the two oldest blocks become one and a sum is free. So a render whose end nobody knows keeps
// the same blocks as one whose number of samples is known.
#pragma once

#include <array>

#include "device/cl_layout.h"

namespace strahl {

class SampleBlocks {
 public:
  static constexpr int count = layout::FILM_SUBSUMS;

  /// In turns.
  SampleBlocks() = default;
  /// Consecutive blocks of `samples` >= 1 samples.
  static SampleBlocks of_sequence(int samples);

  [[nodiscard]] bool are_consecutive() const { return first_[0] >= 0; }
  /// Samples in each block after `samples` of them.
  [[nodiscard]] std::array<int, count> sizes(int samples) const;
  /// Of consecutive blocks: where block `block` begins.
  [[nodiscard]] int first(int block) const { return block == 0 ? 0 : first_[static_cast<std::size_t>(block) - 1]; }
  /// Of consecutive blocks: which holds the sample.
  [[nodiscard]] int of(int sample) const;
  /// As the kernels read them: HEADER_BLOCKS and what follows.
  [[nodiscard]] const std::array<int, count - 1>& header() const { return first_; }

  bool operator==(const SampleBlocks&) const = default;

 private:
  std::array<int, count - 1> first_{-1, -1, -1};
};

}  // namespace strahl
