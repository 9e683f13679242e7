// SPDX-License-Identifier: MIT
// The rows of the catalogue as built into the program; src/embed_files.cmake generates the definition.
#pragma once

#include <string_view>
#include <vector>

namespace strahl::selftest {

struct EmbeddedRows {
  std::string_view name;  ///< "sphere.txt"
  std::string_view text;
};

[[nodiscard]] const std::vector<EmbeddedRows>& embedded_rows();

}  // namespace strahl::selftest
