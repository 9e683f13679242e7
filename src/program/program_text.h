// SPDX-License-Identifier: MIT
// The complete program for a kernel file: prelude (precision, lanes, flags) and expanded sources.
#pragma once

#include "program/features.h"
#include "program/program_source.h"

namespace strahl {

/// root: "kernels/render.cl". tree_width: 2 or 4 where `lanes` is 1 (0: 4), ignored elsewhere. has_tree: false
/// for scenes that are packed into lists alone (calls_for_tree). path_lanes: 1 or `lanes`, of render.cl. Equal
/// features, precision and widths give equal text, whatever the scene's values.
[[nodiscard]] ProgramSource program_source(const std::string& root, const Features& features, Precision precision,
                                           int lanes, int tree_width = 0, bool has_tree = true, int path_lanes = 1);

/// The same on files of one's own.
[[nodiscard]] ProgramSource program_source(const KernelFiles& files, const std::string& root, const Features& features,
                                           Precision precision, int lanes, int tree_width = 0, bool has_tree = true,
                                           int path_lanes = 1);

/// What takes shared samples from the ring into the film (kernels/share_samples.cl): of all scenes the same whose films
/// hold the same sums. features: of the program that follows their paths; lanes: in which it does.
[[nodiscard]] ProgramSource sharing_source(const Features& features, Precision precision, int lanes);

/// Primitives tested at a time, and children of a node.
struct Width {
  int lanes;  ///< 1, 8 or 16.
  int tree;   ///< As `lanes`; 2 or 4 where that is 1.
};

/// What the settings say, else what suits the device.
[[nodiscard]] Width width_of(const RenderSettings& settings, unsigned native_vector_width);

/// Lanes for a device: 16 or 8 where its native float vectors are that wide, 1 where it runs work-items in lanes.
[[nodiscard]] int default_lanes(unsigned native_vector_width, Precision precision);

}  // namespace strahl
