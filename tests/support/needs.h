// SPDX-License-Identifier: MIT
// Tests of data that not every checkout has beside it.
#pragma once

#include <filesystem>
#include <source_location>
#include <string>
#include <vector>

namespace strahl::test {

/// A global of this type makes a run of its file's tests alone exit with 77 (ctest: skipped) where `path` does not
/// exist.
class Needs {
 public:
  explicit Needs(std::string path, std::source_location where = std::source_location::current()) {
    all().push_back({std::filesystem::path(where.file_name()).stem().string(), std::move(path)});
  }

  struct Need {
    std::string file;  ///< The test's, as Catch's tag for it.
    std::string path;
  };
  static std::vector<Need>& all() {
    static std::vector<Need> needs;
    return needs;
  }
};

}  // namespace strahl::test
