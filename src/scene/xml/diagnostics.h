// SPDX-License-Identifier: MIT
// Collects every problem of a scene, so that all are reported at once and in file order. Like ones become one.
#pragma once

#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "errors.h"

namespace strahl {

class Diagnostics {
 public:
  explicit Diagnostics(bool strict) : strict_(strict) {}

  void error(const SourceLocation& where, std::string message) { add(Severity::error, where, std::move(message)); }
  void warning(const SourceLocation& where, std::string message) { add(Severity::warning, where, std::move(message)); }
  void note(const SourceLocation& where, std::string message) { add(Severity::note, where, std::move(message)); }
  /// Something that strahl does not know: a warning, with --strict an error.
  void unknown(const SourceLocation& where, std::string message) {
    add(strict_ ? Severity::error : Severity::warning, where, std::move(message));
  }
  /// An error: a file that `where` asks for and that cannot be read. Many of them are alike, whatever their names.
  void unreadable(const SourceLocation& where, const std::string& path, const std::string& obstacle);
  void append(const std::vector<Diagnostic>& others) {
    for (const Diagnostic& other : others) add(other.severity, other.where, other.message);
  }
  /// Files are reported in the order in which they were first opened. To be called for those that are there.
  void opened(const std::string& file) {
    if (known_files_.insert(file).second) files_.push_back(file);
  }
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  [[nodiscard]] bool has_errors() const;
  /// By file, then line, then column. Of more than three that are alike only the first is left, which counts them and
  /// names the places of the next two.
  [[nodiscard]] std::vector<Diagnostic> in_file_order() const;

 private:
  struct Problem {
    Diagnostic told;
    std::string kind;  ///< Problems of one kind are alike.
  };

  void add(Severity severity, const SourceLocation& where, std::string message);

  bool strict_;
  std::vector<std::string> files_;
  std::unordered_set<std::string> known_files_;
  std::vector<Problem> all_;
};

}  // namespace strahl
