// SPDX-License-Identifier: MIT
// Indices of refraction: numbers or names, as in Mitsuba.
#include <fmt/format.h>

#include "did_you_mean.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/refractive_indices.h"
#include "scene/xml/parse_value.h"

namespace strahl {

double read_index_of_refraction(Properties& properties, const char* name, double otherwise) {
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

}  // namespace strahl
