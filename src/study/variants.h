// SPDX-License-Identifier: MIT
// Programs for the same scene, timed side by side: how long each takes to build, how large it is, how fast it renders.
//
// They take turns, so that what slows the machine slows all of them, and medians are told. What building takes is worth
// something without any cache only: RenderSettings::cached_program off, and keep_drivers_from_caching.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.h"
#include "opencl/device.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

struct VariantTimes {
  std::string program;              ///< Its hash.
  std::size_t bytes = 0;            ///< Of its binary.
  std::uint64_t private_bytes = 0;  ///< Of a work-item, as the driver tells it.
  std::vector<double> build_seconds;
  std::vector<double> kernel_seconds;  ///< Of a frame, a round each.
  std::vector<double> first_seconds;   ///< Of the first variant in the same rounds.
  Image color;

  [[nodiscard]] double build() const;   ///< Median seconds.
  [[nodiscard]] double kernel() const;  ///< Median seconds.
  [[nodiscard]] double ratio() const;   ///< To the first variant: median of the rounds' ratios.
};

/// What the seconds of a study are.
enum class StudyClock {
  wall,      ///< Of the builds' and the kernels' begin and end.
  processor  ///< That all threads of the process spent, on CPU devices: other programs hardly lengthen them. A build's
             ///< are those of a first frame less those of a second one.
};

struct VariantRounds {
  int builds = 3;
  int frames = 9;
  double frame_seconds = 0.1;  ///< About so long a timed frame takes: samples are added up to those of the scene.
  int least_samples = 1;       ///< Of a timed frame however long that takes, where the scene has as many.
  StudyClock clock = StudyClock::wall;
};

struct VariantStudy {
  int width = 0, height = 0;
  int spp = 0;        ///< Of a timed frame.
  int scene_spp = 0;  ///< That the scene asks for.
  std::vector<VariantTimes> variants;

  /// Kernel time is in proportion to the samples: what a frame of the scene takes.
  [[nodiscard]] double whole_frame(double seconds) const { return seconds * scene_spp / spp; }
};

using StudyProgress = std::function<void(double share)>;

/// Has to come before the first OpenCL call of the process: PoCL, Mesa, NVIDIA's and Intel's drivers are told by their
/// environment variables to keep no compiled programs.
void keep_drivers_from_caching();

/// Times of all variants, in their order.
[[nodiscard]] VariantStudy time_variants(const Device& device, Scene scene, const std::vector<RenderSettings>& variants,
                                         const VariantRounds& rounds = {}, const StudyProgress& progress = {});

}  // namespace strahl
