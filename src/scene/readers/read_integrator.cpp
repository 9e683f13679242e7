// SPDX-License-Identifier: MIT
// <integrator>: by name; what strahl does not have yet becomes "direct" with a warning.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "did_you_mean.h"
#include "kinds/integrators.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

IntegratorSettings read_integrator(const XmlElement& element, SceneBuilder& builder) {
  const std::vector<std::string>& known = kinds::integrator_names();
  Properties properties(element, builder.ids, builder.diagnostics);
  IntegratorSettings integrator;
  integrator.where = element.where;
  integrator.max_depth =
      properties.integer_in("max_depth", -1, std::numeric_limits<int>::max()).value_or(integrator.max_depth);
  integrator.rr_depth =
      properties.integer_in("rr_depth", 1, std::numeric_limits<int>::max()).value_or(integrator.rr_depth);
  integrator.max_distance = properties.positive("max_distance").value_or(integrator.max_distance);
  integrator.hide_emitters = properties.boolean("hide_emitters").value_or(false);
  const std::string_view type = properties.type();
  if (std::find(known.begin(), known.end(), type) != known.end()) {
    integrator.name = type;
    properties.accept({"shading_samples", "emitter_samples", "bsdf_samples"});
  } else if (type == "volpath" || type == "volpathmis") {
    integrator.name = "path";
    builder.diagnostics.unknown(
        element.where, fmt::format("integrator \"{}\" is not there yet; \"path\" takes its place: no media", type));
  } else {
    builder.diagnostics.unknown(element.where, fmt::format("unknown integrator \"{}\"{}; \"direct\" takes its place",
                                                           type, did_you_mean(type, known)));
    properties.accept_all();
  }
  properties.report_unknown();
  return integrator;
}

}  // namespace strahl
