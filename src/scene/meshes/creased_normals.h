// SPDX-License-Identifier: MIT
// Normals of meshes that are smooth but for their edges.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Replaces what `normals` holds: of the triangles at a place those share one whose own normals are at most `degrees`
/// from that of the first of them that has none yet, as Mitsuba 0.x's maxSmoothAngle; the others get vertices of their
/// own there. Vertices of one place, one u, v and the same attributes count as one, as there. Normals are weighted by
/// angles (vertex_normals.h). degrees: [0, 180].
void make_creased_normals(Mesh& mesh, double degrees);

}  // namespace strahl
