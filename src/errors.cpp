// SPDX-License-Identifier: MIT
// Texts of the exceptions in errors.h.
#include "errors.h"

#include <fmt/format.h>

#include "opencl/cl_code.h"

namespace strahl {

std::string SourceLocation::text() const {
  if (line == 0) return file;
  if (column == 0) return fmt::format("{}:{}", file, line);
  return fmt::format("{}:{}:{}", file, line, column);
}

namespace {

/// Names from a scene must not end a line and begin another that looks like strahl's own.
std::string on_one_line(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("\n\r", at)) != std::string::npos; at += 2)
    text.replace(at, 1, text[at] == '\n' ? "\\n" : "\\r");
  return text;
}

}  // namespace

std::string Diagnostic::text() const {
  const char* kind = severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
  const std::string place = where.text();
  return on_one_line(place.empty() ? fmt::format("{}: {}", kind, message)
                                   : fmt::format("{}: {}: {}", place, kind, message));
}

namespace {
std::string all_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    if (!text.empty()) text += '\n';
    text += d.text();
  }
  return text;
}
}  // namespace

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : Error(all_of(diagnostics), ExitCode::input), diagnostics_(std::move(diagnostics)) {}

DeviceError::DeviceError(const std::string& call, int code, const std::string& device, const std::string& detail)
    : Error(fmt::format("{} failed with {} on {}{}{}", call, cl_code_name(code), device, detail.empty() ? "" : ": ",
                        detail)),
      code_(code) {}

}  // namespace strahl
