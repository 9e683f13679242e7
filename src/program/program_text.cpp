// SPDX-License-Identifier: MIT
#include "program/program_text.h"

#include <fmt/format.h>

#include "settings/require_settings.h"

namespace strahl {

ProgramSource program_source(const std::string& root, const Features& features, Precision precision, int lanes,
                             int tree_width, bool has_tree, int path_lanes) {
  return program_source(kernel_files(), root, features, precision, lanes, tree_width, has_tree, path_lanes);
}

ProgramSource program_source(const KernelFiles& files, const std::string& root, const Features& features,
                             Precision precision, int lanes, int tree_width, bool has_tree, int path_lanes) {
  ProgramSource source;
  source.options = "-cl-std=CL1.2";
  if (precision == Precision::fast) source.options += " -cl-fast-relaxed-math";
  source.text = fmt::format("// strahl {} · {} · precision {} · lanes {} · {}\n", STRAHL_VERSION, root,
                            precision_name(precision), lanes, source.options);
  source.text += fmt::format("#define REAL_BITS {}\n", precision == Precision::fp64 ? 64 : 32);
  source.text += fmt::format("#define TIER_ROBUST {}\n", precision == Precision::robust ? 1 : 0);
  source.text += fmt::format("#define TIER_FAST {}\n", precision == Precision::fast ? 1 : 0);
  source.text += fmt::format("#define LANES {0}\n#define SCENE_LANES {0}\n#define PATH_LANES {1}\n", lanes, path_lanes);
  if (lanes == 1 && tree_width == 2) source.text += "#define SCALAR_TREE_WIDTH 2\n";
  source.text += fmt::format("#define HAS_TREE {}\n", has_tree ? 1 : 0);
  // Else they are inlined (cl/portable.h).
  const bool keeps_functions = features.is_generic || features.flag("LOOP_LIMIT");
  source.text += fmt::format("#define KEEPS_FUNCTIONS {}\n", keeps_functions ? 1 : 0);
  for (const auto& [name, on] : features.flags) source.text += fmt::format("#define HAS_{} {}\n", name, on ? 1 : 0);
  source.text += expand_kernel(files, root, features.entries, features.flags);
  return source;
}

ProgramSource sharing_source(const Features& features, Precision precision, int lanes) {
  Features few = no_features(features.flag("LOOP_LIMIT"));
  for (auto& [name, on] : few.flags)
    if (name == "SHARED_SAMPLES" || name == "MOMENT" || name == "ERROR_SUMS") on = features.flag(name);
  return program_source("kernels/share_samples.cl", few, precision, lanes, 0, false, lanes);
}

Width width_of(const RenderSettings& settings, unsigned native_vector_width) {
  if (settings.bvh_width) return {lanes_of_tree(*settings.bvh_width), *settings.bvh_width};
  const int lanes = settings.lanes.value_or(default_lanes(native_vector_width, settings.precision));
  return {lanes, lanes == 1 ? 4 : lanes};
}

int default_lanes(unsigned native_vector_width, Precision precision) {
  if (native_vector_width >= 16) return precision == Precision::fp64 ? 8 : 16;
  return native_vector_width >= 8 ? 8 : 1;
}

}  // namespace strahl
