// SPDX-License-Identifier: MIT
// The numbers of entries among a program's (Features::entry_index), each looked up once: a scene may have many
// materials, textures and lights.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "program/features.h"

namespace strahl {

class EntryNumbers {
 public:
  /// features: outlives this.
  explicit EntryNumbers(const Features& features) : features_(features) {}

  [[nodiscard]] int operator()(const std::string& list, const std::string& entry) {
    const auto [found, is_new] = known_.try_emplace({list, entry}, -1);
    if (is_new) found->second = features_.entry_index(list, entry);
    return found->second;
  }

 private:
  const Features& features_;
  std::map<std::pair<std::string, std::string>, int> known_;
};

}  // namespace strahl
