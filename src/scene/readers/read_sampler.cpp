// SPDX-License-Identifier: MIT
// <sampler>: "independent" and "sobol" are obeyed; Mitsuba's other types give strahl's default.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/readers/foreign_plugins.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

SamplerSettings read_sampler(const XmlElement& element, SceneBuilder& builder) {
  static const std::vector<std::string> known{"independent", "stratified", "multijitter", "orthogonal",
                                              "ldsampler",   "halton",     "hammersley",  "sobol"};
  constexpr int largest = std::numeric_limits<int>::max();
  Properties properties(element, builder.ids, builder.diagnostics);
  SamplerSettings sampler;
  sampler.where = element.where;
  sampler.sample_count = properties.integer_in("sample_count", 1, largest);
  sampler.seed = properties.integer_in("seed", 0, largest);
  if (properties.type() == "independent") sampler.kind = SamplerKind::independent;
  if (properties.type() == "sobol") sampler.kind = SamplerKind::sobol;
  if (std::find(known.begin(), known.end(), properties.type()) == known.end())
    builder.diagnostics.unknown(element.where, fmt::format("{}; strahl's default takes its place",
                                                           not_available("sampler", properties.type(), known)));
  properties.accept({"jitter", "strength", "scramble"});
  properties.report_unknown();
  return sampler;
}

}  // namespace strahl
