// SPDX-License-Identifier: MIT
#include "cli/keep_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "cli/render_options.h"
#include "errors.h"

namespace strahl::cli {

void add_keep_options(CLI::App& app, KeepOptions& options) {
  const std::string group = "So that nothing is lost";
  app.add_option("--checkpoint", options.checkpoint,
                 "Keep the samples so far in this file, now and then and at the end; for --resume and `merge`")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--every", options.every, "How often, as 10s or 5m; 60s without it")->type_name("TIME")->group(group);
  app.add_option("--resume", options.resume,
                 "Go on from this checkpoint; the same scene and options give the bits of one run. It is written on "
                 "to, unless --checkpoint names another")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--samples", options.samples,
                 "Only samples A to B - 1 of every pixel: a part for `strahl merge`; a picture of it only with -o")
      ->type_name("A:B")
      ->group(group);
  app.add_option("--watchdog", options.watchdog,
                 "End the process where the device does not come back from a launch for so long, as 5m; launches are "
                 "planned to take a quarter of a second at the most")
      ->type_name("TIME")
      ->group(group);
  app.add_option("--snapshot-every", options.snapshot_every,
                 "Write the picture so far beside the picture (out.snapshot.png), as 30s; SIGUSR1 does so once")
      ->type_name("TIME")
      ->group(group);
}

double KeepOptions::every_seconds() const { return duration_seconds(every.value_or("60s"), "--every"); }

void check_keeping(const RenderOptions& options) {
  const KeepOptions& keep = options.keep;
  static_cast<void>(keep.every_seconds());
  if (keep.snapshot_every) static_cast<void>(duration_seconds(*keep.snapshot_every, "--snapshot-every"));
  if (keep.watchdog) static_cast<void>(duration_seconds(*keep.watchdog, "--watchdog"));
  const bool is_kept = !keep.target().empty();
  // Whoever asks for this believes that something is kept.
  if (keep.every && !is_kept)
    throw UsageError("--every says how often a checkpoint is written: name it with --checkpoint");
  if (keep.snapshot_every && options.goal.frames)
    throw UsageError("--snapshot-every shows a picture under way, and --frames are finished within their time");
  if (keep.snapshot_every && !options.writes_picture())
    throw UsageError("--snapshot-every writes beside the picture, and none is written: name it with -o");
  if (is_kept && options.goal.frames) throw UsageError("--frames renders many pictures, a checkpoint is of one");
  if ((is_kept || keep.snapshot_every) && options.goal.dry_run)
    throw UsageError("--dry-run makes no picture, so there is nothing to keep");
  if (keep.watchdog && options.goal.dry_run)
    throw UsageError("--watchdog watches the launches of a picture, and --dry-run makes none");
  if (!keep.samples) return;
  if (!is_kept) throw UsageError("--samples makes a part for `strahl merge`: name its file with --checkpoint");
  static_cast<void>(sample_range(*keep.samples));
  if (options.goal.time || options.goal.max_error)
    throw UsageError(
        "--samples takes a part of a known number of samples (--spp); with --time or --max-error it is not known");
  if (options.kernel.asks_for("numeric_error"))
    throw UsageError("--aov numeric_error traces the scene again, which `merge` has not; render it by itself");
}

SampleRange sample_range(const std::string& text) {
  const char* const end = text.data() + text.size();
  int first = -1, past = -1;
  auto at = std::from_chars(text.data(), end, first);
  if (at.ec == std::errc() && at.ptr != end && *at.ptr == ':') at = std::from_chars(at.ptr + 1, end, past);
  if (at.ec != std::errc() || at.ptr != end || first < 0 || past <= first)
    throw UsageError(fmt::format("--samples takes A:B, the samples A <= i < B, as 64:128, not \"{}\"", text));
  return {first, past - first};
}

}  // namespace strahl::cli
