// SPDX-License-Identifier: MIT
// <bsdf type="conductor">: an ideal mirror, Mitsuba's material "none".
#include <fmt/format.h>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_conductor(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = Conductor{read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1})};
  const std::string metal = properties.string("material").value_or("none");
  if (metal != "none")
    builder.diagnostics.unknown(
        properties.where("material"),
        fmt::format("the metal \"{}\" is not there yet; an ideal mirror (\"none\") takes its place", metal));
  for (const char* name : {"eta", "k"})
    if (properties.has(name))
      builder.diagnostics.unknown(
          properties.where(name),
          fmt::format("\"{}\" of {} has no effect yet: it is an ideal mirror", name, properties.title()));
  properties.accept({"eta", "k"});
  return material;
}

}  // namespace strahl
