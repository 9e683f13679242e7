// SPDX-License-Identifier: MIT
// "OpenEXR File Layout" (openexr.com): magic, version, and for each part attributes of a name, a type, a length and a
// value; an empty name ends a part's, and an empty part those of a file of several.
#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace strahl {
namespace {

/// Zero-terminated.
std::string_view take_text(std::string_view& rest) {
  const std::string_view text = rest.substr(0, rest.find('\0'));
  rest.remove_prefix(std::min(text.size() + 1, rest.size()));
  return text;
}

std::uint32_t take_number(std::string_view& rest) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<unsigned char>(rest[i])} << 8 * i;
  rest.remove_prefix(4);
  return number;
}

struct Attribute {
  std::string_view name, type, value;

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::runtime_error(fmt::format("attribute \"{}\" of type {} and {} bytes {}", name, type, value.size(), why));
  }
};

/// Bytes of the types that have always as many; the library reads so many, whatever the attribute says.
const std::map<std::string_view, std::size_t>& sizes() {
  static const std::map<std::string_view, std::size_t> all{
      {"box2f", 16},      {"box2i", 16},         {"chromaticities", 32},
      {"compression", 1}, {"deepImageState", 1}, {"double", 8},
      {"envmap", 1},      {"float", 4},          {"int", 4},
      {"keycode", 28},    {"lineOrder", 1},      {"m33d", 72},
      {"m33f", 36},       {"m44d", 128},         {"m44f", 64},
      {"rational", 8},    {"v2d", 16},           {"v2f", 8},
      {"v2i", 8},         {"tiledesc", 9},       {"timecode", 8},
      {"v3d", 24},        {"v3f", 12},           {"v3i", 12},
  };
  return all;
}

/// Channels: a name each, and 16 bytes; an empty name ends them.
bool is_channel_list(std::string_view rest) {
  while (!rest.empty()) {
    if (take_text(rest).empty()) return rest.empty();
    rest.remove_prefix(std::min<std::size_t>(rest.size(), 16));
  }
  return false;
}

/// Texts: each a length, and so many bytes.
bool is_string_vector(std::string_view rest) {
  while (rest.size() >= 4) {
    const std::uint32_t length = take_number(rest);
    if (length > rest.size()) return false;
    rest.remove_prefix(length);
  }
  return rest.empty();
}

/// Width, height and as many pixels of 4 bytes.
bool is_preview(std::string_view rest) {
  if (rest.size() < 8) return false;
  const std::uint64_t width = take_number(rest), height = take_number(rest);
  return width * height == rest.size() / 4 && rest.size() % 4 == 0;
}

/// The library reads on where it thinks that a value ends: there the next attribute has to begin.
void require_value_fits(const Attribute& attribute) {
  const auto found = sizes().find(attribute.type);
  if (found != sizes().end() && found->second != attribute.value.size())
    attribute.refuse(fmt::format("is to have {} bytes", found->second));
  if (attribute.type == "chlist" && !is_channel_list(attribute.value)) attribute.refuse("is no list of channels");
  if (attribute.type == "stringvector" && !is_string_vector(attribute.value)) attribute.refuse("is no list of texts");
  if (attribute.type == "preview" && !is_preview(attribute.value)) attribute.refuse("is no picture");
}

/// Whether there was one.
bool take_attribute(std::string_view& rest) {
  Attribute attribute;
  attribute.name = take_text(rest);
  if (attribute.name.empty()) return false;
  attribute.type = take_text(rest);
  if (rest.size() < 4) return false;
  const std::uint32_t length = take_number(rest);
  if (length > rest.size())
    throw std::runtime_error(
        fmt::format("attribute \"{}\" is to have {} bytes, and {} are left", attribute.name, length, rest.size()));
  attribute.value = rest.substr(0, length);
  require_value_fits(attribute);
  rest.remove_prefix(length);
  return true;
}

/// Whether it had any attributes.
bool take_part(std::string_view& rest) {
  bool had_any = false;
  while (take_attribute(rest)) had_any = true;
  return had_any;
}

}  // namespace

void require_attributes_fit(std::string_view bytes) {
  constexpr std::size_t magic_bytes = 4;
  constexpr std::uint32_t multi_part = 0x1000;
  if (bytes.size() < magic_bytes + 4) return;
  std::string_view rest = bytes.substr(magic_bytes);
  const bool has_parts = (take_number(rest) & multi_part) != 0;
  while (take_part(rest) && has_parts) {
  }
}

}  // namespace strahl
