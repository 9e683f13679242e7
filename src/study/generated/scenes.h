// SPDX-License-Identifier: MIT
// Scenes that code makes: for measurements, at any size, and the same everywhere. Every coordinate is a float, so that
// other programs can be given exactly the same.
//
// Sphereflake and tetra are E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// SPD's balls: a sphere of radius 1/2, nine of a third on it, and so on `depth` times, over a square ground. Depth 4:
/// 7381 spheres, 5: 66430, 6: 597871.
[[nodiscard]] Scene sphereflake(int depth);

/// A square of mountains, one mesh of 2 n^2 triangles: the number that comes nearest to `triangles`.
[[nodiscard]] Scene terrain(int triangles);

/// SPD's tetra: Sierpinski's tetrahedron of 4^depth triangles.
[[nodiscard]] Scene tetra(int depth);

/// n^3 boxes with gaps between.
[[nodiscard]] Scene box_lattice(int n);

/// On an unbounded plane: a scene so small that no tree pays.
[[nodiscard]] Scene ten_spheres();

/// "sphereflake-5", "terrain-1000000", "tetra-6", "lattice-32", "ten". Throws UsageError that says what there is.
[[nodiscard]] Scene generated_scene(const std::string& name);

/// Whether the name is of one of its forms, of whatever size.
[[nodiscard]] bool is_generated_scene(const std::string& name);

/// What generated_scene understands, for a person: "sphereflake-DEPTH", ...
[[nodiscard]] const std::vector<std::string>& generated_scene_forms();

}  // namespace strahl
