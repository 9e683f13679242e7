// SPDX-License-Identifier: MIT
// Tests of data that not every checkout has beside it.
#pragma once

#include <string>
#include <vector>

namespace strahl::test {

/// A global of this type makes the whole program exit with 77 (ctest: skipped) where `path` does not exist.
class Needs {
 public:
  explicit Needs(const std::string& path) { paths().push_back(path); }
  static std::vector<std::string>& paths() {
    static std::vector<std::string> all;
    return all;
  }
};

}  // namespace strahl::test
