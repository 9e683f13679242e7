// SPDX-License-Identifier: MIT
// The rows of a test are those of a list: none is missing, and each calls for its entry.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace strahl::test {

/// list: its file's name. packed(row): the number of the entry that the row's scene calls for, as packed.
template <class Row, class Packed>
void hold_rows(const std::string& list, const std::vector<std::string>& entries, const std::vector<Row>& rows,
               Packed packed) {
  for (const Row& row : rows) {
    const auto entry = std::find(entries.begin(), entries.end(), row.entry);
    INFO(list << " has no " << row.entry);
    REQUIRE(entry != entries.end());
    INFO("the scene of the row of " << row.entry << " calls for another entry");
    CHECK(packed(row) == entry - entries.begin());
  }
  for (const std::string& entry : entries) {
    INFO(list << " has " << entry << ", which has no row here");
    CHECK(std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.entry == entry; }));
  }
}

}  // namespace strahl::test
