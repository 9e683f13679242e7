// SPDX-License-Identifier: MIT
#include "bench/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "render/renderer.h"
#include "scene/loader.h"

namespace strahl::bench {
namespace {

constexpr int least_samples = 16;  ///< A launch, for the sub-sums' cost to be told.

Scene of_size(const Scene& scene, double scale) {
  Scene scaled = scene;
  const auto side = [scale](int pixels) { return std::max(8, static_cast<int>(std::lround(scale * pixels))); };
  scaled.film.width = side(scene.film.width);
  scaled.film.height = side(scene.film.height);
  scaled.film.crop.reset();
  return scaled;
}

/// As large a picture as takes about so long, at most the scene's own.
Scene fitting(const Device& device, const Scene& scene, double seconds) {
  const double probe_scale = std::min(1.0, 48.0 / std::max(scene.film.width, scene.film.height));
  Scene probe = of_size(scene, probe_scale);
  RenderSettings settings;
  settings.passes = 1;
  Renderer renderer(device, probe, settings);
  static_cast<void>(renderer.render());
  const double took = std::max(renderer.render().stats.seconds.kernel, 1e-6);
  return of_size(scene, std::min(1.0, probe_scale * std::sqrt(seconds / took)));
}

/// For those of the scene's own samples: `sobol` has others where no error is told, one sequence instead of four.
void require_same(const std::string& scene, const VariantStudy& study, const std::vector<RenderSettings>& settings,
                  SamplerKind sampler) {
  const Image& own = study.variants[0].color;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (sampler == SamplerKind::sobol && !settings[i].estimate_error) continue;
    const VariantTimes& other = study.variants[i];
    if (other.color.data.size() != own.data.size() ||
        std::memcmp(other.color.data.data(), own.data.data(), own.data.size() * sizeof(float)) != 0)
      throw Error(fmt::format("{}: the generic program, or that without sub-sums, renders another picture", scene));
  }
}

SceneEffects measure_scene(const Device& device, const std::string& path, const EffectsOptions& options) {
  Scene scene = load_scene(path).scene;
  const ResolvedSampling sampling = resolve_sampling(scene);
  SceneEffects row;
  row.scene = path.starts_with(options.folder) ? path.substr(options.folder.size()) : path;
  row.width = scene.film.window().width();
  row.height = scene.film.window().height();
  row.spp = sampling.spp;
  scene.sampler.kind = sampling.kind;
  const bool are_one = sampling.kind == SamplerKind::centre;
  scene.sampler.sample_count = are_one ? sampling.spp : least_samples;
  RenderSettings specialised, generic, without_sums;
  specialised.cached_program = false;
  generic.generic = true;
  without_sums.estimate_error = false;
  VariantRounds rounds;
  rounds.builds = 1;
  rounds.frames = options.rounds;
  rounds.frame_seconds = std::numeric_limits<double>::max();
  const auto time = [&](const std::vector<RenderSettings>& variants) {
    VariantStudy study = time_variants(device, fitting(device, scene, options.frame_seconds), variants, rounds);
    require_same(row.scene, study, variants, sampling.kind);
    return study;
  };
  if (!are_one) {
    row.study = time({specialised, generic, without_sums});
    return row;
  }
  row.study = time({specialised, generic});
  scene.sampler.sample_count = least_samples;
  row.of_16 = time({specialised, without_sums});
  return row;
}

}  // namespace

double SceneEffects::whole(const VariantTimes& times) const {
  const double timed = static_cast<double>(study.width) * study.height * study.spp;
  return times.kernel() * (static_cast<double>(width) * height * spp) / timed;
}

double SceneEffects::break_even() const {
  const double saved = whole(study.variants[0]) * (study.variants[1].ratio() - 1);
  return saved > 0 ? study.variants[0].build() / saved : std::numeric_limits<double>::infinity();
}

Effects measure_effects(const Device& device, const EffectsOptions& options, const EffectsProgress& progress) {
  Effects effects;
  effects.device = device.info().text();
  effects.version = STRAHL_VERSION;
  effects.rounds = options.rounds;
  for (const Precision precision : {Precision::robust, Precision::fast}) {
    progress(fmt::format("ten spheres, {}", precision_name(precision)));
    effects.spheres.push_back(time_ten_spheres(device, precision, 1024, 5 * options.rounds));
  }
  if (options.only_spheres) return effects;
  progress("the generic program");
  RenderSettings generic;
  generic.generic = true;
  generic.cached_program = false;
  VariantRounds builds;
  builds.frames = 1;
  effects.generic = time_variants(device, ten_glowing_spheres(64), {generic}, builds).variants.front();
  for (const std::string& path : options.scenes) {
    progress(path);
    effects.scenes.push_back(measure_scene(device, path, options));
  }
  return effects;
}

}  // namespace strahl::bench
