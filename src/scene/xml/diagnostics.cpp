// SPDX-License-Identifier: MIT
// Order of the collected problems, and what is left of those that are alike.
#include "scene/xml/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace strahl {

namespace {

constexpr std::size_t most_alike = 3;

}  // namespace

void Diagnostics::unreadable(const SourceLocation& where, const std::string& path, const std::string& obstacle) {
  all_.push_back({{Severity::error, where,
                   fmt::format("cannot read \"{}\": {} (the path counts from the scene file)", path, obstacle)},
                  "unreadable file"});
}

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(), [](const Problem& p) { return p.told.severity == Severity::error; });
}

std::vector<Diagnostic> Diagnostics::in_file_order() const {
  const auto rank = [this](const std::string& file) { return std::find(files_.begin(), files_.end(), file); };
  std::vector<const Problem*> sorted;
  for (const Problem& problem : all_) sorted.push_back(&problem);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Problem* left, const Problem* right) {
    const SourceLocation &a = left->told.where, &b = right->told.where;
    return std::make_tuple(rank(a.file), a.line, a.column) < std::make_tuple(rank(b.file), b.line, b.column);
  });
  std::map<std::pair<Severity, std::string>, std::vector<const Problem*>> kinds;
  for (const Problem* problem : sorted) kinds[{problem->told.severity, problem->kind}].push_back(problem);
  std::vector<Diagnostic> told;
  for (const Problem* problem : sorted) {
    const std::vector<const Problem*>& alike = kinds[{problem->told.severity, problem->kind}];
    if (alike.size() > most_alike && problem != alike.front()) continue;
    told.push_back(problem->told);
    if (alike.size() > most_alike)
      told.back().message += fmt::format("; {} more like it, the next at {} and {}", alike.size() - 1,
                                         alike[1]->told.where.text(), alike[2]->told.where.text());
  }
  return told;
}

}  // namespace strahl
