// SPDX-License-Identifier: MIT
#include "scene/model/aovs.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string_view>

namespace strahl {
namespace {

/// A letter for each channel.
std::string_view letters(Aov aov) {
  switch (aov) {
    case Aov::depth:
      return "T";
    case Aov::normal:
    case Aov::geo_normal:
    case Aov::position:
    case Aov::xyz:
    case Aov::xyz_squared:
      return "XYZ";
    case Aov::uv:
      return "UV";
    case Aov::albedo:
      return "RGB";
    case Aov::shape_id:
    case Aov::primitive_id:
      return "I";
    case Aov::numeric_error:
      break;
  }
  throw std::logic_error("Mitsuba has no such AOV");
}

}  // namespace

std::vector<std::string> channels_of(const NamedAov& named) {
  std::vector<std::string> channels;
  for (const char letter : letters(named.aov)) channels.push_back(fmt::format("{}.{}", named.name, letter));
  return channels;
}

std::vector<std::string> aov_faults(const std::vector<NamedAov>& aovs) {
  std::vector<std::string> faults;
  std::map<std::string, std::string> owners;
  for (const NamedAov& named : aovs) {
    if (named.aov == Aov::numeric_error) {
      faults.push_back(fmt::format(
          "the AOV \"{}\" is numeric_error, which scenes cannot name: ask for it in RenderSettings::aovs", named.name));
      continue;
    }
    if (named.name.size() > longest_layer_name) {
      faults.push_back(fmt::format("the name of the AOV \"{}\" has {} bytes; a file holds {}", named.name,
                                   named.name.size(), longest_layer_name));
      continue;
    }
    for (const std::string& channel : channels_of(named)) {
      const auto [owner, is_new] = owners.try_emplace(channel, named.name);
      if (is_new) continue;
      faults.push_back(
          fmt::format("the AOVs \"{}\" and \"{}\" have the channel {} in common: give one of them another "
                      "name",
                      owner->second, named.name, channel));
      break;
    }
  }
  return faults;
}

}  // namespace strahl
