// SPDX-License-Identifier: MIT
// The built program, run as a user runs it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace strahl_test {

struct Outcome {
  int code = -1;    ///< Exit code; -1 where a signal ended it.
  int signal = 0;   ///< The signal that ended it.
  std::string out;  ///< Standard output.
  std::string err;  ///< Standard error.
};

/// A folder of its own for each test case, removed with everything in it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;
  /// Names of the files in it, sorted.
  [[nodiscard]] std::vector<std::string> files() const;

  /// Runs `strahl ARGUMENTS` in this folder; `while_running` gets its process id.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments,
                            const std::map<std::string, std::string>& environment = {},
                            const std::function<void(pid_t)>& while_running = {}) const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path streams_;
};

[[nodiscard]] std::string read_text(const std::string& path);
[[nodiscard]] bool contains(const std::string& text, const std::string& part);

/// A sphere of radius 1 around the origin that emits (4, 2, 1), seen from +z; 32 x 24 pixels, `emission`.
extern const char* const glowing_sphere;

}  // namespace strahl_test
