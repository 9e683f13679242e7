// SPDX-License-Identifier: MIT
// Which three channels of a file are the colours of a texture.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace strahl {

struct NamedColours {
  std::array<std::size_t, 3> places{};  ///< Among the channels.
  bool are_xyz = false;                 ///< X, Y, Z; else R, G, B.
};

/// R, G, B; else X, Y, Z; else R, G, B of the first layer that has all three; else, as layers of X, Y and Z are often
/// positions and normals, of a file without a Y, those of the first such layer. None where there are none.
[[nodiscard]] std::optional<NamedColours> named_colours(const std::vector<std::string>& channels);

}  // namespace strahl
