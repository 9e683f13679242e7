// SPDX-License-Identifier: MIT
// Checkpoints and snapshots of a render under way, written by a thread of their own
// (docs/decisions/0029-checkpoints.md).
#pragma once

#include <atomic>
#include <future>
#include <map>
#include <optional>
#include <string>

#include "checkpoint/checkpoint.h"
#include "cli/keep_options.h"
#include "cli/picture_files.h"
#include "stopwatch.h"

namespace strahl::cli {

class PictureKeeper {
 public:
  /// picture: where a snapshot goes beside; without a path none is written. Reads what is to be resumed and compares it
  /// with `header`; throws InputError where it does not fit.
  PictureKeeper(KeepOptions options, PictureFiles picture, CheckpointHeader header);

  /// For Renderer::render; as long as this lives.
  [[nodiscard]] const FilmKeeper& film_keeper() const { return film_keeper_; }
  /// To be said where the render ends here and now: where its samples are. From any thread.
  [[nodiscard]] std::string what_is_kept() const;
  /// Once the film is done: the last checkpoint. What could not be written, or none.
  [[nodiscard]] std::optional<std::string> finish();

 private:
  struct Due {
    bool checkpoint, snapshot;
  };
  [[nodiscard]] Due due() const;
  void keep(FilmState state);
  void keep_nothing(bool is_last);
  void warn_of_checkpoint() const;
  void warn_of_snapshot() const;
  [[nodiscard]] std::string snapshot_path() const;
  void write_kept(const Checkpoint& checkpoint);
  void write(const Checkpoint& checkpoint, Due due);
  [[nodiscard]] bool is_writing() const;
  void wait();

  KeepOptions options_;
  PictureFiles picture_;
  CheckpointHeader header_;
  double every_, snapshot_every_;  ///< Seconds.
  std::optional<FilmState> last_;
  /// Written, or resumed from: the next one takes its memory. The system takes long to find as much anew.
  FilmState spare_;
  std::atomic<bool> is_written_ = false;  ///< A checkpoint, by this run.
  FilmKeeper film_keeper_;
  Stopwatch since_checkpoint_, since_snapshot_;
  std::string checkpoint_fault_, snapshot_fault_;  ///< Of the latest that was written; empty: it is there.
  std::future<void> writing_;                      ///< The last member: its end is waited for before the others go.
};

}  // namespace strahl::cli
