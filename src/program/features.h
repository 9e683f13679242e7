// SPDX-License-Identifier: MIT
// Which effects a scene calls for: the one place that decides what goes into a program.
#pragma once

#include <string>
#include <vector>

#include "program/kernel_source.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// One effect, on or off, and the scene element that called for it.
struct FeatureReport {
  std::string name;  ///< "shapes/sphere" for an entry of a list, "AOV" for a flag of features.def.
  bool on = false;
  std::string why;       ///< "shape of type sphere", or what the flag is for.
  SourceLocation where;  ///< The element that called for it, or would where another file is written; else empty.
};

struct Features {
  ActiveEntries entries;                            ///< Active entries of every list.
  std::vector<std::pair<std::string, bool>> flags;  ///< Every flag of features.def, in its order.
  std::vector<FeatureReport> report;                ///< All of them, lists first, each in file order.
  std::string light_chooser = "uniform";            ///< The entry of choosers.def by which lights are drawn.
  bool is_generic = false;                          ///< Of a program for all scenes, too large to inline all of it.

  [[nodiscard]] bool has(const std::string& list, const std::string& entry) const;
  [[nodiscard]] bool flag(const std::string& name) const;
  /// Number of an entry among the active ones, as the program's enumerators count; -1 where it is not active.
  [[nodiscard]] int entry_index(const std::string& list, const std::string& entry) const;
};

/// Those of a program that asks a device, and shows nothing of a scene. ends_loops: in the form that programs have for
/// a device that does (docs/decisions/0021-loop-limit.md).
[[nodiscard]] Features no_features(bool ends_loops);

/// Pure. settings.generic: everything on; settings.disabled: off all the same. Throws UsageError for what cannot be.
[[nodiscard]] Features features_of(const Scene& scene, const RenderSettings& settings);

}  // namespace strahl
