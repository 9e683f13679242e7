// SPDX-License-Identifier: MIT
#include "program/lane_table.h"

#include <algorithm>
#include <unordered_set>

namespace strahl {
namespace {

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// Identifiers of the text that end in _w.
std::unordered_set<std::string_view> lane_names_of(std::string_view text) {
  std::unordered_set<std::string_view> names;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_word(text[i])) {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < text.size() && is_word(text[i])) ++i;
    const std::string_view word = text.substr(begin, i - begin);
    if (word.ends_with("_w")) names.insert(word);
  }
  return names;
}

}  // namespace

std::string used_lane_names(std::string_view table, std::string_view text) {
  const std::unordered_set<std::string_view> used = lane_names_of(text);
  std::string lines;
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = std::min(table.find('\n', begin), table.size());
    const std::string_view line = table.substr(begin, end - begin);
    constexpr std::string_view define = "#define ";
    if (line.starts_with(define)) {
      const std::string_view name = line.substr(define.size(), line.find(' ', define.size()) - define.size());
      if (used.contains(name)) lines.append(line).push_back('\n');
    }
    begin = end + 1;
  }
  return lines;
}

}  // namespace strahl
