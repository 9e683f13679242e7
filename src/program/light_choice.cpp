// SPDX-License-Identifier: MIT
#include "program/light_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "did_you_mean.h"
#include "errors.h"
#include "kinds/entries.h"
#include "kinds/lights.h"
#include "program/kernel_source.h"
#include "scene/open_media.h"

namespace strahl {
namespace {

/// From here on a walk down a tree takes less time than to ask each light.
constexpr std::size_t least_tree = 33;

std::size_t lights_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry); mesh != nullptr && !mesh->parts.empty())
    return shape.exitance ? mesh->parts.size()
                          : static_cast<std::size_t>(
                                std::count_if(mesh->parts.begin(), mesh->parts.end(),
                                              [](const MeshPart& part) { return part.radiance.has_value(); }));
  if (!shape.radiance && !shape.exitance) return 0;
  const auto* cloud = std::get_if<SphereCloud>(&shape.geometry);
  return cloud != nullptr ? cloud->spheres.size() : 1;
}

}  // namespace

DrawnLights drawn_lights(const Scene& scene, const std::function<bool(const std::string&)>& is_used) {
  DrawnLights lights;
  for (const Shape& shape : scene.shapes)
    if (shape.sampling_weight > 0 && is_used(shape.exitance ? "lights/directionalarea" : "lights/area") &&
        is_used("areas/" + area_kind(shape.geometry)))
      lights.near += lights_of(shape);
  lights.count = lights.near;
  for (const Light& light : scene.lights) {
    const kinds::LightFacts& facts = kinds::light(light);
    if (!kinds::is_drawn(light, scene) || !is_used(std::string("lights/") + facts.entry)) continue;
    ++lights.count;
    if (!facts.is_far) ++lights.near;
    lights.weighs_sky = lights.weighs_sky || (facts.is_far && !facts.is_delta && open_medium(scene));
  }
  return lights;
}

void require_chooser(const std::optional<std::string>& name) {
  if (!name) return;
  const std::vector<std::string> known = list_entries("choosers");
  if (std::find(known.begin(), known.end(), *name) == known.end())
    throw UsageError(fmt::format("there is no light choice \"{}\"{}; there are: {}", *name, did_you_mean(*name, known),
                                 fmt::join(known, ", ")));
}

std::string light_chooser(const DrawnLights& lights) {
  if (lights.count < 2 || lights.weighs_sky) return "uniform";
  if (lights.near == 0) return "power";
  return lights.count < least_tree ? "each" : "tree";
}

}  // namespace strahl
