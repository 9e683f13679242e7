// SPDX-License-Identifier: MIT
#include "program/disabled.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "did_you_mean.h"
#include "errors.h"
#include "program/kernel_source.h"

namespace strahl {
namespace {

/// Lists and flags that --disable refuses.
const std::map<std::string, std::string>& needed() {
  static const std::map<std::string, std::string> reasons = {
      {"integrators", "a picture needs its integrator; --integrator takes another one"},
      {"samplers", "samples draw their numbers from it; --sampler takes another one"},
      {"BRANCHES", "integrator whitted follows glass by it; --integrator path draws one way of two"},
      {"BECKMANN", "rough surfaces are made of it; their materials can be left out"},
      {"GGX", "rough surfaces are made of it; their materials can be left out"},
      {"BLEND", "a blend is two materials; one of them can take its place in the scene"},
      {"BLACK", "the materials that are left out look so"},
      {"COAT", "a coating is a material under it; that can take its place in the scene"},
      {"RELIEF", "a normal map is a material inside it; that can take its place in the scene"},
      {"choosers", "lights are drawn by it; --light-choice takes another one"},
      {"LIGHT_PATHS", "integrators ptracer and bdpt are nothing else; --integrator takes another one"},
      {"OPENNESS", "integrator ao is nothing else; --integrator takes another one"},
      {"media", "MEDIA can be left out, and all media with it"},
      {"phases", "a medium needs its phase function; MEDIA can be left out"},
      {"AOV", "--aov asks for it, or the scene's integrator aov where an .exr is written; leave that out"},
      {"ALBEDO", "--aov albedo asks for it, or the scene's integrator aov where an .exr is written; leave that out"},
      {"MOMENT", "the scene's integrator moment asks for it where an .exr is written; leave that out"},
      {"COUNT_RAYS", "--stats-detail asks for it; leave that out"},
      {"LOOP_LIMIT", "the device ends long loops, and a picture might be wrong without a word"},
      {"MESH_ATTRIBUTE", "the texture mesh_attribute reads by it; that can be left out"},
      {"SUN", "the light sun shines by it; lights/sun can be left out"},
      {"TEXTURE_LOD", "--texture-lod asks for it; leave that out"},
      {"ERROR_SUMS", "--no-error leaves it out"},
  };
  return reasons;
}

std::vector<std::string> all_effects() {
  std::vector<std::string> names;
  for (const std::string& list : list_folders())
    for (const std::string& entry : list_entries(list)) names.push_back(list + "/" + entry);
  for (const auto& [name, purpose] : list_features()) names.push_back(name);
  return names;
}

std::string reason(const std::string& name) {
  const auto found = needed().find(name.substr(0, name.find('/')));
  return found == needed().end() ? "" : found->second;
}

}  // namespace

std::string needed_because(const std::string& name) {
  std::vector<std::string> names = all_effects();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const std::string hint = did_you_mean(name, names);
    std::erase_if(names, [](const std::string& known) { return !reason(known).empty(); });
    throw UsageError(
        fmt::format("there is no effect \"{}\"{}; these can be left out: {}", name, hint, fmt::join(names, ", ")));
  }
  return reason(name);
}

std::set<std::string> disabled_effects(const std::set<std::string>& disabled) {
  std::set<std::string> names = disabled;
  for (const std::string& name : disabled)
    if (const std::string why = needed_because(name); !why.empty())
      throw UsageError(fmt::format("{} cannot be left out: {}", name, why));
  if (names.contains("EMISSION")) names.insert({"lights/area", "lights/directionalarea"});
  if (names.contains("PIXEL_FILTER")) names.insert("SHARED_SAMPLES");
  if (names.contains("lights/area") && names.contains("lights/directionalarea"))
    for (const std::string& area : list_entries("areas")) names.insert("areas/" + area);
  return names;
}

}  // namespace strahl
