// SPDX-License-Identifier: MIT
// Properties of a PLY element that are attributes of a mesh, named as Mitsuba 3's plugin does: r, g, b or red, green,
// blue are "color"; else what stands before the last underscore is the name, for one property or three ("heat_0";
// "flow_x", "flow_y", "flow_z", whatever their order), and "foo_r" and its like are "foo_color".
#pragma once

#include <string>
#include <vector>

#include "scene/meshes/ply_header.h"

namespace strahl {

struct PlyAttribute {
  std::string name;                     ///< "vertex_..." or "face_...".
  std::vector<std::size_t> properties;  ///< One or three of the element, in the order of the components.
  double scale = 1;                     ///< Multiplies the file's numbers: integer colours end in 1.
};

/// prefix: "vertex_" or "face_". is_taken: of each property, that it is something else. Warns of properties that would
/// give an attribute a second time, which are left out.
[[nodiscard]] std::vector<PlyAttribute> attributes_of(const PlyElement& element, const std::string& prefix,
                                                      const std::vector<bool>& is_taken, MeshSource& source);

}  // namespace strahl
