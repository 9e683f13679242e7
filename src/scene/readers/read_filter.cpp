// SPDX-License-Identifier: MIT
// <rfilter>: box, tent, gaussian, mitchell, catmullrom, lanczos.
#include <fmt/format.h>

#include "scene/readers/plugin_table.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

const PluginTable<FilterKind>& filter_kinds() {
  static const PluginTable<FilterKind> table{{"box", FilterKind::box},
                                             {"tent", FilterKind::tent},
                                             {"gaussian", FilterKind::gaussian},
                                             {"mitchell", FilterKind::mitchell},
                                             {"catmullrom", FilterKind::catmullrom},
                                             {"lanczos", FilterKind::lanczos}};
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
  switch (*kind) {
    case FilterKind::box:
    case FilterKind::tent:
      filter.radius = properties.positive("radius").value_or(filter.radius);
      break;
    case FilterKind::gaussian:
      filter.radius = properties.positive("radius").value_or(filter.radius);
      filter.stddev = properties.positive("stddev").value_or(filter.stddev);
      break;
    case FilterKind::mitchell:
      filter.b = properties.number("B").value_or(filter.b);
      filter.c = properties.number("C").value_or(filter.c);
      break;
    case FilterKind::catmullrom:
      break;
    case FilterKind::lanczos:
      filter.radius = properties.integer_in("lobes", 1, Filter::most_lobes).value_or(filter.radius);
      break;
  }
  properties.report_unknown();
  return filter;
}

}  // namespace strahl
