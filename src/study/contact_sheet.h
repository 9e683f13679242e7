// SPDX-License-Identifier: MIT
// Pictures of one size in rows and columns, with a word to each.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace strahl {

struct SheetTile {
  Image picture;  ///< R, G, B, as large as all others.
  std::string caption;
};

struct SheetRow {
  std::string label;
  std::vector<SheetTile> tiles;  ///< One a column.
};

/// Captions stand below, columns' labels above, rows' labels to the left; columns are as wide as the widest of it.
/// Letters and digits, space, '.', '+', '-'; anything else is left blank. Throws std::logic_error where there is no
/// tile, or one of another size.
[[nodiscard]] Image contact_sheet(const std::vector<std::string>& columns, const std::vector<SheetRow>& rows);

}  // namespace strahl
