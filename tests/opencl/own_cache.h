// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace strahl::test {

/// A cache directory of one's own for one test case.
class OwnCache {
 public:
  OwnCache() {
    std::string pattern = (std::filesystem::temp_directory_path() / "strahl-test-XXXXXX").string();
    directory_ = mkdtemp(pattern.data());
    setenv("STRAHL_CACHE_DIR", directory_.c_str(), 1);
  }
  OwnCache(const OwnCache&) = delete;
  OwnCache& operator=(const OwnCache&) = delete;
  ~OwnCache() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
    unsetenv("STRAHL_CACHE_DIR");
  }

  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) paths.push_back(entry.path());
    return paths;
  }

  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

}  // namespace strahl::test
