// SPDX-License-Identifier: MIT
#include "study/tradeoff/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/comparable.h"
#include "image/file_bytes.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "kinds/integrators.h"
#include "opencl/program_cache.h"
#include "render/light_paths.h"
#include "stopwatch.h"
#include "study/tradeoff/json.h"
#include "study/tradeoff/measure.h"
#include "study/tradeoff/store.h"
#include "study/tradeoff/work_estimate.h"

namespace strahl {
namespace {

std::string reference_identity(const TradeoffOptions& options) {
  if (options.reference_file.empty()) return options.plan.reference.id();
  return fmt::format("file {:016x}", fnv1a(read_file(options.reference_file)));
}

/// Throws what the renderer would throw in the middle of the study of any of its settings.
void require_measurable(const Scene& scene, const TradeoffOptions& options) {
  const int most = Renderer::most_samples(scene, {});
  const bool is_from_lights = kinds::integrator(scene.integrator.name).from_lights;
  const auto require = [&](const TradeoffSetting& setting, const char* option) {
    if (is_from_lights) require_light_paths(scene_of(scene, setting), settings_of(setting));
    if (setting.spp > most)
      throw UsageError(fmt::format("{} {}: the film holds 1 to {} samples per pixel", option, setting.spp, most));
  };
  for (const TradeoffSetting& setting : options.plan.settings) require(setting, "--spp");
  if (options.reference_file.empty()) require(options.plan.reference, "--reference-spp");
}

/// Somebody's reference, if there is one. Throws InputError where the study's pictures cannot be held against it.
std::optional<Image> given_reference(const Film& film, const TradeoffOptions& options) {
  if (options.reference_file.empty()) return std::nullopt;
  Image reference = read_image(options.reference_file);
  if (reference.width != film.width || reference.height != film.height)
    throw InputError(
        fmt::format("\"{}\" (--reference) has {} x {} pixels and the study's pictures {} x {}: leave "
                    "--width out, and they get the reference's size",
                    options.reference_file, reference.width, reference.height, film.width, film.height));
  Image like_the_studys;
  like_the_studys.width = film.width;
  like_the_studys.height = film.height;
  like_the_studys.data.resize(like_the_studys.index(0, film.height, 0));
  try {
    static_cast<void>(comparable_channels(like_the_studys, reference));
  } catch (const InputError& error) {
    throw InputError(fmt::format("\"{}\" (--reference): {}", options.reference_file, error.what()));
  }
  return reference;
}

/// Distances are shown divided by the largest; light as it is.
double exposure_of(const Scene& scene, const Image& reference) {
  if (!kinds::integrator(scene.integrator.name).is_length) return 0;
  const float largest = *std::max_element(reference.data.begin(), reference.data.end());
  return largest > 0 ? -std::log2(static_cast<double>(largest)) : 0;
}

class Sweep {
 public:
  Sweep(const Device& device, const Scene& scene, const TradeoffOptions& options, const TradeoffCallback& progress)
      : device_(device),
        scene_(scene),
        options_(options),
        progress_(progress),
        given_reference_(given_reference(scene.film, options)),
        store_(options.folder, identity_of(device, scene, options.seeds, reference_identity(options)),
               options.restart) {}

  TradeoffStudy run();

 private:
  /// What is estimated by its own kind's rate.
  static std::string row_of(TradeoffSetting setting) {
    setting.spp = 0;
    return setting.id();
  }
  [[nodiscard]] double samples(const TradeoffSetting& setting) const {
    return static_cast<double>(setting.spp) * (setting == options_.plan.reference ? 1 : options_.seeds);
  }
  [[nodiscard]] RenderSettings render_settings(const TradeoffSetting& setting) const;
  bool report(const std::string& what, const WorkEstimate& work) const;
  Renderer& renderer_for(const TradeoffSetting& setting);
  bool find_reference(TradeoffStudy& study);
  bool measure(const TradeoffSetting& setting, TradeoffStudy& study);

  const Device& device_;
  const Scene& scene_;
  const TradeoffOptions& options_;
  const TradeoffCallback& progress_;
  std::optional<Image> given_reference_;  ///< Checked before the store writes its first file.
  TradeoffStore store_;
  Stopwatch watch_;
  WorkEstimate work_;
  std::optional<Renderer> renderer_;
  std::optional<TradeoffSetting> made_for_;
  struct Build {
    double seconds;
    bool from_cache;
  };
  std::map<std::string, Build> builds_;  ///< By the program's hash: the first time that it was needed.
};

RenderSettings Sweep::render_settings(const TradeoffSetting& setting) const {
  RenderSettings settings = settings_of(setting);
  if (const auto found = options_.loop_turns.find(setting.precision); found != options_.loop_turns.end())
    settings.loop_turns = found->second;
  return settings;
}

bool Sweep::report(const std::string& what, const WorkEstimate& work) const {
  const double past = watch_.seconds();
  const std::optional<double> left = work.seconds_left();
  return !progress_ || progress_({left ? past / (past + *left) : 0, what});
}

Renderer& Sweep::renderer_for(const TradeoffSetting& setting) {
  if (!made_for_ || !made_for_->is_same_but_for_samples(setting)) {
    renderer_.reset();  // Two large scenes at a time may be one too many.
    renderer_.emplace(device_, scene_of(scene_, setting), render_settings(setting));
    made_for_ = setting;
  }
  return *renderer_;
}

bool Sweep::find_reference(TradeoffStudy& study) {
  const TradeoffSetting& setting = options_.plan.reference;
  if (given_reference_) {
    study.reference.picture = std::move(*given_reference_);
    study.reference.source = options_.reference_file;
    return true;
  }
  if (std::optional<TradeoffReference> kept = store_.reference(setting)) {
    study.reference = std::move(*kept);
    return true;
  }
  const std::string kind = row_of(setting), what = fmt::format("reference, {} spp", setting.spp);
  work_.expect(kind, samples(setting));
  if (!report(what, work_)) return false;
  Renderer& renderer = renderer_for(setting);
  RenderGoal goal;
  goal.spp = setting.spp;
  goal.seed = reference_seed;
  const Stopwatch watch;
  RenderResult result = renderer.render(
      [&](const Progress& at) {
        const double share = static_cast<double>(at.samples_done) / static_cast<double>(at.samples_total);
        WorkEstimate so_far = work_;
        so_far.done(kind, samples(setting) * share, watch.seconds());
        return report(what, so_far);
      },
      goal);
  if (!result.complete) return false;
  work_.done(kind, samples(setting), watch.seconds());
  builds_.emplace(result.stats.program, Build{result.stats.seconds.program, result.stats.program_from_cache});
  study.reference.setting = setting;
  study.reference.seconds = result.stats.seconds.kernel;
  study.reference.picture = std::move(result.color);
  if (result.error) {
    study.reference.rmse = result.error->rmse;
    study.reference.rmse_low = result.error->rmse_low;
    study.reference.rmse_high = result.error->rmse_high;
  }
  store_.keep(study.reference);
  return true;
}

bool Sweep::measure(const TradeoffSetting& setting, TradeoffStudy& study) {
  const std::string kind = row_of(setting);
  const std::string what =
      fmt::format("{}, {} of {}", setting.id(), study.points.size() + 1, options_.plan.settings.size());
  if (!report(what, work_)) return false;
  Renderer& renderer = renderer_for(setting);
  const Stopwatch watch;
  double seeds_done = 0;
  const auto done = [&](double share) { return samples(setting) * share; };
  std::optional<MeasuredPoint> measured =
      measure_point(renderer, setting, options_.seeds, study.reference, [&](const Progress& at) {
        const double share = static_cast<double>(at.samples_done) / static_cast<double>(at.samples_total);
        WorkEstimate so_far = work_;
        so_far.done(kind, done((seeds_done + share) / options_.seeds), watch.seconds());
        if (at.samples_done == at.samples_total) ++seeds_done;
        return report(what, so_far);
      });
  if (!measured) return false;
  work_.done(kind, samples(setting), watch.seconds());
  TradeoffPoint& point = measured->point;
  const auto [build, is_new] =
      builds_.try_emplace(point.program, Build{point.seconds.program, point.program_from_cache});
  point.seconds.wall += build->second.seconds - point.seconds.program;
  point.seconds.program = build->second.seconds;
  point.program_from_cache = build->second.from_cache;
  store_.keep(point, measured->picture, metric_heatmap(measured->picture, study.reference.picture, Metric::relmse),
              exposure_of(scene_, study.reference.picture));
  study.points.push_back(std::move(point));
  return true;
}

TradeoffStudy Sweep::run() {
  TradeoffStudy study;
  study.scene_path = options_.scene_path;
  study.scene_name = scene_.name;
  study.device = device_.info().text();
  study.command = options_.command;
  study.complete = false;
  std::map<std::string, TradeoffPoint> kept;
  for (const TradeoffSetting& setting : options_.plan.settings) {
    if (std::optional<TradeoffPoint> point = store_.point(setting))
      kept.emplace(setting.id(), std::move(*point));
    else
      work_.expect(row_of(setting), samples(setting));
  }
  if (!find_reference(study)) return study;
  static_cast<void>(write_image(study.reference.picture, store_.path(reference_picture_name),
                                {8, exposure_of(scene_, study.reference.picture)}));
  for (const auto& [id, point] : kept)
    if (!point.program_from_cache) builds_.try_emplace(point.program, Build{point.seconds.program, false});
  for (const TradeoffSetting& setting : options_.plan.settings) {
    if (const auto found = kept.find(setting.id()); found != kept.end()) {
      study.points.push_back(found->second);
      ++study.taken_over;
    } else if (!measure(setting, study)) {
      return study;
    }
  }
  study.complete = true;
  conclude(study);
  store_.publish(study);
  return study;
}

}  // namespace

TradeoffStudy study_tradeoff(const Device& device, const Scene& scene, const TradeoffOptions& options,
                             const TradeoffCallback& progress) {
  require_measurable(scene, options);
  return Sweep(device, scene, options, progress).run();
}

}  // namespace strahl
