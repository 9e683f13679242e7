// SPDX-License-Identifier: MIT
// The lines of cl/lanes/lane_table.h that a program needs: a table of all names would change the text of every program
// whenever a name is added anywhere.
#pragma once

#include <string>
#include <string_view>

namespace strahl {

/// The lines `#define NAME ...` of `table` whose NAME occurs in `text` as a whole identifier, in the table's order.
[[nodiscard]] std::string used_lane_names(std::string_view table, std::string_view text);

}  // namespace strahl
