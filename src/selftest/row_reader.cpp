// SPDX-License-Identifier: MIT
#include "selftest/row_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "errors.h"

namespace strahl::selftest {

RowLine::RowLine(std::string file, int number, std::string_view text) : file_(std::move(file)), number_(number) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::size_t i = 0; i < text.size();) {
    if (is_blank(text[i])) {
      ++i;
      continue;
    }
    if (text[i] == '#') break;
    const std::size_t begin = i;
    while (i < text.size() && !is_blank(text[i])) ++i;
    words_.emplace_back(text.substr(begin, i - begin));
  }
}

void RowLine::fail(const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}", file_, number_, message));
}

bool RowLine::take(std::string_view word) {
  if (is_empty() || words_[next_] != word) return false;
  ++next_;
  return true;
}

std::string RowLine::word() {
  if (is_empty()) fail("the line ends too early");
  return words_[next_++];
}

std::string RowLine::rest() {
  std::string text = word();
  while (!is_empty()) text += " " + word();
  return text;
}

double RowLine::number(std::string_view word) const {
  const std::string text(word);
  char* end = nullptr;
  // The program stays in the C locale, and strtod alone reads hexadecimal floats with their 0x.
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') fail(fmt::format("\"{}\" is not a number", text));
  if (std::isinf(value) && text.find("inf") == std::string::npos) fail(fmt::format("{} is beyond double", text));
  return value;
}

double RowLine::real() {
  const std::string text = word();
  const double value = number(text);
  if (!std::isnan(value) && static_cast<double>(static_cast<float>(value)) != value)
    fail(fmt::format("{} is not a float; the nearest is {:a}", text, static_cast<float>(value)));
  return value;
}

std::vector<double> RowLine::reals(int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(real());
  return values;
}

double RowLine::wide_real() { return number(word()); }

int RowLine::integer() {
  const double value = number(word());
  if (!(std::fabs(value) < 1e9) || value != std::floor(value)) fail("an integer is needed here");
  return static_cast<int>(value);
}

void RowLine::end() const {
  if (!is_empty()) fail(fmt::format("\"{}\" is one word too many", words_[next_]));
}

}  // namespace strahl::selftest
