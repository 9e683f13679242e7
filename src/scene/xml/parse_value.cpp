// SPDX-License-Identifier: MIT
// std::from_chars, as it knows no locale; the sRGB curve is that of IEC 61966-2-1.
#include "scene/xml/parse_value.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace strahl {

namespace {

constexpr const char* blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

template <class Number>
std::errc parse_whole(std::string_view text, Number& value) {
  const std::string_view word = trimmed(text);
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* end = word.data() + word.size();
  const auto [rest, fault] = std::from_chars(word.data() + (plus ? 1 : 0), end, value);
  return rest == end ? fault : std::errc::invalid_argument;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const std::errc fault = parse_whole(text, value);
  if (fault == std::errc::result_out_of_range) {
    const double extreme =
        std::strtod(std::string(trimmed(text)).c_str(), nullptr);  // 0 or infinite, whatever the locale
    return std::abs(extreme) > 1 ? extreme : 0.0;
  }
  return fault == std::errc{} ? std::optional(value) : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) {
  int value = 0;
  const std::errc fault = parse_whole(text, value);
  if (fault == std::errc::result_out_of_range)
    return trimmed(text)[0] == '-' ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
  return fault == std::errc{} ? std::optional(value) : std::nullopt;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::optional<bool> parse_boolean(std::string_view text) {
  const std::string word = lower_case(trimmed(text));
  if (word == "true") return true;
  return word == "false" ? std::optional(false) : std::nullopt;
}

std::vector<std::string_view> split_list(std::string_view text) {
  constexpr const char* separators = ", \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = text.find_first_of(separators, at);
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(separators, end);
  }
  return words;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : split_list(text)) {
    const std::optional<double> number = parse_number(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::optional<std::array<int, 3>> parse_hex(std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word.size() != 7 || word[0] != '#') return std::nullopt;
  unsigned bits = 0;
  const char* end = word.data() + word.size();
  const auto [rest, fault] = std::from_chars(word.data() + 1, end, bits, 16);
  if (fault != std::errc{} || rest != end) return std::nullopt;
  const auto component = [bits](unsigned shift) { return static_cast<int>(bits >> shift & 0xFFU); };
  return std::array{component(16), component(8), component(0)};
}

std::optional<Rgb> parse_hex_color(std::string_view text) {
  const std::optional<std::array<int, 3>> hex = parse_hex(text);
  if (!hex) return std::nullopt;
  return Rgb{linear_from_srgb((*hex)[0] / 255.0), linear_from_srgb((*hex)[1] / 255.0),
             linear_from_srgb((*hex)[2] / 255.0)};
}

}  // namespace strahl
