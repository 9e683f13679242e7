// SPDX-License-Identifier: MIT
// A launch of samples, to its end on devices that end loops too, and what it counted.
#include <fmt/format.h>

#include "errors.h"
#include "render/film_run.h"

namespace strahl {

FilmRun::Unfinished FilmRun::count(const std::function<void()>& launch) {
  RunStats& run = result_.stats;
  const std::vector<std::uint32_t> zero(layout::COUNTERS, 0);
  write_buffer(state_.device, state_.counters, zero.data(), zero.size() * sizeof(std::uint32_t));
  const Stopwatch start;
  launch();
  const double seconds = start.seconds();
  run.add_launch(seconds);
  run.seconds.kernel += seconds;
  std::vector<std::uint32_t> counted(layout::COUNTERS);
  read_buffer(state_.device, state_.counters, counted.data(), counted.size() * sizeof(std::uint32_t));
  run.unusual += {counted[layout::COUNT_SATURATED], counted[layout::COUNT_INVALID], counted[layout::COUNT_BRANCHES],
                  counted[layout::COUNT_LOST_BRANCHES], counted[layout::COUNT_INTERFACES]};
  if (state_.settings.count_rays) {
    *run.shadow_rays += counted[layout::COUNT_SHADOW];
    *run.bounce_rays += counted[layout::COUNT_BOUNCE];
    *run.nodes_visited += counted[layout::COUNT_NODES];
    *run.primitives_tested += counted[layout::COUNT_PRIMITIVES];
  }
  return {counted[layout::COUNT_CUT], counted[layout::COUNT_STUCK]};
}

/// Work-items continue where an earlier launch stopped. Where none makes progress, a part of them is launched alone,
/// because work-items that run in step share their turns.
void FilmRun::launch_to_end(const Launch& launch, Kernel kernel) {
  const auto once = [&] { return count([&] { (state_.*kernel)(launch, band_); }); };
  Unfinished left = once();
  while (left.cut > left.stuck) left = once();
  if (left.cut == 0) return;
  Launch first = launch, second = launch;
  if (launch.columns > 1) {
    first.columns = launch.columns / 2;
    second.columns -= first.columns;
    second.column_first += first.columns;
  } else if (launch.rows > 1) {
    first.rows = launch.rows / 2;
    second.rows -= first.rows;
    second.row_first += first.rows;
  } else {
    throw NoDeviceError(fmt::format(
        "{} ends the loops of a work-item after {} turns, and a sample of pixel {}, {} takes more; choose another "
        "device (-d), a smaller max_depth (--max-depth) or fewer shapes",
        state_.device.info().text(), state_.settings.loop_turns.value_or(0), state_.window.x0 + launch.column_first,
        state_.window.y0 + launch.row_first));
  }
  launch_to_end(first, kernel);
  launch_to_end(second, kernel);
}

void FilmRun::launch_shared(const Launch& launch) {
  for (const Launch& part : state_.ring->parts(launch, state_.ring_memory())) {
    const auto whole = [&](const Launch& pixels, Kernel kernel) {
      state_.begin_ring();
      launch_to_end(pixels, kernel);
    };
    if (const Launch missing = state_.missing_samples(part); missing.rows > 0) whole(missing, &Renderer::State::launch);
    state_.ring->filled();
    whole(part, &Renderer::State::launch_sharing);
  }
}

double FilmRun::launch_and_count(const Launch& launch) {
  RunStats& run = result_.stats;
  const double before = run.seconds.kernel;
  if (state_.ring)
    launch_shared(launch);
  else
    launch_to_end(launch, &Renderer::State::launch);
  film_.add_samples(launch);
  run.camera_rays += static_cast<std::uint64_t>(launch.columns) * static_cast<std::uint64_t>(launch.rows) *
                     static_cast<std::uint64_t>(launch.samples);
  return run.seconds.kernel - before;
}

}  // namespace strahl
