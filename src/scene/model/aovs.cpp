// SPDX-License-Identifier: MIT
#include "scene/model/aovs.h"

#include <fmt/format.h>

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

}  // namespace strahl
