// SPDX-License-Identifier: MIT
// What a Renderer holds; only its own files see it.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "errors.h"
#include "kinds/integrators.h"
#include "opencl/program.h"
#include "opencl/tuned_width.h"
#include "packing/cl_layout.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "render/device_film.h"
#include "render/film.h"
#include "render/launch_plan.h"
#include "render/launch_shape.h"
#include "render/pass_plan.h"
#include "render/renderer.h"
#include "render/sample_ring.h"
#include "render/traversal_choice.h"

namespace strahl {

/// The window of some of its rows, while this lives.
class RowsOnly {
 public:
  RowsOnly(Window& window, const Rows& rows) : window_(window), whole_(window) {
    window.y0 += rows.first;
    window.y1 = window.y0 + rows.count;
  }
  ~RowsOnly() { window_ = whole_; }
  RowsOnly(const RowsOnly&) = delete;
  RowsOnly& operator=(const RowsOnly&) = delete;

 private:
  Window& window_;
  Window whole_;
};

/// A picture that is being made, while this lives: a renderer has one film.
class OneAtATime {
 public:
  /// Throws UsageError where there is another.
  explicit OneAtATime(std::atomic<bool>& is_rendering) : is_rendering_(is_rendering) {
    if (is_rendering_.exchange(true))
      throw UsageError(
          "Renderer::render() was called while it makes a picture, by its callback or another thread: make another "
          "Renderer for that");
  }
  ~OneAtATime() { is_rendering_ = false; }
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

 private:
  std::atomic<bool>& is_rendering_;
};

struct Renderer::State {
  Device device;
  std::shared_ptr<const Scene> shared_scene;  ///< Of all devices that make the same pictures.
  const Scene& scene;
  RenderSettings settings;
  Features features;
  ProgramSource source;
  std::optional<ProgramSource> sharing_source;  ///< Where pixels share samples.
  /// Found once: it looks at every shape. The textbook's renderer keeps world coordinates, with all their rounding.
  UploadFrame frame;
  ResolvedSampling sampling{};
  Window window;
  SceneBuffers buffers;
  cl::Kernel kernel;
  RunStats stats;  ///< What construction took; render() starts from it.

  State(const Device& d, std::shared_ptr<const Scene> s, const RenderSettings& r)
      : device(d),
        shared_scene(std::move(s)),
        scene(*shared_scene),
        settings(r),
        frame(r.precision == Precision::fast ? UploadFrame{} : camera_frame(scene)) {}

  /// Radiance is the same in every frame, unless the picture is a length.
  [[nodiscard]] double radiance_unit() const {
    return kinds::integrator(scene.integrator.name).is_length ? 1 / frame.scale : 1;
  }
  [[nodiscard]] bool has_aov() const { return features.flag("AOV"); }
  [[nodiscard]] bool has_squares() const { return features.flag("MOMENT"); }
  [[nodiscard]] std::size_t real_bytes() const { return settings.precision == Precision::fp64 ? 8 : 4; }
  [[nodiscard]] std::size_t aov_real_bytes(std::size_t pixels) const {
    return has_aov() ? pixels * layout::AOV_REALS * real_bytes() : 0;
  }
  [[nodiscard]] std::size_t aov_int_bytes(std::size_t pixels) const {
    return has_aov() ? pixels * layout::AOV_INTS * sizeof(std::int32_t) : 0;
  }

  /// Light paths may end anywhere, so their film is on the device as a whole.
  [[nodiscard]] FilmKind film_kind() const {
    return kinds::integrator(scene.integrator.name).from_lights ? FilmKind::splats : FilmKind::pixels;
  }
  /// Each sample counts in all pixels that the filter reaches.
  [[nodiscard]] bool shares_samples() const { return features.flag("SHARED_SAMPLES"); }
  [[nodiscard]] bool has_own_sums() const { return kinds::integrator(scene.integrator.name).from_camera; }
  [[nodiscard]] std::size_t film_bytes_per_pixel(int sums) const {
    FilmShape pixel{film_kind(), 1, 1, {}, 0, 1, has_squares(), has_own_sums()};
    pixel.sums.count = sums;
    pixel.has_weights = shares_samples();
    return sizeof(std::int64_t) * pixel.words_per_pixel();
  }
  /// At the most: a film of one sum takes a part of the buffer.
  [[nodiscard]] std::size_t film_bytes_per_pixel() const {
    return film_bytes_per_pixel(film_kind() == FilmKind::splats && !settings.estimate_error ? 1 : layout::FILM_SUBSUMS);
  }
  /// Of a pixel: with fewer samples than sub-sums no error can be estimated, and one sum needs a quarter of the memory.
  [[nodiscard]] int film_sums(int spp) const {
    return settings.estimate_error && spp >= layout::FILM_SUBSUMS ? layout::FILM_SUBSUMS : 1;
  }

  /// Behind the counters: how far each pixel has come.
  [[nodiscard]] std::size_t done_bytes(std::size_t pixels) const {
    const std::size_t numbers = film_kind() == FilmKind::splats ? layout::DONE_OF_PATHS : 1;
    return features.flag("LOOP_LIMIT") ? pixels * numbers * sizeof(std::uint32_t) : 0;
  }

  /// What a row of the picture takes in device buffers.
  [[nodiscard]] std::size_t row_bytes() const {
    const auto pixels = static_cast<std::size_t>(window.width());
    return pixels * film_bytes_per_pixel() + aov_real_bytes(pixels) + aov_int_bytes(pixels) + done_bytes(pixels);
  }
  /// Beside the scene, once that is there.
  [[nodiscard]] std::size_t memory_left() const {
    const std::uint64_t all = device.info().global_memory;
    return all > buffers.bytes ? all - buffers.bytes : 0;
  }
  /// Rows whose film fits into one buffer, and with all that belongs to them into the memory that is left.
  [[nodiscard]] int band_rows() const {
    if (film_kind() == FilmKind::splats) return window.height();
    const std::size_t row = static_cast<std::size_t>(window.width()) * film_bytes_per_pixel();
    const std::size_t room = memory_left() - (shares_samples() ? ring_memory() : 0);
    const std::size_t fitting = std::min(largest_film_buffer(device.info(), is_helper) / row, room / row_bytes());
    return static_cast<int>(std::clamp<std::size_t>(fitting, 1, static_cast<std::size_t>(window.height())));
  }

  /// The most samples a pixel, by the goal, the scene and the film. Throws as require_samples.
  [[nodiscard]] int samples_of(const RenderGoal& goal) const;
  [[nodiscard]] SubSums sub_sums(const RenderGoal& goal) const;
  /// The choices that determine the program.
  struct Choice {
    Width width;
    TraversalChoice traversal;
    int paths = 1;
  };
  /// Fills in `features` and the sources; nothing is built or uploaded.
  Choice choose_program();
  /// Nothing has to be compiled.
  [[nodiscard]] bool are_programs_cached() const;
  void prepare();
  /// Pixels of a work-item, so that their samples fill a pool.
  [[nodiscard]] int span_columns(const Launch& launch) const;
  /// Samples, into the film or, where pixels share them, into the ring. band: the film's rows.
  void launch(const Launch& launch, const Rows& band);
  /// From the ring into the film.
  void launch_sharing(const Launch& launch, const Rows& band);
  /// The part of a device's memory that the ring may take.
  [[nodiscard]] std::size_t ring_memory() const;
  /// Samples that count in this launch's pixels and are not there yet.
  [[nodiscard]] Launch missing_samples(const Launch& launch);
  /// Before either kernel: where the device ends loops, no pixel of the ring has come anywhere yet.
  void begin_ring();
  void warm_up();

  LaunchShape shape, sharing_shape;
  double launch_overhead = 0;  ///< Seconds.
  /// What the time from the last launch to the picture depends on.
  struct End {
    int rows = 0;
    int sums = 1;
    bool is_on_device = false;  ///< The film.
    friend bool operator<(const End& a, const End& b) {
      return std::tie(a.rows, a.sums, a.is_on_device) < std::tie(b.rows, b.sums, b.is_on_device);
    }
  };
  std::map<End, double> end_seconds;    ///< As measured last, of whole pictures.
  std::optional<LaunchPlan> last_plan;  ///< Of this picture or an earlier one: it knows the device's rate.
  bool has_tree = true;
  int samples_at_once = 1;
  double rate = 0;         ///< Pixel samples a second beside other devices; 0: not known yet.
  std::string fault;       ///< Why it takes no part any more; empty: it does.
  bool is_helper = false;  ///< Of another device's pictures.
  std::atomic<bool> is_rendering = false;
  std::vector<std::unique_ptr<State>> helpers;  ///< Other devices that share this one's pictures.
  cl::Buffer aov_reals, aov_ints, counters;
  std::optional<FilmBuffer> film;
  cl::Kernel sharing_kernel;
  std::optional<SampleRing> ring;  ///< Where pixels share samples.
};

}  // namespace strahl
