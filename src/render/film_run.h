// SPDX-License-Identifier: MIT
// One picture: passes of samples over bands of rows that fit a device buffer, each in launches that LaunchPlan keeps
// short, until the goal holds.
#pragma once

#include "render/renderer_state.h"
#include "stopwatch.h"

namespace strahl {

class FilmRun {
 public:
  FilmRun(Renderer::State& state, const RenderGoal& goal, const ProgressCallback& progress);
  [[nodiscard]] RenderResult run();

 private:
  [[nodiscard]] bool is_one_band() const { return band_rows_ >= height_; }
  [[nodiscard]] bool is_read_in_parts() const { return film_.words.empty(); }
  [[nodiscard]] std::size_t film_bytes(std::size_t pixels) const {
    return pixels * film_.words_per_pixel() * sizeof(std::int64_t);
  }
  /// From the members before film_.
  [[nodiscard]] FilmSums black_film() const;
  [[nodiscard]] double seconds_left() const;
  [[nodiscard]] bool report();
  void clear(int rows, bool aovs_too);
  bool render_pass(const Pass& pass);
  bool render_band(const Pass& pass, int row, int rows);
  /// Work-items of a launch whose loops the device has ended; `stuck`: those of them that have no sample more.
  struct Unfinished {
    std::uint32_t cut, stuck;
  };
  Unfinished launch_once(const Launch& launch, int band_row);
  void launch_to_end(const Launch& launch, int band_row);
  /// Kernel seconds.
  double launch_and_count(const Launch& launch, int band_row);
  void read_band(int row, int rows);
  void read_aovs(int row, int rows);
  void read_film();
  [[nodiscard]] Image mean_in_parts() const;
  void finish();
  void measure_finish();

  Stopwatch construction_;
  Renderer::State& state_;
  RenderGoal goal_;
  const ProgressCallback& progress_;
  int width_, height_, band_rows_, spp_;
  PassPlan passes_;
  FilmSums film_;
  std::vector<double> aov_reals_;
  std::vector<std::int32_t> aov_ints_;
  double sample_seconds_ = 0;  ///< What one sample of every pixel took in the last pass.
  bool is_cut_ = false;        ///< The deadline ended a pass part-way.
  Stopwatch watch_;
  RenderResult result_;
};

}  // namespace strahl
