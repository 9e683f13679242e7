// SPDX-License-Identifier: MIT
// Order of the collected problems, and what is left of those that are alike.
#include "scene/xml/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

namespace strahl {

namespace {

constexpr std::size_t most_alike = 3;

/// The message without its numbers, but for those in names, which stand in quotes.
std::string without_numbers(const std::string& message) {
  const auto is_digit = [&](std::size_t i) { return i < message.size() && message[i] >= '0' && message[i] <= '9'; };
  const auto is_any = [&](std::size_t i, std::string_view of) {
    return i < message.size() && of.find(message[i]) != std::string_view::npos;
  };
  std::string rest;
  bool is_quoted = false;
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (message[i] == '"') is_quoted = !is_quoted;
    const bool is_exponent = is_any(i, "e") && i > 0 && is_digit(i - 1) && (is_digit(i + 1) || is_any(i + 1, "+-"));
    if (is_quoted || !(is_digit(i) || is_exponent || (is_any(i, "+-.") && is_digit(i + 1)))) rest += message[i];
  }
  return rest;
}

}  // namespace

/// Warnings and notes that differ in numbers alone are alike: a remedy is the same for all of them. Errors are all to
/// be mended.
void Diagnostics::add(Severity severity, const SourceLocation& where, std::string message) {
  std::string kind = severity == Severity::error ? message : without_numbers(message);
  all_.push_back({{severity, where, std::move(message)}, std::move(kind)});
}

void Diagnostics::unreadable(const SourceLocation& where, const std::string& path, const std::string& obstacle) {
  all_.push_back({{Severity::error, where,
                   fmt::format("cannot read \"{}\": {} (the path counts from the scene file)", path, obstacle)},
                  "unreadable file"});
}

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(), [](const Problem& p) { return p.told.severity == Severity::error; });
}

std::vector<Diagnostic> Diagnostics::in_file_order() const {
  std::unordered_map<std::string, std::size_t> ranks;
  for (const std::string& file : files_) ranks.try_emplace(file, ranks.size());
  const auto rank = [&](const std::string& file) {
    const auto found = ranks.find(file);
    return found == ranks.end() ? files_.size() : found->second;
  };
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
