// SPDX-License-Identifier: MIT
// Collects every problem of a scene, so that all are reported at once and in file order.
#pragma once

#include <string>
#include <vector>

#include "errors.h"

namespace strahl {

class Diagnostics {
 public:
  explicit Diagnostics(bool strict) : strict_(strict) {}

  void error(const SourceLocation& where, std::string message) { add(Severity::error, where, std::move(message)); }
  void warning(const SourceLocation& where, std::string message) { add(Severity::warning, where, std::move(message)); }
  /// Something that strahl does not know: a warning, with --strict an error.
  void unknown(const SourceLocation& where, std::string message) {
    add(strict_ ? Severity::error : Severity::warning, where, std::move(message));
  }
  void append(const std::vector<Diagnostic>& others) { all_.insert(all_.end(), others.begin(), others.end()); }
  /// Files are reported in the order in which they were opened.
  void opened(const std::string& file) { files_.push_back(file); }
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  [[nodiscard]] bool has_errors() const;
  /// By file, then line, then column.
  [[nodiscard]] std::vector<Diagnostic> in_file_order() const;

 private:
  void add(Severity severity, const SourceLocation& where, std::string message) {
    all_.push_back({severity, where, std::move(message)});
  }

  bool strict_;
  std::vector<std::string> files_;
  std::vector<Diagnostic> all_;
};

}  // namespace strahl
