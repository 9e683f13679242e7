// SPDX-License-Identifier: MIT
// A picture under way, or a part of one, as a file (docs/decisions/0029-checkpoints.md).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "checkpoint/identity.h"
#include "render/film_state.h"
#include "scene/model/aovs.h"

namespace strahl {

/// All of a checkpoint but its arrays: enough to say whether it fits.
struct CheckpointHeader {
  PictureIdentity identity;
  std::map<std::string, std::string> metadata;  ///< Of the picture that it becomes.
  std::vector<std::string> aovs;                ///< By strahl's names.
  std::vector<NamedAov> named_aovs;             ///< Those that the scene has named.
  bool is_length = false;                       ///< The picture's values are distances.
  int spp = 0;                                  ///< Samples of the whole picture; 0: an open goal.
  int least = 0, most = 0;                      ///< Samples of a pixel in the film.
  int first_sample = 0;                         ///< As the film's.
};

struct Checkpoint {
  CheckpointHeader header;  ///< least, most and first_sample are those of the film: told_of_film().
  FilmState state;

  /// Takes over what the header says of the film.
  void told_of_film();
};

/// Complete and on the disk, or as it was. Throws Error.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Throws InputError: it cannot be read, is none, is cut short, is damaged.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);
/// The same without reading the arrays, whose damage does not show.
[[nodiscard]] CheckpointHeader read_checkpoint_header(const std::string& path);

}  // namespace strahl
