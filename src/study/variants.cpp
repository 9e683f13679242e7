// SPDX-License-Identifier: MIT
#include "study/variants.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <algorithm>
#include <ctime>
#include <optional>

#include "render/median.h"
#include "render/renderer.h"

namespace strahl {
namespace {

/// Of all threads of the process.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double frame(Renderer& renderer, StudyClock clock = StudyClock::wall) {
  const double before = processor_seconds();
  const double kernel = renderer.render().stats.seconds.kernel;
  return clock == StudyClock::wall ? kernel : processor_seconds() - before;
}

/// So many that a frame takes about as long as asked for, and no more than the scene has.
int fitting_spp(const Device& device, Scene scene, const RenderSettings& settings, const VariantRounds& rounds) {
  const int most = resolve_sampling(scene).spp, least = std::min(most, rounds.least_samples);
  if (most == least) return most;
  scene.sampler.sample_count = 1;
  Renderer renderer(device, std::move(scene), settings);
  static_cast<void>(frame(renderer));
  const double fitting = rounds.frame_seconds / std::max(frame(renderer), 1e-6);
  return static_cast<int>(std::clamp(fitting, static_cast<double>(least), static_cast<double>(most)));
}

}  // namespace

double VariantTimes::build() const { return median(build_seconds); }
double VariantTimes::kernel() const { return median(kernel_seconds); }
double VariantTimes::ratio() const {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < kernel_seconds.size(); ++i) ratios.push_back(kernel_seconds[i] / first_seconds[i]);
  return median(ratios);
}

void keep_drivers_from_caching() {
  setenv("POCL_KERNEL_CACHE", "0", 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  setenv("CUDA_CACHE_DISABLE", "1", 1);
  setenv("NEO_CACHE_PERSISTENT", "0", 1);
}

VariantStudy time_variants(const Device& device, Scene scene, const std::vector<RenderSettings>& variants,
                           const VariantRounds& rounds, const StudyProgress& progress) {
  VariantStudy study;
  const Window window = scene.film.window();
  study.width = window.width();
  study.height = window.height();
  study.scene_spp = resolve_sampling(scene).spp;
  study.spp = fitting_spp(device, scene, variants.at(0), rounds);
  study.variants.resize(variants.size());
  if (!scene.sampler.kind) scene.sampler.kind = resolve_sampling(scene).kind;  // Which may follow from the number.
  scene.sampler.sample_count = study.spp;

  std::size_t done = 0;
  const std::size_t total = variants.size() * static_cast<std::size_t>(rounds.builds);
  std::optional<Renderer> first;
  for (int build = 0; build < rounds.builds; ++build) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      if (progress) progress(static_cast<double>(done++) / static_cast<double>(total));
      RenderSettings settings = variants[i];
      settings.passes = 1;
      const double before = processor_seconds();
      Renderer renderer(device, scene, settings);
      RenderResult result = renderer.render();
      VariantTimes& times = study.variants[i];
      if (rounds.clock == StudyClock::wall) {
        times.build_seconds.push_back(result.stats.seconds.program);
      } else {
        const double whole = processor_seconds() - before;
        times.build_seconds.push_back(std::max(0.0, whole - frame(renderer, rounds.clock)));
      }
      if (build + 1 < rounds.builds) continue;
      times.program = result.stats.program;
      times.bytes = result.stats.program_bytes;
      times.private_bytes = result.stats.private_bytes;
      times.color = std::move(result.color);
      if (i == 0) first.emplace(std::move(renderer));
      for (int round = 0; round < rounds.frames; ++round) {
        times.first_seconds.push_back(frame(*first, rounds.clock));
        times.kernel_seconds.push_back(i == 0 ? times.first_seconds.back() : frame(renderer, rounds.clock));
      }
    }
  }
  return study;
}

}  // namespace strahl
