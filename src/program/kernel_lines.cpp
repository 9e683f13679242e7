// SPDX-License-Identifier: MIT
// Taking comments out of kernel files, and recognising the few directives that the include expander follows.
#include "program/kernel_lines.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace strahl {

namespace {

constexpr std::string_view spaces = " \t\r";

void trim(std::string& text) {
  text.erase(text.find_last_not_of(spaces) + 1);
  text.erase(0, text.find_first_not_of(spaces));
}

/// The part of `text` from `at` on without the space it begins with.
std::string_view after_space(std::string_view text, std::size_t at) {
  text.remove_prefix(at);
  text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
  return text;
}

std::string_view first_word(std::string_view text) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word) - text.begin()));
}

/// What of `text` is code, without space at either end; `in_comment` carries a block comment from line to line.
std::string without_comments(std::string_view text, bool& in_comment) {
  std::string bare;
  bare.reserve(text.size());
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (in_comment) {
      if (text[i] != '*' || next != '/') continue;
      in_comment = false;
      ++i;
      bare += ' ';
    } else if (quote != 0) {
      bare += text[i];
      if (text[i] == '\\' && i + 1 < text.size())
        bare += text[++i];
      else if (text[i] == quote)
        quote = 0;
    } else if (text[i] == '/' && next == '/') {
      break;
    } else if (text[i] == '/' && next == '*') {
      in_comment = true;
      ++i;
    } else {
      bare += text[i];
      if (text[i] == '"' || text[i] == '\'') quote = text[i];
    }
  }
  trim(bare);
  return bare;
}

}  // namespace

std::vector<KernelLine> kernel_lines(const std::string& text) {
  std::vector<KernelLine> lines;
  bool in_comment = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    std::string bare = without_comments(line, in_comment);
    lines.push_back({std::move(line), std::move(bare)});
    begin = end + 1;
  }
  return lines;
}

std::pair<std::string, std::string> directive(const std::string& bare) {
  if (bare.empty() || bare[0] != '#') return {};
  const std::string_view from_name = after_space(bare, 1);
  const std::string_view name = first_word(from_name);
  const std::string_view rest = from_name.substr(name.size());
  const std::string_view argument = after_space(rest, 0);
  return {std::string(name), argument.size() < rest.size() ? std::string(first_word(argument)) : std::string()};
}

std::string include_guard(const std::vector<KernelLine>& lines) {
  std::vector<std::string> code;
  for (const KernelLine& line : lines) {
    if (!line.bare.empty()) code.push_back(line.bare);
  }
  if (code.size() < 3) return {};
  const auto [first, guard] = directive(code[0]);
  if (first != "ifndef" || directive(code[1]) != std::pair<std::string, std::string>("define", guard)) return {};
  int depth = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const std::string word = directive(code[i]).first;
    if (depth == 1 && (word == "else" || word == "elif")) return {};
    depth += conditional_step(code[i]);
    if (depth == 0) return i + 1 == code.size() ? guard : std::string();
  }
  return {};
}

std::string included_path(const std::string& bare) {
  constexpr std::string_view include = "include";
  if (bare.empty() || bare[0] != '#') return {};
  std::string_view rest = after_space(bare, 1);
  if (!rest.starts_with(include)) return {};
  rest = after_space(rest, include.size());
  const bool is_quoted = rest.size() > 2 && rest.front() == '"' && rest.find('"', 1) == rest.size() - 1;
  return is_quoted ? std::string(rest.substr(1, rest.size() - 2)) : std::string();
}

int conditional_step(const std::string& bare) {
  const std::string word = directive(bare).first;
  if (word == "if" || word == "ifdef" || word == "ifndef") return 1;
  return word == "endif" ? -1 : 0;
}

}  // namespace strahl
