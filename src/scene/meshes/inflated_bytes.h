// SPDX-License-Identifier: MIT
// A zlib stream inside a mesh file, read as bytes of any number.
#pragma once

#include <zlib.h>

#include <cstddef>

#include "scene/meshes/mesh_source.h"

namespace strahl {

/// Reports what is damaged or cut off to the source, at the stream's first byte, which throws SceneError.
class InflatedBytes {
 public:
  /// `source` must live as long.
  InflatedBytes(MeshSource& source, const char* begin);
  ~InflatedBytes();
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  void read(void* to, std::size_t size);
  /// To be called last: false where more bytes follow; checks the stream's checksum where it is at its end.
  [[nodiscard]] bool ends();
  /// How many bytes there can be at most, so that counts are doubted before memory is taken for them.
  [[nodiscard]] std::size_t most() const;

 private:
  /// Returns how many bytes were there; fewer than asked for only at the end.
  std::size_t inflate_some(void* to, std::size_t size);

  MeshSource& source_;
  const char* begin_;
  z_stream stream_{};
  bool ended_ = false;
};

}  // namespace strahl
