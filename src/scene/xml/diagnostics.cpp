// SPDX-License-Identifier: MIT
// Order of the collected problems.
#include "scene/xml/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace strahl {

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::vector<Diagnostic> Diagnostics::in_file_order() const {
  const auto rank = [this](const std::string& file) { return std::find(files_.begin(), files_.end(), file); };
  std::vector<Diagnostic> sorted = all_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return std::make_tuple(rank(a.where.file), a.where.line, a.where.column) <
           std::make_tuple(rank(b.where.file), b.where.line, b.where.column);
  });
  return sorted;
}

}  // namespace strahl
