// SPDX-License-Identifier: MIT
// Normals for meshes whose files have none, and triangles that go by those that files have.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Gives every vertex the sum of its triangles' unit normals, each weighted by the triangle's angle there, as unit
/// vector (G. Thürmer, C. Wüthrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1),
/// 1998). Where the sum is zero, the x axis, as Mitsuba has it. Replaces what `normals` holds.
void make_vertex_normals(Mesh& mesh);

/// Turns triangles to the side of the normals of their vertices, which the mesh has. Where most of them face the other
/// way, as on mirrored meshes, the vertex normals are negated first, so that corners, which u, v and directions along
/// them go by, keep their order: true, and the shape's flip_normals, which turns both, is to change. Of those that face
/// otherwise than most two corners are swapped.
[[nodiscard]] bool turn_to_vertex_normals(Mesh& mesh);

}  // namespace strahl
