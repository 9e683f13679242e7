// SPDX-License-Identifier: MIT
// All that a picture under way consists of: what another run needs to go on from it, here or elsewhere, or to add it to
// other parts of the same picture (docs/decisions/0029-checkpoints.md).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kinds/upload_frame.h"
#include "render/film.h"
#include "render/pass_plan.h"
#include "render/unusual_samples.h"

namespace strahl {

struct FilmState {
  FilmSums film;
  PassPosition position;
  UnusualSamples unusual;
  std::vector<double> aov_reals;       ///< As aov_image takes them; empty where no AOV was asked for.
  std::vector<std::int32_t> aov_ints;  ///< -1 where there is none yet.
  UploadFrame frame;
};

/// Who keeps the film of a picture while it is rendered.
struct FilmKeeper {
  const FilmState* begin_with = nullptr;  ///< What an earlier run has kept, read before the first launch; none: black.
  std::function<void(bool are_under_way)> launches;  ///< Told before launches, and before the host goes on alone.
  std::function<bool()> is_due;                      ///< Asked after each launch.
  std::function<void(FilmState)> keep;               ///< Then, with what there is. The render waits for it.
  std::function<FilmState()> spare;                  ///< Whose memory the next film to be kept takes; none: new memory.
  std::function<void(FilmState)> keep_last;          ///< At the end, whatever ended the render.
  std::function<void(bool is_last)> no_memory;  ///< Instead of keep or keep_last; none: std::bad_alloc ends the render.
  std::function<void()> is_done;                ///< Then: no launch fills the film any more, and it has been read.
};

}  // namespace strahl
