// SPDX-License-Identifier: MIT
// <bsdf type="coating"> of Mitsuba 0.x: a smooth layer of glass over the bsdf inside it.
#include <fmt/format.h>

#include "kinds/materials.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_coating(Properties& properties, SceneBuilder& builder) {
  Coat coat;
  coat.int_ior = read_index_of_refraction(properties, "int_ior", coat.int_ior);
  coat.ext_ior = read_index_of_refraction(properties, "ext_ior", coat.ext_ior);
  coat.thickness = properties.number("thickness").value_or(coat.thickness);
  coat.sigma_a = read_varying(properties, builder, "sigma_a", {0, 0, 0});
  coat.specular_reflectance = read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1});
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 1) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs one <bsdf> inside", properties.title()));
    return {};
  }
  coat.nested = material_index(*inside.front(), builder);
  const Material& nested = builder.scene.materials.at(static_cast<std::size_t>(coat.nested));
  if (builder.lobes_inside.transmits(builder.scene, nested)) {
    builder.diagnostics.unknown(inside.front()->where,
                                "a coating over what lets light through is not supported yet; it is left out");
    return nested;
  }
  if (is_or_holds<Relief>(builder.scene, coat.nested))
    builder.diagnostics.unknown(inside.front()->where, "the normals that are bent here bend the coating as well");
  if (is_or_holds<Coat>(builder.scene, coat.nested))
    builder.diagnostics.unknown(inside.front()->where, "of a coating on a coating the inner one alone counts");
  Material material;
  material.bsdf = coat;
  return material;
}

}  // namespace strahl
