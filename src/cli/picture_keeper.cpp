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

/// What an action threw; empty: nothing.
template <class Action>
std::string fault_of(const Action& action) {
  try {
    action();
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
    resumed_ = read_checkpoint(options_.resume);
    const std::string difference = header_.identity.difference_from(resumed_->header.identity);
    if (!difference.empty())
      throw InputError(
          fmt::format("--resume \"{}\": it is of another picture: {}; restore that, or render without "
                      "--resume",
                      options_.resume, difference));
    if (resumed_->header.first_sample != header_.first_sample)
      throw InputError(fmt::format("--resume \"{}\": its samples begin at {} and not at {}; state the same --samples",
                                   options_.resume, resumed_->header.first_sample, header_.first_sample));
    film_keeper_.begin_with = &resumed_->state;
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
  if (now.checkpoint) since_checkpoint_ = {};
  if (now.snapshot) since_snapshot_ = {};
  if (now.snapshot) snapshot_is_taken();
  const auto checkpoint = std::make_shared<Checkpoint>(Checkpoint{header_, std::move(state)});
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

void PictureKeeper::write(const Checkpoint& checkpoint, Due due) {
  if (due.checkpoint) checkpoint_fault_ = fault_of([&] { write_checkpoint(options_.target(), checkpoint); });
  if (due.checkpoint && !checkpoint_fault_.empty())
    say(fmt::format("strahl: warning: {}; an earlier checkpoint stays as it was, and the render goes on",
                    checkpoint_fault_));
  if (!due.snapshot) return;
  snapshot_fault_ = fault_of([&] {
    PictureFiles files = picture_;
    files.path = path_beside(picture_.path, "snapshot");
    std::map<std::string, std::string> metadata = header_.metadata;
    metadata["incomplete"] = "snapshot";
    // As of a finished picture: the samples that are asked for, or where their number is open, the most that there are.
    if (checkpoint.header.spp == 0) metadata["spp"] = std::to_string(checkpoint.header.most);
    static_cast<void>(cli::write(files, picture_of(checkpoint), metadata, true));
  });
  if (!snapshot_fault_.empty()) say(fmt::format("strahl: warning: {}; the render goes on", snapshot_fault_));
}

std::optional<std::string> PictureKeeper::finish() {
  wait();
  if (last_) {
    Checkpoint checkpoint{header_, std::move(*last_)};
    last_.reset();
    checkpoint.told_of_film();
    checkpoint_fault_ = fault_of([&] { write_checkpoint(options_.target(), checkpoint); });
  }
  if (!checkpoint_fault_.empty()) return checkpoint_fault_;
  if (!snapshot_fault_.empty()) return snapshot_fault_;
  return std::nullopt;
}

}  // namespace strahl::cli
