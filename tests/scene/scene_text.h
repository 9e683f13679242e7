// SPDX-License-Identifier: MIT
// Scenes of the loader's tests, written to a folder of their own and loaded from there.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/loader.h"

namespace strahl::test {

class SceneFolder {
 public:
  SceneFolder() : folder_(std::filesystem::temp_directory_path() / ("strahl-scene-test-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~SceneFolder() { std::filesystem::remove_all(folder_); }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

/// A scene around `body`, which begins in line 2, and a sensor so that none is missing.
inline std::string around(const std::string& body) {
  return "<scene version=\"3.0.0\">\n" + body + "\n<sensor type=\"perspective\"/></scene>\n";
}

inline LoadedScene load_text(const std::string& text, const LoadOptions& options = {}) {
  const SceneFolder folder;
  return load_scene(folder.write("scene.xml", text), options);
}

inline LoadedScene load_body(const std::string& body, const LoadOptions& options = {}) {
  return load_text(around(body), options);
}

/// "line:column: severity: message" of every problem, in the order of the report; files by name only.
inline std::vector<std::string> shortened(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> lines;
  for (const Diagnostic& d : diagnostics) {
    const std::string file = std::filesystem::path(d.where.file).filename().string();
    const std::string place = file == "scene.xml" ? "" : file + ":";
    lines.push_back(place + std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + ": " +
                    (d.severity == Severity::error     ? "error: "
                     : d.severity == Severity::warning ? "warning: "
                                                       : "note: ") +
                    d.message);
  }
  return lines;
}

/// All problems of a text, whether it loads or not.
inline std::vector<std::string> problems(const std::string& text, const LoadOptions& options = {}) {
  try {
    return shortened(load_text(text, options).warnings);
  } catch (const SceneError& error) {
    return shortened(error.diagnostics());
  }
}

}  // namespace strahl::test
