// SPDX-License-Identifier: MIT
// The known word that was probably meant by an unknown one.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace strahl {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// ` (did you mean "radius"?)`, or nothing where no candidate is within a third of the word's length.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// did_you_mean() of many words, each looked up once. A damaged file may lack a million names and have a million
/// others: after so much comparing there are no suggestions.
class Suggestions {
 public:
  /// names: gives the candidates, of which there are `count`.
  template <class Names>
  [[nodiscard]] std::string operator()(std::string_view word, std::size_t count, const Names& names) {
    if (const auto known = known_.find(word); known != known_.end()) return known->second;
    if (spent_ > most) return {};
    spent_ += count * word.size();
    return known_.emplace(word, did_you_mean(word, names())).first->second;
  }

 private:
  static constexpr std::size_t most = 10'000'000;  ///< Characters of words times candidates: about two seconds.

  std::map<std::string, std::string, std::less<>> known_;
  std::size_t spent_ = 0;
};

}  // namespace strahl
