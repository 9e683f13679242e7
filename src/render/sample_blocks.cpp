// SPDX-License-Identifier: MIT
#include "render/sample_blocks.h"

#include <algorithm>
#include <bit>

namespace strahl {

SampleBlocks SampleBlocks::of_sequence(int samples) {
  const int newest = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(samples - 1, 1))));
  SampleBlocks blocks;
  blocks.first_ = {newest / 4, newest / 2, newest};
  return blocks;
}

std::array<int, SampleBlocks::count> SampleBlocks::sizes(int samples) const {
  std::array<int, count> sizes{};
  for (int k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (are_consecutive())
      sizes[i] = std::max(0, (k + 1 < count ? std::min(samples, first_[i]) : samples) - first(k));
    else
      sizes[i] = (samples - k + count - 1) / count;
  }
  return sizes;
}

int SampleBlocks::of(int sample) const {
  return static_cast<int>(std::count_if(first_.begin(), first_.end(), [&](int first) { return sample >= first; }));
}

}  // namespace strahl
