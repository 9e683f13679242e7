// SPDX-License-Identifier: MIT
// Where the files that a scene names are looked for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strahl {

class SearchPath {
 public:
  explicit SearchPath(std::string main_file) : main_file_(std::move(main_file)) {}

  /// Puts a folder before all others (<path>).
  void prepend(std::string folder) { folders_.insert(folders_.begin(), std::move(folder)); }
  /// `name` in one of the folders of <path>, beside the file that asks for it, beside the main scene file, or in the
  /// current folder, whichever has it first; where none has, with the backslashes of Windows as slashes, else beside
  /// the asking file. Absolute names stay.
  [[nodiscard]] std::string find(std::string_view name, const std::string& asking_file) const;

 private:
  std::string main_file_;
  std::vector<std::string> folders_;
};

}  // namespace strahl
