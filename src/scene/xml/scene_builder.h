// SPDX-License-Identifier: MIT
// What the readers of one scene file share: the scene being built, the ids, the problems found.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kinds/lobes_inside.h"
#include "scene/loader.h"
#include "scene/meshes/mesh_file.h"
#include "scene/model/scene.h"
#include "scene/readers/image_files.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/element_ids.h"
#include "scene/xml/search_path.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// What a texture gives.
enum class TextureUse {
  colour,  ///< Shares of light.
  light,
  number,    ///< One in [0, 1].
  quantity,  ///< One of any size: a roughness, an index of refraction.
  value,     ///< What is no share: a normal, the coefficients of a medium.
  height     ///< Whose differences alone count.
};

struct SceneBuilder {
  Scene scene;
  const SearchPath& search_path;
  const ElementIds& ids;
  Diagnostics& diagnostics;
  const LoadProgress& mesh_progress;
  const std::string& sensor;  ///< LoadOptions::sensor.
  ImageFiles images{};

  // read_material.cpp: a bsdf that several shapes refer to is read once.
  std::map<const XmlElement*, Material> materials{};
  std::map<const XmlElement*, int> material_indices{};
  LobesInside lobes_inside{};
  std::set<const XmlElement*> materials_being_read{};
  std::set<const XmlElement*> integrators_being_read{};                       ///< Those around others.
  std::set<const XmlElement*> emitters_of_shapes{};                           ///< Those that shapes hold or refer to.
  std::optional<int> black_material{}, open_material{};                       ///< read_shape.cpp, once they are needed.
  std::map<std::pair<const XmlElement*, TextureUse>, int> texture_indices{};  ///< read_texture.cpp.
  std::map<const XmlElement*, std::optional<int>> group_indices{};  ///< read_group.cpp; none: nothing is left of it.
  std::map<const XmlElement*, int> medium_indices{};                ///< read_medium.cpp; -1: left out.
  bool is_in_group = false;                                         ///< read_group.cpp: the shape being read.
  std::vector<AttributeFault> attribute_faults{};                   ///< Of mesh files, whether or not one is shown.
  std::vector<std::string> lost_emitters{};                         ///< The type of each emitter that was left out.
};

/// Reads all that a checked <scene> holds into builder.scene.
void read_scene(const XmlElement& root, SceneBuilder& builder);

}  // namespace strahl
