// SPDX-License-Identifier: MIT
// <integrator type="moment">: the mean of the squares of each pixel's samples, beside the picture of the integrator
// inside it. Names of channels are Mitsuba's.
#include <fmt/format.h>

#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {
namespace {

/// Mitsuba's of the first nested object without a name.
constexpr const char* no_name = "_arg_0";

/// Values of the integrator inside, which get its name before theirs.
void take_inner(const std::string& name, const SourceLocation& where, Diagnostics& diagnostics,
                std::vector<NamedAov>& aovs) {
  if (aovs.empty()) return;
  for (NamedAov& named : aovs) named.name = fmt::format("{}.{}", name, named.name);
  diagnostics.unknown(where, "second moments of AOVs are not supported yet; those of the picture are written");
}

}  // namespace

IntegratorSettings read_moment(Properties& properties, SceneBuilder& builder) {
  std::string name;
  IntegratorSettings integrator = read_inner_integrator(properties, builder, &name);
  if (name.empty()) name = no_name;
  take_inner(name, properties.where(), builder.diagnostics, integrator.aovs);
  integrator.aovs.push_back({name, Aov::xyz});
  integrator.aovs.push_back({"m2_" + name, Aov::xyz_squared});
  integrator.aovs_where = properties.where();
  properties.report_unknown();
  return integrator;
}

}  // namespace strahl
