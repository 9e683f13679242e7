// SPDX-License-Identifier: MIT
#include "cli/picture_keeper.h"

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "checkpoint/picture.h"
#include "cli/console.h"
#include "cli/goal_options.h"
#include "cli/interrupt.h"

namespace strahl::cli {
namespace {

std::string no_memory_for(const std::string& path, const char* what) {
  return fmt::format("cannot write \"{}\": no memory is left for {}; end other programs", path, what);
}

/// What writing a file threw; empty: nothing.
template <class Write>
std::string fault_of(const std::string& path, const Write& write) {
  try {
    write();
  } catch (const std::bad_alloc&) {
    return no_memory_for(path, "its bytes");
  } catch (const std::exception& fault) {
    return fault.what();
  }
  return {};
}

}  // namespace

PictureKeeper::PictureKeeper(KeepOptions options, PictureFiles picture, CheckpointHeader header)
    : options_(std::move(options)),
      picture_(std::move(picture)),
      header_(std::move(header)),
      every_(options_.every_seconds()),
      snapshot_every_(options_.snapshot_every ? duration_seconds(*options_.snapshot_every, "--snapshot-every")
                                              : std::numeric_limits<double>::infinity()) {
  if (!options_.resume.empty()) {
    Checkpoint resumed = read_checkpoint(options_.resume);
    const std::string difference = header_.identity.difference_from(resumed.header.identity);
    if (!difference.empty())
      throw InputError(
          fmt::format("--resume \"{}\": it is of another picture: {}; restore that, or render without "
                      "--resume",
                      options_.resume, difference));
    if (resumed.header.first_sample != header_.first_sample)
      throw InputError(fmt::format("--resume \"{}\": its samples begin at {} and not at {}; state the same --samples",
                                   options_.resume, resumed.header.first_sample, header_.first_sample));
    // Read before the first launch, and of no use after it.
    spare_ = std::move(resumed.state);
    film_keeper_.begin_with = &spare_;
  }
  film_keeper_.is_due = [this] {
    const Due now = due();
    return now.checkpoint || now.snapshot;
  };
  film_keeper_.spare = [this] {
    wait();
    return std::move(spare_);
  };
  film_keeper_.keep = [this](FilmState state) { keep(std::move(state)); };
  if (!options_.target().empty()) film_keeper_.keep_last = [this](FilmState state) { last_ = std::move(state); };
  film_keeper_.no_memory = [this](bool is_last) { keep_nothing(is_last); };
}

bool PictureKeeper::is_writing() const {
  return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

PictureKeeper::Due PictureKeeper::due() const {
  Due due{!options_.target().empty() && since_checkpoint_.seconds() >= every_,
          !picture_.path.empty() && (since_snapshot_.seconds() >= snapshot_every_ || wants_snapshot())};
  if ((due.checkpoint || due.snapshot) && is_writing()) due = {false, false};
  return due;
}

void PictureKeeper::wait() {
  if (writing_.valid()) writing_.get();
}

void PictureKeeper::keep(FilmState state) {
  wait();
  const Due now = due();
  const auto checkpoint = std::make_shared<Checkpoint>(Checkpoint{header_, std::move(state)});
  if (now.checkpoint) since_checkpoint_ = {};
  if (now.snapshot) since_snapshot_ = {};
  if (now.snapshot) snapshot_is_taken();
  const auto write_now = [this, now, checkpoint] {
    checkpoint->told_of_film();
    write(*checkpoint, now);
    spare_ = std::move(checkpoint->state);
  };
  try {
    writing_ = std::async(std::launch::async, write_now);
  } catch (const std::system_error&) {  // No thread can be begun: the render waits for the disk.
    write_now();
  }
}

/// Tried again when the next one is due: memory may be there by then.
void PictureKeeper::keep_nothing(bool is_last) {
  wait();
  const Due now = is_last ? Due{true, false} : due();
  if (now.checkpoint) {
    since_checkpoint_ = {};
    checkpoint_fault_ = no_memory_for(options_.target(), "a copy of the film");
    if (!is_last) warn_of_checkpoint();
  }
  if (!now.snapshot) return;
  since_snapshot_ = {};
  snapshot_is_taken();
  snapshot_fault_ = no_memory_for(snapshot_path(), "a copy of the film");
  warn_of_snapshot();
}

void PictureKeeper::warn_of_checkpoint() const {
  say(fmt::format("strahl: warning: {}; an earlier checkpoint stays as it was, and the render goes on",
                  checkpoint_fault_));
}

void PictureKeeper::warn_of_snapshot() const {
  say(fmt::format("strahl: warning: {}; the render goes on", snapshot_fault_));
}

std::string PictureKeeper::snapshot_path() const { return path_beside(picture_.path, "snapshot"); }

void PictureKeeper::write_kept(const Checkpoint& checkpoint) {
  checkpoint_fault_ = fault_of(options_.target(), [&] { write_checkpoint(options_.target(), checkpoint); });
  if (checkpoint_fault_.empty()) is_written_ = true;
}

void PictureKeeper::write(const Checkpoint& checkpoint, Due due) {
  if (due.checkpoint) write_kept(checkpoint);
  if (due.checkpoint && !checkpoint_fault_.empty()) warn_of_checkpoint();
  if (!due.snapshot) return;
  snapshot_fault_ = fault_of(snapshot_path(), [&] {
    PictureFiles files = picture_;
    files.path = snapshot_path();
    std::map<std::string, std::string> metadata = header_.metadata;
    metadata["incomplete"] = "snapshot";
    // As of a finished picture: the samples that are asked for, or where their number is open, the most that there are.
    if (checkpoint.header.spp == 0) metadata["spp"] = std::to_string(checkpoint.header.most);
    static_cast<void>(cli::write(files, picture_of(checkpoint), metadata, true));
  });
  if (!snapshot_fault_.empty()) warn_of_snapshot();
}

std::optional<std::string> PictureKeeper::finish() {
  wait();
  if (last_) {
    Checkpoint checkpoint{header_, std::move(*last_)};
    last_.reset();
    checkpoint.told_of_film();
    write_kept(checkpoint);
  }
  if (!checkpoint_fault_.empty()) return checkpoint_fault_;
  if (!snapshot_fault_.empty()) return snapshot_fault_;
  return std::nullopt;
}

std::string PictureKeeper::what_is_kept() const {
  if (options_.target().empty()) return "nothing was kept: --checkpoint would have";
  const std::string& kept = is_written_ ? options_.target() : options_.resume;
  if (kept.empty()) return "nothing was kept: no checkpoint was written yet (--every)";
  return fmt::format("\"{}\" has the last checkpoint, --resume goes on from there", kept);
}

}  // namespace strahl::cli
