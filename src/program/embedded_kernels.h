// SPDX-License-Identifier: MIT
// The files below cl/ as they were when the binary was built (src/embed_files.cmake).
#pragma once

#include <string_view>
#include <vector>

namespace strahl {

struct EmbeddedKernel {
  std::string_view path;  ///< Relative to cl/: "shapes/sphere/sphere.h".
  std::string_view text;
};

[[nodiscard]] const std::vector<EmbeddedKernel>& embedded_kernels();

}  // namespace strahl
