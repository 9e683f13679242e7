// SPDX-License-Identifier: MIT
// A set of whole numbers whose members are found in a round.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace strahl {

/// Numbers below a limit, a bit each; a second row of bits says which words of the first have one.
class NumberSet {
 public:
  explicit NumberSet(std::size_t limit)
      : limit_(limit), words_(limit / 64 + 1, 0), filled_words_(words_.size() / 64 + 1, 0) {}

  void add(std::size_t i) {
    words_[i / 64] |= bit(i);
    filled_words_[i / 4096] |= bit(i / 64);
  }
  void remove(std::size_t i) {
    words_[i / 64] &= ~bit(i);
    if (words_[i / 64] == 0) filled_words_[i / 4096] &= ~bit(i / 64);
  }

  /// The first one from i on, which goes on at 0; none: the limit.
  [[nodiscard]] std::size_t next(std::size_t i) const {
    const std::size_t found = first(i);
    return found < limit_ ? found : first(0);
  }

 private:
  static std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << i % 64; }

  /// The first bit from i on; none: 64 for each word.
  static std::size_t first_bit(const std::vector<std::uint64_t>& words, std::size_t i) {
    if (i / 64 >= words.size()) return 64 * words.size();
    std::uint64_t word = words[i / 64] >> i % 64 << i % 64;
    for (std::size_t w = i / 64;; word = words[w]) {
      if (word != 0) return w * 64 + static_cast<std::size_t>(std::countr_zero(word));
      if (++w == words.size()) return 64 * w;
    }
  }

  [[nodiscard]] std::size_t first(std::size_t i) const {
    const std::uint64_t rest = words_[i / 64] >> i % 64 << i % 64;
    const std::size_t word = rest != 0 ? i / 64 : first_bit(filled_words_, i / 64 + 1);
    return word < words_.size() ? first_bit(words_, word == i / 64 ? i : word * 64) : limit_;
  }

  std::size_t limit_;
  std::vector<std::uint64_t> words_, filled_words_;
};

}  // namespace strahl
