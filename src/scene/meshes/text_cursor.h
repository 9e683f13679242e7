// SPDX-License-Identifier: MIT
// A position in the text of an OBJ, MTL or ASCII PLY file that moves word by word and line by line.
//
// Words are separated by blanks, tabs and carriage returns. A backslash at the end of a line joins the next one (not in
// PLY); '#' at the beginning of a word ends the line. Own code, as std::from_chars is locale-free, exact and several
// times as fast as streams.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace strahl {

/// Whether a backslash at the end of a line joins the next one (OBJ, MTL) or means nothing (PLY).
enum class LineJoin { backslash, none };

class TextCursor {
 public:
  TextCursor(const char* begin, const char* end, LineJoin join = LineJoin::backslash)
      : p_(begin), end_(end), join_(join) {}

  [[nodiscard]] const char* position() const { return p_; }
  [[nodiscard]] bool at_end() const { return p_ == end_; }

  /// Moves to the next word of the line; false where there is none.
  bool find_word() {
    while (p_ != end_) {
      if (is_blank(*p_)) {
        ++p_;
      } else if (const char* next = joined_line(p_)) {
        p_ = next;
      } else {
        return *p_ != '\n' && *p_ != '#';
      }
    }
    return false;
  }

  /// The next word of the line, empty where there is none.
  std::string_view word() {
    if (!find_word()) return {};
    const char* begin = p_;
    while (p_ != end_ && !is_blank(*p_) && *p_ != '\n' && joined_line(p_) == nullptr) ++p_;
    return {begin, static_cast<std::size_t>(p_ - begin)};
  }

  /// The rest of the line as a name: inner blanks stay, also '#', outer ones go.
  std::string rest() {
    std::string text;
    while (p_ != end_ && *p_ != '\n') {
      const char* next = joined_line(p_);
      text += next != nullptr ? ' ' : *p_;
      p_ = next != nullptr ? next : p_ + 1;
    }
    const auto first = text.find_first_not_of(" \t\r\v\f");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\v\f") - first + 1);
  }

  /// Moves to the beginning of the next line; a comment does not join lines.
  void next_line() {
    const bool comment = p_ != end_ && *p_ == '#';
    while (p_ != end_) {
      const void* found = std::memchr(p_, '\n', static_cast<std::size_t>(end_ - p_));
      const char* begin = p_;
      const char* newline = found != nullptr ? static_cast<const char*>(found) : end_;
      p_ = newline == end_ ? end_ : newline + 1;
      const char* last = newline;
      if (last != begin && last[-1] == '\r') --last;
      if (comment || join_ == LineJoin::none || last == begin || last[-1] != '\\') return;
    }
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

  /// Where the line goes on if it is continued at `p`, else null.
  [[nodiscard]] const char* joined_line(const char* p) const {
    if (*p != '\\' || join_ == LineJoin::none) return nullptr;
    ++p;
    if (p != end_ && *p == '\r') ++p;
    return p != end_ && *p == '\n' ? p + 1 : nullptr;
  }

  const char* p_;
  const char* end_;
  LineJoin join_;
};

/// The whole word as a number ("+1", ".5" and "1e+05" are numbers). Too large is infinite, too small is 0; false and
/// NaN where it is not a number.
inline bool parse_number(std::string_view word, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  double parsed = 0;
  const auto [stop, code] = std::from_chars(word.data(), end, parsed);
  if (stop != end || code == std::errc::invalid_argument) return false;
  if (code == std::errc::result_out_of_range) {
    long double wide = 0;  // tells overflow from underflow
    if (std::from_chars(word.data(), end, wide).ec != std::errc{}) return false;
    parsed = static_cast<double>(wide);
  }
  value = parsed;
  return true;
}

/// The whole word as an integer; one that does not fit becomes the largest or smallest.
inline bool parse_integer(std::string_view word, std::int64_t& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return false;
  if (code == std::errc::result_out_of_range) {
    value = word[0] == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
  }
  return true;
}

}  // namespace strahl
