// SPDX-License-Identifier: MIT
// Files in Mitsuba's serialized format, sound or as wrong as a test likes.
#pragma once

#include <zlib.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "scene_mesh/ply_bytes.h"

namespace strahl::test {

struct SerializedMesh {
  std::uint32_t flags = 0x1000;  // single precision
  std::string name = "a name";
  std::uint64_t vertices = 3, triangles = 1;
  std::vector<double> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0};  // positions, normals, uvs, colours
  std::vector<std::uint32_t> indices{0, 1, 2};
  std::string surplus;

  [[nodiscard]] std::string content(int version) const {
    std::string text = bytes(flags, false);
    if (version == 4) text += name + '\0';
    text += bytes(vertices, false) + bytes(triangles, false);
    for (const double x : numbers)
      text += (flags & 0x2000) != 0 ? bytes(x, false) : bytes(static_cast<float>(x), false);
    for (const std::uint32_t i : indices) text += bytes(i, false);
    return text + surplus;
  }
};

inline std::string zlib_stream(const std::string& content, int level = 6) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string stream(size, '\0');
  REQUIRE(compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
                    static_cast<uLong>(content.size()), level) == Z_OK);
  stream.resize(size);
  return stream;
}

inline std::string serialized_header(int version) {
  return bytes<std::uint16_t>(0x041C, false) + bytes(static_cast<std::uint16_t>(version), false);
}

inline std::string serialized_file(const std::vector<SerializedMesh>& meshes, int version = 4, int level = 6) {
  std::string file, list;
  for (const SerializedMesh& mesh : meshes) {
    list += version == 3 ? bytes(static_cast<std::uint32_t>(file.size()), false)
                         : bytes(static_cast<std::uint64_t>(file.size()), false);
    file += serialized_header(version) + zlib_stream(mesh.content(version), level);
  }
  return file + list + bytes(static_cast<std::uint32_t>(meshes.size()), false);
}

}  // namespace strahl::test
