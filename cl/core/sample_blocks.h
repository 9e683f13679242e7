// SPDX-License-Identifier: MIT
// Which of a pixel's sums in the film a sample adds to. A sampler whose samples are independent fills them in turns; of
// one sequence they hold consecutive blocks, whose spread tells the sequence's error (render/block_law.h). The picture
// does not depend on it.
#ifndef STRAHL_CORE_SAMPLE_BLOCKS_H
#define STRAHL_CORE_SAMPLE_BLOCKS_H

#include "scene/scene.h"

typedef struct {
  int sums;
  int second, third, fourth;  ///< Each block's first sample; second is -1 where the sums are filled in turns.
} SampleBlocks;

FN SampleBlocks sample_blocks(const Scene* scene) {
  GLOBAL const int* index = scene->index;
  SampleBlocks blocks;
  blocks.sums = index[HEADER_SUMS];
  blocks.second = index[HEADER_BLOCKS];
  blocks.third = index[HEADER_BLOCKS + 1];
  blocks.fourth = index[HEADER_BLOCKS + 2];
  return blocks;
}

FN int block_of(const SampleBlocks* blocks, int sample) {
  if (blocks->second < 0) return sample & (blocks->sums - 1);
  return (sample >= blocks->second) + (sample >= blocks->third) + (sample >= blocks->fourth);
}

/// How many of the first `samples` samples are in that block.
FN int samples_in_block(const SampleBlocks* blocks, int block, int samples) {
  if (blocks->second < 0) return (samples - block + blocks->sums - 1) / blocks->sums;
  int first = block == 0 ? 0 : (block == 1 ? blocks->second : (block == 2 ? blocks->third : blocks->fourth));
  int end = block == 0 ? blocks->second : (block == 1 ? blocks->third : (block == 2 ? blocks->fourth : samples));
  return max(min(samples, end) - first, 0);
}

#endif
