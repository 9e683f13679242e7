// SPDX-License-Identifier: MIT
// <bsdf type="dielectric">: smooth glass. As in Mitsuba, indices are numbers or names.
#include <fmt/format.h>

#include "did_you_mean.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"
#include "scene/readers/refractive_indices.h"
#include "scene/xml/parse_value.h"

namespace strahl {
namespace {

double read_index(Properties& properties, const char* name, double otherwise) {
  const XmlElement* given = properties.peek(name);
  if (given == nullptr || given->tag != "string") return properties.positive(name).value_or(otherwise);
  const std::string medium = properties.string(name).value_or("");
  if (const std::optional<double> index = refractive_index(medium)) return *index;
  const std::string remedy = parse_number(medium)
                                 ? fmt::format("; a number is written <float name=\"{}\" value=\"{}\"/>", name, medium)
                                 : did_you_mean(medium, refractive_names()) + "; a number > 0 will do";
  properties.diagnostics().error(
      properties.where(name),
      fmt::format("\"{}\" is \"{}\", which is no medium that strahl knows{}", name, medium, remedy));
  return otherwise;
}

}  // namespace

Material read_dielectric(Properties& properties, SceneBuilder& builder) {
  Dielectric glass;
  glass.int_ior = read_index(properties, "int_ior", glass.int_ior);
  glass.ext_ior = read_index(properties, "ext_ior", glass.ext_ior);
  glass.reflectance = read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1});
  glass.transmittance = read_reflectance(properties, builder, "specular_transmittance", {1, 1, 1});
  Material material;
  material.bsdf = glass;
  return material;
}

}  // namespace strahl
