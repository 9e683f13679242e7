// SPDX-License-Identifier: MIT
// "OpenEXR File Layout" (openexr.com): magic, version, and for each part attributes of a name, a type, a length and a
// value; an empty name ends a part's, and an empty part those of a file of several.
#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
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

/// Whether there was one.
bool take_attribute(std::string_view& rest) {
  const std::string_view name = take_text(rest);
  if (name.empty()) return false;
  take_text(rest);
  if (rest.size() < 4) return false;
  const std::uint32_t length = take_number(rest);
  if (length > rest.size())
    throw std::runtime_error(
        fmt::format("attribute \"{}\" is to have {} bytes, and {} are left", name, length, rest.size()));
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
