// SPDX-License-Identifier: MIT
// How a scene is computed, apart from what the scene itself says.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "settings/aov_list.h"

namespace strahl {

/// Kernel variants of one source (docs/numerics.md). fast: the textbook's forms, world frame, relaxed maths. stable:
/// fp32, published stable forms, contraction off. robust: fp32, exact or compensated. fp64: the forms of stable in
/// double, planes and disks compensated.
enum class Precision { fast, stable, robust, fp64 };

[[nodiscard]] Precision precision_from_name(const std::string& name);  ///< "robust", ...; throws UsageError.
[[nodiscard]] const char* precision_name(Precision precision);

/// How rays find primitives; automatic: a tree where there are enough of them. The hits do not depend on it in robust
/// and double.
enum class Acceleration { automatic, list, tree };

[[nodiscard]] Aov aov_from_name(const std::string& name);     ///< Throws UsageError that lists the names.
[[nodiscard]] Aov first_sample_aov(const std::string& name);  ///< The same, of those alone that --aov takes.
[[nodiscard]] const char* aov_name(Aov aov);

/// Work-items per group, x times y.
struct WorkGroup {
  int x = 64;
  int y = 1;
};

struct RenderSettings {
  Precision precision = Precision::robust;  ///< Taken as it is; choose_tier() tells whether the device keeps it.
  AovList aovs;                             ///< Of the plain ones none of all samples (xyz), which need a name.
  bool generic = false;                     ///< All that the integrator's kernel may have; the same picture, slower.
  /// Effects to leave out, as FeatureReport names them, though the scene calls for them (program/disabled.h).
  std::set<std::string> disabled;
  bool estimate_error = true;  ///< Keeps four sums a pixel apart, whose spread estimates its error.
  /// An entry of cl/choosers/choosers.def, by which points choose among several lights; none: as --light-choice by
  /// default (program/light_choice.h).
  std::optional<std::string> light_choice;
  bool texture_lod = false;    ///< Images are filtered to the pixel's width where they are colours of surfaces.
  bool cached_program = true;  ///< false: builds it whatever strahl's cache holds, to see how long that takes.
  bool count_rays = false;     ///< Instrumented program (--stats-detail): counts shadow and bounce rays.
  std::optional<int> lanes;    ///< 1, 8 or 16 (fp64: 1, 8) primitives at a time; none: by the device.
  /// 2, 4, 8 or 16 children a node (fp64: up to 8); 8 and 16 test as many primitives at a time and so are `lanes`, 2
  /// and 4 mean one. None: by `lanes`, 4 for 1.
  std::optional<int> bvh_width;
  Acceleration acceleration = Acceleration::automatic;
  /// Renderer: as many samples of a pixel as `lanes` are followed at a time. None: by the scene.
  std::optional<bool> paths_in_lanes;
  /// Intersector: neighbouring rays are alike, so `lanes` of them go through the tree together. The hits do not depend
  /// on it.
  bool coherent = false;
  std::optional<WorkGroup> work_group;  ///< None: by the device.
  bool error_map = false;               ///< The estimate of each pixel too.
  std::optional<int> passes;            ///< Split the samples into this many passes; none: by measured time. Of a
                                        ///< goal that is open (RenderGoal): the samples between two looks at it.
  /// The device ends the loops of a work-item after so many turns in sum; none: it does not. Where it does, the program
  /// tells of every work-item whether that came to pass, which is then asked again. Nobody asks the device on the
  /// caller's behalf: it is TierVerdict::loop_turns of choose_tier() (trust/tier_choice.h), and without it pictures and
  /// hits of Mesa's llvmpipe are wrong without a word.
  std::optional<std::uint64_t> loop_turns;
};

}  // namespace strahl
