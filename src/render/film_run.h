// SPDX-License-Identifier: MIT
// One picture: passes of samples over bands of rows that fit a device buffer, each in launches that LaunchPlan keeps
// short, until the goal holds.
#pragma once

#include <functional>
#include <memory>
#include <set>

#include "render/device_film.h"
#include "render/film_state.h"
#include "render/renderer_state.h"
#include "stopwatch.h"

namespace strahl {

class FilmRun {
 public:
  /// sums: of a part of a picture on several devices, for part(): how the whole divides its samples.
  FilmRun(Renderer::State& state, const RenderGoal& goal, const ProgressCallback& progress, const FilmKeeper* keeper,
          std::optional<SubSums> sums = std::nullopt);
  [[nodiscard]] RenderResult run();

 private:
  /// The film of several devices is on the host.
  [[nodiscard]] bool is_shared() const { return !is_part_ && !state_.helpers.empty(); }
  [[nodiscard]] bool is_one_band() const { return !is_shared() && band_rows_ >= height_; }
  [[nodiscard]] std::size_t film_bytes(std::size_t pixels) const {
    return pixels * film_.words_per_pixel() * sizeof(std::int64_t);
  }
  /// From the members before film_.
  [[nodiscard]] FilmSums black_film() const;
  [[nodiscard]] int end_of_samples() const;
  [[nodiscard]] double seconds_left() const;
  [[nodiscard]] bool report();
  void tell_launches(bool are_under_way) const {
    if (keeper_ != nullptr && keeper_->launches) keeper_->launches(are_under_way);
  }
  void clear(int rows, bool aovs_too);
  void write_header();
  bool render_pass(const Pass& pass);
  bool render_all_of(const Launch& all);
  /// The band from `row` on is the one that launches fill.
  void begin_rows(int row);
  void end_band();
  /// Of one device among several (film_shared.cpp): this run's part of the picture, as far as it came.
  struct Part {
    FilmState state;
    RunStats stats;
    bool is_cut = false;  ///< By the deadline.
  };
  class Table;
  [[nodiscard]] Rows rows_of_part(const Launch& launch) const;
  [[nodiscard]] Part part(const Launch& launch);
  [[nodiscard]] Part part_on(Renderer::State& device, const Launch& launch, const ProgressCallback& progress) const;
  bool render_shared(const Launch& all);
  bool deal(const Launch& all);
  void work_at(Table& table, std::size_t worker);
  void add(const Part& part, const Launch& launch, std::size_t worker);
  [[nodiscard]] Renderer::State& device_of(std::size_t worker) const;
  [[nodiscard]] Renderer::State& living_device() const;
  [[nodiscard]] std::string all_faults() const;
  /// Takes over an earlier run's film and renders the pass that was under way to its end, or where time or an error is
  /// the goal only what brings all pixels as far as the farthest; false as render_pass.
  bool go_on_from(const FilmState& state);
  bool catch_up(int least, int level);
  bool render_missing(int end);
  void begin_band();
  [[nodiscard]] FilmState state_now();
  /// The film so far, to its keeper.
  void give(const std::function<void(FilmState)>& keep, bool is_last);
  /// Work-items of a launch whose loops the device has ended; `stuck`: those of them that have no sample more.
  struct Unfinished {
    std::uint32_t cut, stuck;
  };
  /// One launch by `start`, its seconds and what it has counted.
  Unfinished count(const std::function<void()>& start);
  /// Renderer::State::launch or launch_sharing.
  using Kernel = void (Renderer::State::*)(const Launch&, const Rows&);
  void launch_to_end(const Launch& launch, Kernel kernel);
  /// Samples that other pixels' samples are made of, and those of the launch.
  void launch_shared(const Launch& launch);
  /// Kernel seconds.
  double launch_and_count(const Launch& launch);
  /// What the device has of a band that is not fetched yet.
  [[nodiscard]] std::vector<std::int64_t> band_words() const;
  void read_aovs(int row, int rows);
  /// Rows of the film from `first` on, behind the one above them where there is one.
  struct FilmPart {
    std::unique_ptr<const MappedWords> on_device;  ///< Their words; none: they are in film_.
    FilmRows rows;
    int first = 0;
  };
  [[nodiscard]] FilmPart part_at(int first, int count) const;
  /// In any order, several at a time, on as many threads (render/film_parts.h).
  void each_part(const std::function<void(const FilmPart&)>& use) const;
  void finish();
  /// The AOVs, once finish() has made the picture.
  void put_aovs(const std::set<Aov>& plain);
  [[nodiscard]] bool tell_numeric_error();
  [[nodiscard]] Renderer::State::End end() const;
  void measure_end();
  [[nodiscard]] double end_seconds();

  Stopwatch construction_;
  Renderer::State& state_;
  RenderGoal goal_;
  const ProgressCallback& progress_;
  const FilmKeeper* keeper_;  ///< Or none.
  bool is_part_;
  SubSums sums_;
  int width_, height_, band_rows_;
  int end_;  ///< Samples are rendered up to here.
  PassPlan passes_;
  FilmSums film_;  ///< Without words where the film is one band: it stays on the device.
  std::vector<double> aov_reals_;
  std::vector<std::int32_t> aov_ints_;
  double sample_seconds_ = 0;       ///< What one sample of every pixel took in the last pass.
  bool is_cut_ = false;             ///< The deadline ended a pass part-way.
  Rows band_;                       ///< That is on the device and not fetched yet; of one band, while it is rendered.
  bool has_first_samples_ = false;  ///< They are rendered in this pass.
  double samples_before_ = 0;       ///< Of all pixels, in the film that it began with.
  std::uint64_t under_way_ = 0;     ///< Samples of several devices that are not in the film yet.
  /// When samples have to be done, so that the picture is there by the goal's deadline.
  std::optional<Clock::time_point> samples_until_;
  Stopwatch watch_;
  RenderResult result_;
  Image squares_;  ///< As result_.color, of the second moments.
};

}  // namespace strahl
