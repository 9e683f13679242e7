// SPDX-License-Identifier: MIT
// The spread of a film's consecutive blocks: for each pixel the contrasts of every block with those before it, and what
// they add up to over the picture.
#pragma once

#include <array>
#include <vector>

#include "render/block_law.h"
#include "render/sample_blocks.h"

namespace strahl {

struct FilmSums;

/// Contrasts of a pixel of so many samples: coefficients of the blocks' sums, newest block first.
struct BlockContrasts {
  std::array<std::array<double, SampleBlocks::count>, BlockSpread::contrasts> coefficient{};
  std::array<bool, BlockSpread::contrasts> is_measured{};

  BlockContrasts(const SampleBlocks& blocks, int samples);
  [[nodiscard]] int measured() const;
};

struct FilmSpread {
  BlockSpread spread;
  double freedom = 0;         ///< Degrees of freedom that relative_variance is known with.
  std::vector<float> shares;  ///< Of each pixel and channel in the squared error; their sum is 1, or all are 0.
};

/// The film's blocks are consecutive. Without shares where a pixel's samples are all in one block.
[[nodiscard]] FilmSpread spread_of(const FilmSums& film);

}  // namespace strahl
