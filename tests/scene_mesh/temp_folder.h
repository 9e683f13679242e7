// SPDX-License-Identifier: MIT
// A folder for the files that a test writes, gone with the object; and what the mesh readers say about them.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "scene/meshes/mesh_file.h"

namespace strahl::test {

class TempFolder {
 public:
  TempFolder() {
    const std::filesystem::path memory = "/dev/shm";  // tests write thousands of small files
    const auto parent = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "strahl-mesh-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~TempFolder() {
    std::error_code ignored;  // a folder left behind harms no test
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  /// Writes the file and returns its path.
  std::string write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    REQUIRE(file.good());
    return path.string();
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// Diagnostics as lines "name:line:column: error: message" without the folder.
inline std::string text_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (Diagnostic d : diagnostics) {
    d.where.file = std::filesystem::path(d.where.file).filename().string();
    text += d.text() + '\n';
  }
  return text;
}

/// What the reader says where it must refuse the file.
inline std::string error_of(const std::string& path) {
  try {
    static_cast<void>(read_mesh(path));
  } catch (const SceneError& error) {
    return text_of(error.diagnostics());
  }
  FAIL("no error for " << path);
  return {};
}

}  // namespace strahl::test
