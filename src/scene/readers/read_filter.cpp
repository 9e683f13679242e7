// SPDX-License-Identifier: MIT
// <rfilter>: box, tent, gaussian.
#include <fmt/format.h>

#include "scene/readers/plugin_table.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

const PluginTable<FilterKind>& filter_kinds() {
  static const PluginTable<FilterKind> table{
      {"box", FilterKind::box}, {"tent", FilterKind::tent}, {"gaussian", FilterKind::gaussian}};
  return table;
}

}  // namespace

Filter read_filter(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  const FilterKind* kind = find_plugin(filter_kinds(), properties.type());
  if (kind == nullptr) {
    builder.diagnostics.unknown(element.where,
                                fmt::format("{}; a gaussian takes its place",
                                            not_available("rfilter", properties.type(), types_of(filter_kinds()))));
    return {};
  }
  Filter filter;
  filter.kind = *kind;
  filter.radius = properties.positive("radius").value_or(filter.radius);
  if (*kind == FilterKind::gaussian) filter.stddev = properties.positive("stddev").value_or(filter.stddev);
  properties.report_unknown();
  return filter;
}

}  // namespace strahl
