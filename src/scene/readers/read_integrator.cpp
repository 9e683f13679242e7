// SPDX-License-Identifier: MIT
// <integrator>: by name; what strahl does not have yet becomes "path" with a warning.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "kinds/integrators.h"
#include "scene/readers/foreign_plugins.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

/// So many are within each other at the most.
constexpr std::size_t deepest_integrator = 256;

/// Other ways to draw the picture of volpath.
bool draws_as_volpath(std::string_view type) {
  return type == "volpathmis" || type == "volpath_simple" || type == "prbvolpath";
}

/// What takes the place of those that strahl does not have. The scene's shapes and sensors have been read.
std::string substitute_of(Properties& properties, const Scene& scene) {
  const std::string_view type = properties.type();
  const char* name = scene.media.empty() ? "path" : "volpath";
  properties.diagnostics().unknown(
      properties.where(),
      fmt::format("{}; \"{}\" takes its place", not_available("integrator", type, kinds::integrator_names()), name));
  properties.accept_all();
  return name;
}

/// Of Mitsuba 0.x: half the radius of the sphere around the scene's box, where rayLength says nothing else.
double reach_of_0x(Properties& properties, const Scene& scene) {
  const std::optional<double> given = properties.number("ray_length");
  if (given && *given > 0) return *given;
  if (given && *given == 0)
    properties.diagnostics().error(properties.where("ray_length"),
                                   "\"ray_length\" is 0; it must be greater than 0, or negative for its default");
  const std::optional<Box> box = bounds(scene);
  const double reach = box ? length(box->max - box->min) / 4 : 0;
  return reach > 0 && std::isfinite(reach) ? reach : IntegratorSettings{}.max_distance;
}

/// Parameters that other integrators have. name: of the one that renders; max_depth: none where none is given, or a
/// faulty one.
void report_without_effect(Properties& properties, const std::string& name, std::optional<int> max_depth) {
  const auto report = [&](const char* parameter, const std::string& why) {
    if (properties.has(parameter))
      properties.diagnostics().unknown(
          properties.where(parameter),
          fmt::format("\"{}\" has no effect on integrator \"{}\"{}", parameter, properties.type(), why));
  };
  if (name == "auto") return report("max_distance", "");  // It never is ao.
  const kinds::IntegratorFacts& facts = kinds::integrator(name);
  if (!facts.asks_openness) report("max_distance", "");
  if (facts.follows != kinds::Follows::paths) report("rr_depth", "");
  if (!facts.shows_emission) report("hide_emitters", "");
  if (!max_depth || facts.has_depth()) return;
  if (!facts.shows_emission) return report("max_depth", "");
  const int deepest = facts.follows == kinds::Follows::one_way ? 2 : 1;
  if (*max_depth < 0 || *max_depth > deepest)
    report("max_depth", fmt::format(", whose light goes no deeper than {}", deepest));
}

/// Mitsuba's limit in seconds; here the run has one.
void read_timeout(Properties& properties) {
  const std::optional<double> seconds = properties.number("timeout");
  if (seconds && *seconds > 0)
    properties.diagnostics().warning(properties.where("timeout"),
                                     fmt::format("\"timeout\" has no effect; --time {} limits the run", *seconds));
}

}  // namespace

IntegratorSettings read_inner_integrator(Properties& properties, SceneBuilder& builder, std::string* name) {
  // Of the integrator inside, where Mitsuba heeds them.
  properties.accept({"samples_per_pass", "block_size", "hide_emitters"});
  read_timeout(properties);
  const std::vector<const XmlElement*> inside = properties.objects("integrator");
  for (std::size_t i = 1; i < inside.size(); ++i)
    builder.diagnostics.unknown(
        inside[i]->where,
        fmt::format("the first <integrator> of integrator \"{}\" renders; this one is left out", properties.type()));
  if (name != nullptr && !inside.empty()) *name = inside.front()->text("name");
  if (!inside.empty()) return read_integrator(*inside.front(), builder);
  IntegratorSettings integrator;
  integrator.name = "auto";
  integrator.where = properties.where();
  return integrator;
}

IntegratorSettings read_integrator(const XmlElement& element, SceneBuilder& builder) {
  const std::vector<std::string>& known = kinds::integrator_names();
  Properties properties(element, builder.ids, builder.diagnostics);
  // Mitsuba's name and its alias.
  const std::string_view type = properties.type() == "particle" ? "ptracer" : properties.type();
  const bool is_known = type == "auto" || std::find(known.begin(), known.end(), type) != known.end();
  // Reading goes on to the one inside, which may be a <ref> to any.
  if (!is_known && !builder.integrators_being_read.insert(&element).second) {
    builder.diagnostics.error(element.where, fmt::format("{} contains itself", properties.title()));
    return {};
  }
  if (builder.integrators_being_read.size() > deepest_integrator) {
    builder.diagnostics.error(element.where, fmt::format("integrators are nested deeper than {}", deepest_integrator));
    return {};
  }
  if (type == "aov") return read_aov(properties, builder);
  if (type == "moment") return read_moment(properties, builder);
  if (!is_known) {
    const std::vector<const XmlElement*> inside = properties.objects("integrator");
    if (!inside.empty()) {
      builder.diagnostics.unknown(
          element.where, fmt::format("{}; the one inside it renders", not_available("integrator", type, known)));
      return read_integrator(*inside.front(), builder);
    }
  }
  IntegratorSettings integrator;
  integrator.where = element.where;
  const std::optional<int> max_depth = properties.integer_in("max_depth", -1, std::numeric_limits<int>::max());
  integrator.max_depth = max_depth.value_or(integrator.max_depth);
  integrator.rr_depth =
      properties.integer_in("rr_depth", 1, std::numeric_limits<int>::max()).value_or(integrator.rr_depth);
  integrator.max_distance = properties.positive("max_distance").value_or(integrator.max_distance);
  // Written by the upgrade from 0.x.
  if (properties.has_old_rule("looks_as_far_as_0x")) {
    integrator.max_distance = reach_of_0x(properties, builder.scene);
    builder.diagnostics.warning(element.where,
                                "integrator ao is black where nothing is hit, which is white in Mitsuba 0.x");
  }
  integrator.hide_emitters = properties.boolean("hide_emitters").value_or(false);
  integrator.strict_normals = properties.boolean("strict_normals").value_or(false);
  properties.accept({"shading_samples", "emitter_samples", "bsdf_samples", "samples_per_pass", "block_size"});
  // Of 0.x: which techniques it takes. strahl takes all, and the picture is the same but for its noise.
  if (type == "bdpt") properties.accept({"light_image", "sample_direct"});
  read_timeout(properties);
  const bool is_alias = draws_as_volpath(type);
  integrator.name = is_known ? std::string(type) : is_alias ? "volpath" : substitute_of(properties, builder.scene);
  if (is_known || is_alias) report_without_effect(properties, integrator.name, max_depth);
  properties.report_unknown();
  return integrator;
}

}  // namespace strahl
