// SPDX-License-Identifier: MIT
// A scene on a device, ready to become pictures.
#pragma once

#include <functional>
#include <memory>

#include "image/image.h"
#include "opencl/device.h"
#include "render/error_estimate.h"
#include "render/goal.h"
#include "render/stats.h"
#include "scene/model/scene.h"
#include "settings/sampling.h"
#include "settings/settings.h"

namespace strahl {

/// After each launch. samples_done / samples_total count pixel samples.
struct Progress {
  std::uint64_t samples_done = 0;
  std::uint64_t samples_total = 0;  ///< Expected, where a deadline or an error is the goal; 0: not known yet.
  double seconds = 0;               ///< Since the first launch.
};

/// Called between launches; returning false finishes the render with what there is.
using ProgressCallback = std::function<bool(const Progress&)>;

struct RenderResult {
  Image color;  ///< R, G, B, linear, size of the crop window. A pixel without samples (interrupted) is black.
  /// Layered channels ("depth.Z", "normal.X", ...); no channels where no AOV was asked for, or the part of the samples
  /// (RenderGoal::samples) begins behind a pixel's first, whose values they are.
  Image aov;
  /// Those that the scene has named (AovList::named()), in layers of these names; of such a part those of all samples.
  Image named_aov;
  /// Why `aov` lacks numeric_error, which was asked for; empty: nothing failed.
  std::string numeric_error_fault;
  /// R, G, B of each pixel's standard error, NaN where it is not known; no channels unless asked for.
  Image standard_error;
  /// Of `color`; none where a pixel has too few samples, a sample was infinite or no number (RunStats), or nobody wants
  /// it (RenderSettings::estimate_error).
  std::optional<ErrorEstimate> error;
  RunStats stats;
  Ending ending = Ending::samples;
  bool complete = true;  ///< false: the callback stopped it.
};

class FilmRun;
struct FilmKeeper;

class Renderer {
 public:
  /// Validates, packs, builds the program and uploads. The device is trusted with settings.precision and
  /// settings.loop_turns: ask choose_tier() (trust/tier_choice.h) for both, else a device whose arithmetic is wrong or
  /// that ends loops makes wrong pictures without a word. Throws SceneError, DeviceError, KernelBuildError; UsageError
  /// for settings that cannot be (settings/settings.h, a needed effect in `disabled`, an unknown `light_choice`, a work
  /// group that the device has not, what light paths do not know); NoDeviceError where the device's memory cannot hold
  /// the scene and one row of the film, or Aov::numeric_error is asked of a device without fp64 or without room for the
  /// scene in it.
  Renderer(const Device& device, Scene scene, const RenderSettings& settings = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Another device, which takes a share of every picture from now on, as large as its measured speed. A device of
  /// several that fails is dropped for good: the others do its part (RunStats::shares), and the picture has the same
  /// bits; Error where none is left.
  /// loop_turns: its RenderSettings::loop_turns, of its own tier_verdict(). Throws as the constructor, and UsageError
  /// where devices decide bits: in `fast` and `stable`.
  void share_with(const Device& device, std::optional<std::uint64_t> loop_turns = std::nullopt);

  /// Throws UsageError for more samples than the film holds, SceneError where they are the scene's, and where camera,
  /// film, sampler or integrator cannot be: what is otherwise found out once the program is built.
  static void require_samples(const Scene& scene, const RenderSettings& settings, const RenderGoal& goal);

  /// The most samples a pixel that the film holds.
  [[nodiscard]] int most_samples() const;
  [[nodiscard]] static int most_samples(const Scene& scene, const RenderSettings& settings);

  /// Each call renders the picture from the start. One call at a time, for a renderer has one film: UsageError for one
  /// from the callback or from another thread; other renderers may render beside it. Throws as require_samples,
  /// UsageError for a goal that cannot be reached (RenderGoal), NoDeviceError where the device ends loops before a
  /// sample is done (RenderSettings::loop_turns). keeper, whose header is not installed (render/film_state.h): gets the
  /// film now and then, or gives one to go on from; InputError where that is of another picture.
  [[nodiscard]] RenderResult render(const ProgressCallback& progress = {}, const RenderGoal& goal = {},
                                    const FilmKeeper* keeper = nullptr);

  [[nodiscard]] const Scene& scene() const;
  /// Of the preparations; each render's own go on from them.
  [[nodiscard]] const RunStats& stats() const;
  /// How the samples are divided among a pixel's sums: "4 sums in turns of 8". Films that differ in it do not add up.
  [[nodiscard]] std::string division_text(const RenderGoal& goal) const;

  /// What the film takes at the most, on the device as in a checkpoint.
  [[nodiscard]] std::size_t film_bytes_per_pixel() const;

  /// The exact program: text with includes expanded, options in its first comment line.
  [[nodiscard]] std::string program_text() const;

  /// Whether a renderer of this scene would find its program in the cache; else building one may take seconds. Throws
  /// SceneError and UsageError as the constructor.
  [[nodiscard]] static bool is_program_cached(const Device& device, const Scene& scene, const RenderSettings& settings);

  /// What compiling the program took, the driver's part at the first launch included; none where it was cached.
  [[nodiscard]] std::optional<double> build_seconds() const;
  /// Loads the program from the cache as a later process would, to measure the time; false: it is not there.
  bool load_program_again() const;

 private:
  struct State;
  friend class FilmRun;
  std::unique_ptr<State> state_;
};

}  // namespace strahl
