// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements follow, and the properties of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/meshes/mesh_source.h"

namespace strahl {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] constexpr std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 0;
}

[[nodiscard]] constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< Present: a list.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  const char* at = nullptr;  ///< Its line in the header.

  /// Index of the first property with one of these names; none: -1.
  [[nodiscard]] int find(std::initializer_list<std::string_view> names) const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  const char* data = nullptr;  ///< The first byte after the header.
};

/// Throws SceneError where the header is malformed or promises more elements than the file can hold.
[[nodiscard]] PlyHeader read_ply_header(MeshSource& source);

}  // namespace strahl
