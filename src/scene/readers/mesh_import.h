// SPDX-License-Identifier: MIT
// What becomes of a mesh file's materials and texture coordinates in a scene.
#pragma once

#include <map>
#include <string>

#include "scene/loader.h"
#include "scene/meshes/mesh_file.h"
#include "scene/model/scene.h"
#include "scene/readers/image_files.h"
#include "scene/xml/diagnostics.h"

namespace strahl {

/// mesh: what is or will be the shape's geometry; null: that is none.
[[nodiscard]] bool emits(const Shape& shape, const Mesh* mesh);

/// Materials that take the place of a file's.
struct GivenMaterials {
  bool of_shape = false;               ///< The shape's own, of all faces without one by name.
  std::map<std::string, int> by_name;  ///< Of the faces that have this material in the file: index in Scene::materials.
};

/// Whether a shape without a <bsdf> has a material for what it is: black where it shines, open where it bounds media.
[[nodiscard]] bool has_stand_in(const Shape& shape);

/// Fills file.mesh.parts from file.materials and appends what is used to scene.materials. What is given wins over what
/// the file says, its light too, and an <emitter> of the shape over all its light. Materials that no library defines
/// are what the shape's stands in for. An image that cannot be read is warned of.
void add_mesh_materials(MeshFile& file, const GivenMaterials& given, const Shape& shape, Scene& scene,
                        ImageFiles& images, Diagnostics& diagnostics);

/// Of one file, reported to a loader's.
[[nodiscard]] MeshProgress progress_of(const std::string& path, const LoadProgress& progress);

/// ".obj" of "A.OBJ".
[[nodiscard]] std::string lower_case_extension(const std::string& path);

/// v -> 1 - v: OBJ files count v from the bottom, as Mitsuba assumes by default.
void flip_tex_coords(Mesh& mesh);

}  // namespace strahl
