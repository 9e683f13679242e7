// SPDX-License-Identifier: MIT
#include "cli/render_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cli/console.h"
#include "cli/output_file.h"
#include "cli/picture_metadata.h"
#include "cli/progress_bar.h"
#include "cli/render_files.h"
#include "cli/summary.h"
#include "cli/watchdog.h"
#include "json_text.h"
#include "render/film_state.h"
#include "render/median.h"
#include "render/pass_plan.h"

namespace strahl::cli {
namespace {

double late_seconds(double time) { return 1.02 * time + 0.0005; }

/// What --stats says of a frame.
struct FrameStats {
  double seconds;
  int least_spp, most_spp;
  std::optional<double> rmse;
};

nlohmann::ordered_json json_of(const std::vector<FrameStats>& frames) {
  auto all = nlohmann::ordered_json::array();
  for (const FrameStats& frame : frames)
    all.push_back({{"seconds", frame.seconds},
                   {"least_spp", frame.least_spp},
                   {"most_spp", frame.most_spp},
                   {"rmse", frame.rmse ? nlohmann::ordered_json(*frame.rmse) : nullptr}});
  return all;
}

/// Frames held against --max-error, each as a picture by itself (render_goal.h).
class ErrorGoal {
 public:
  explicit ErrorGoal(std::optional<double> max_error) : max_error_(max_error) {}

  void add(const RenderResult& frame) {
    if (!max_error_) return;
    ++count_;
    if (!frame.error) ++unknown_;
    if (!frame.error || is_reached(*frame.error, *max_error_)) return;
    ++above_;
    if (frame.error->rmse_high > worst_.rmse_high) worst_ = *frame.error;
  }
  /// Why it is not reached.
  [[nodiscard]] std::optional<std::string> missed() const {
    if (above_ + unknown_ == 0) return std::nullopt;
    std::string text = fmt::format("--max-error {}: missed in {} of {} frames", *max_error_, above_ + unknown_, count_);
    if (above_ > 0)
      text += fmt::format("; the largest error is {:.2g} (95 %: up to {:.2g})", worst_.rmse, worst_.rmse_high);
    if (unknown_ > 0) text += fmt::format("; in {} it is not known", unknown_);
    return text;
  }

 private:
  std::optional<double> max_error_;
  int count_ = 0, above_ = 0, unknown_ = 0;
  ErrorEstimate worst_{};
};

}  // namespace

ExitCode render_frames(Renderer& renderer, const RenderOptions& options, const Invocation& invocation,
                       const PictureFiles& files, std::uint32_t first_seed, const InterruptGuard& guard) {
  const double time = duration_seconds(*options.goal.time);
  std::vector<FrameStats> frames;
  std::vector<double> seconds;
  int late = 0, black = 0;
  ErrorGoal error_goal(options.goal.max_error);
  UnusualSamples all;
  std::string interrupted;
  ProgressBar bar("frames", !options.scene.quiet && !options.scene.no_progress);
  std::exception_ptr fault;  // Of a frame; what is known of those before it is told first.
  const auto render_frame = [&](int frame) {
    RenderGoal goal;
    goal.spp = options.overrides.spp;
    goal.max_error = options.goal.max_error;
    goal.seed = first_seed + static_cast<std::uint32_t>(frame);
    const Clock::time_point start = Clock::now();
    goal.deadline = later(start, time);
    Watchdog watchdog(options.keep.watchdog ? duration_seconds(*options.keep.watchdog, "--watchdog") : 0,
                      [] { return std::string("the frames so far are there"); });
    FilmKeeper film_keeper;
    film_keeper.launches = [&](bool are_under_way) { are_under_way ? watchdog.fed() : watchdog.rest(); };
    const RenderResult result = renderer.render(
        [&](const Progress&) {
          watchdog.fed();
          return !guard.interrupted();
        },
        goal, &film_keeper);
    PictureFiles one = files;
    one.path = frame_path(files.path, frame + 1);
    const std::map<std::string, std::string> metadata = metadata_of(options, invocation, result);
    const double taken = std::chrono::duration<double>(Clock::now() - start).count();
    static_cast<void>(write(one, result, metadata, true));
    if (!result.complete) {  // As any interrupted picture; it is none of the frames that times are told of.
      interrupted = one.path;
      return;
    }
    seconds.push_back(taken);
    if (taken > late_seconds(time)) ++late;
    if (result.stats.least_spp == 0) ++black;
    error_goal.add(result);
    all += result.stats.unusual;
    // A job of a million frames should not take more and more memory for what nobody asks.
    if (!options.stats.empty())
      frames.push_back({taken, result.stats.least_spp, result.stats.most_spp,
                        result.error ? std::optional(result.error->rmse) : std::nullopt});
    bar.show(static_cast<double>(frame + 1) / *options.goal.frames, one.path);
  };
  try {
    for (int frame = 0; frame < *options.goal.frames && !guard.interrupted() && interrupted.empty(); ++frame)
      render_frame(frame);
  } catch (...) {
    fault = std::current_exception();
  }
  warn_of_samples(all);
  const int count = static_cast<int>(seconds.size());
  if (!options.stats.empty())
    write_text(options.stats, json_text(nlohmann::ordered_json{
                                  {"time", time}, {"in_time", count - late}, {"frames", json_of(frames)}}));
  if (!options.scene.quiet && count > 0)
    say(fmt::format("{} of {} frames within {}: median {:.1f} ms, longest {:.1f} ms · {} …", count - late, count,
                    *options.goal.time, 1e3 * median(seconds), 1e3 * *std::max_element(seconds.begin(), seconds.end()),
                    frame_path(files.path, 1)));
  if (!options.scene.quiet && !interrupted.empty())
    say(fmt::format("{}: interrupted, with the samples so far", interrupted));
  if (fault) std::rethrow_exception(fault);
  if (count < *options.goal.frames) return guard.exit_code();
  if (black > 0)
    say(fmt::format("strahl: --time {}: in {} of {} frames some pixels have no sample and are black",
                    *options.goal.time, black, count));
  const std::optional<std::string> missed = error_goal.missed();
  if (missed) say("strahl: " + *missed);
  return late * 20 > count || black > 0 || missed ? ExitCode::target_missed : ExitCode::ok;
}

}  // namespace strahl::cli
