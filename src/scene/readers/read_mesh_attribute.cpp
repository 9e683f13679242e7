// SPDX-License-Identifier: MIT
// <texture type="mesh_attribute">: what the meshes that it is on have by a name.
#include <fmt/format.h>

#include "scene/readers/read_texture.h"

namespace strahl {

Texture read_mesh_attribute(Properties& properties, SceneBuilder&, ColorUse) {
  AttributeTexture attribute;
  if (!properties.has("name"))
    properties.diagnostics().error(properties.where(), fmt::format("{} needs the string \"name\"", properties.title()));
  attribute.name = properties.string("name").value_or("vertex_color");
  attribute.scale = properties.number("scale").value_or(1);
  Texture texture;
  texture.pattern = attribute;
  return texture;
}

}  // namespace strahl
