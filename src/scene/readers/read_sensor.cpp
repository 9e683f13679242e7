// SPDX-License-Identifier: MIT
// <sensor>: perspective and orthographic cameras with film and sampler.
#include <fmt/format.h>

#include <cmath>

#include "scene/readers/plugin_table.h"
#include "scene/readers/read_medium.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

const PluginTable<Projection>& projections() {
  static const PluginTable<Projection> table{{"perspective", Projection::perspective},
                                             {"orthographic", Projection::orthographic},
                                             {"thinlens", Projection::perspective}};
  return table;
}

void read_clipping(Properties& properties, Camera& camera) {
  camera.near_clip = properties.number("near_clip").value_or(camera.near_clip);
  camera.far_clip = properties.number("far_clip").value_or(camera.far_clip);
  if (camera.near_clip < 0)
    properties.diagnostics().error(properties.where("near_clip"), "near_clip is negative; it is a distance");
  if (camera.far_clip <= camera.near_clip)
    properties.diagnostics().error(properties.where(properties.has("far_clip") ? "far_clip" : "near_clip"),
                                   "far_clip must be greater than near_clip");
}

/// As in Mitsuba the plane of focus is that of far_clip by default, which is 10,000 there.
void read_lens(Properties& properties, Camera& camera) {
  if (!properties.has("aperture_radius"))
    properties.diagnostics().error(properties.where(),
                                   fmt::format("{} needs the float \"aperture_radius\"", properties.title()));
  const double radius = properties.number("aperture_radius").value_or(0);
  if (radius < 0)
    properties.diagnostics().error(properties.where("aperture_radius"), "aperture_radius is negative; it is a length");
  camera.aperture_radius = radius;
  camera.focus_distance =
      properties.positive("focus_distance").value_or(std::isfinite(camera.far_clip) ? camera.far_clip : 1e4);
}

}  // namespace

const XmlElement* only_object(Properties& properties, std::string_view tag) {
  const std::vector<const XmlElement*> objects = properties.objects(tag);
  for (std::size_t i = 1; i < objects.size(); ++i)
    properties.diagnostics().error(objects[i]->where,
                                   fmt::format("{} has more than one <{}>", properties.title(), tag));
  return objects.empty() ? nullptr : objects.front();
}

void read_sensor(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  Camera camera;
  camera.where = element.where;
  const Projection* projection = find_plugin(projections(), properties.type());
  if (projection != nullptr) camera.projection = *projection;
  camera.world_from_camera = properties.transform("to_world").value_or(Transform{});
  const bool may_have_fov = camera.projection == Projection::perspective;
  if (may_have_fov) {
    const FieldOfView fov = read_field_of_view(properties);
    camera.fov_degrees = fov.degrees;
    camera.fov_axis = fov.axis;
    camera.principal_point_offset_x = properties.number("principal_point_offset_x").value_or(0);
    camera.principal_point_offset_y = properties.number("principal_point_offset_y").value_or(0);
  }
  read_clipping(properties, camera);
  if (properties.type() == "thinlens") read_lens(properties, camera);
  if (const XmlElement* film = only_object(properties, "film")) builder.scene.film = read_film(*film, builder);
  if (const XmlElement* sampler = only_object(properties, "sampler"))
    builder.scene.sampler = read_sampler(*sampler, builder);
  if (const XmlElement* medium = only_object(properties, "medium")) camera.medium = medium_index(*medium, builder);
  properties.accept({"focus_distance", "shutter_open", "shutter_close"});
  if (projection == nullptr) {
    builder.diagnostics.unknown(element.where,
                                fmt::format("{}; a perspective camera takes its place",
                                            not_available("sensor", properties.type(), types_of(projections()))));
    properties.accept_all();
  }
  properties.report_unknown();
  builder.scene.camera = camera;
}

}  // namespace strahl
