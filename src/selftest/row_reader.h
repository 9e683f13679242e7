// SPDX-License-Identifier: MIT
// One line of a file of rows, word by word; a fault names file and line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/exact.h"

namespace strahl::selftest {

/// Cuts a line into words; '#' at the beginning of a word ends it.
class RowLine {
 public:
  RowLine(std::string file, int number, std::string_view text);

  [[nodiscard]] bool is_empty() const { return next_ == words_.size(); }
  /// The next word if it is this one, which is then taken.
  bool take(std::string_view word);
  [[nodiscard]] std::string word();
  [[nodiscard]] std::string rest();

  /// A number that float holds exactly, infinities and NaN included.
  [[nodiscard]] double real();
  [[nodiscard]] std::vector<double> reals(int count);
  /// A number that double holds exactly.
  [[nodiscard]] double wide_real();
  [[nodiscard]] int integer();
  void end() const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  [[nodiscard]] double number(std::string_view word) const;

  std::string file_;
  int number_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

}  // namespace strahl::selftest
