// SPDX-License-Identifier: MIT
// Normals for meshes whose files have none.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Gives every vertex the sum of its triangles' unit normals, each weighted by the triangle's angle there, as unit
/// vector (G. Thürmer, C. Wüthrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1),
/// 1998). Where the sum is zero, the x axis, as Mitsuba has it. Replaces what `normals` holds.
void make_vertex_normals(Mesh& mesh);

}  // namespace strahl
