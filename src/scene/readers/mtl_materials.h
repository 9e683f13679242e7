// SPDX-License-Identifier: MIT
// Materials of a scene from those of MTL files, by their illumination models.
//
//   illum 0 to 2, 10         diffuse; with Ks and Ns a Phong highlight over it
//   illum 3, 5, 8            diffuse, and a mirror of Ks
//   illum 4, 6, 7, 9         glass of index Ni, in the hue of Tf
//
// Ks is at most what Kd leaves of the light. Of Tf only the hue counts: files that mean clear glass have any brightness
// there. d, Tr and map_d make a mask, but of glass. norm bends the normals of all that, else map_Bump, whose texels
// times -bm are heights in units of the scene. All but glass are two-sided: OBJ files know no sidedness, and many do
// not care for their winding.
#pragma once

#include "scene/meshes/mesh_material.h"
#include "scene/model/scene.h"
#include "scene/readers/image_files.h"
#include "scene/xml/diagnostics.h"

namespace strahl {

/// Index of the material that is appended to scene.materials. shape: whose mesh it is, for messages. An image that
/// cannot be read is warned of.
[[nodiscard]] int added_material(const MeshMaterial& from, const Shape& shape, Scene& scene, ImageFiles& images,
                                 Diagnostics& diagnostics);

}  // namespace strahl
