// SPDX-License-Identifier: MIT
// Taking comments out of kernel files, and recognising the few directives that the include expander follows.
#include "device/kernel_lines.h"

#include <algorithm>
#include <regex>

namespace strahl {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Appends what is code of `text` to the result; `in_comment` carries a block comment from line to line.
std::string without_comments(const std::string& text, bool& in_comment) {
  std::string bare;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string two = text.substr(i, 2);
    if (in_comment) {
      if (two != "*/") continue;
      in_comment = false;
      ++i;
      bare += ' ';
    } else if (quote != 0) {
      bare += text[i];
      if (text[i] == '\\' && i + 1 < text.size())
        bare += text[++i];
      else if (text[i] == quote)
        quote = 0;
    } else if (two == "//") {
      break;
    } else if (two == "/*") {
      in_comment = true;
      ++i;
    } else {
      bare += text[i];
      if (text[i] == '"' || text[i] == '\'') quote = text[i];
    }
  }
  return trimmed(bare);
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
  static const std::regex pattern(R"(#\s*(\w+)(?:\s+(\w+))?.*)");
  std::smatch match;
  if (bare.empty() || bare[0] != '#' || !std::regex_match(bare, match, pattern)) return {};
  return {match[1], match[2]};
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
  static const std::regex include(R"(#\s*include\s*\"([^\"]+)\")");
  std::smatch match;
  return !bare.empty() && bare[0] == '#' && std::regex_match(bare, match, include) ? match[1].str() : std::string();
}

int conditional_step(const std::string& bare) {
  const std::string word = directive(bare).first;
  if (word == "if" || word == "ifdef" || word == "ifndef") return 1;
  return word == "endif" ? -1 : 0;
}

}  // namespace strahl
