// SPDX-License-Identifier: MIT
// Which values beside the picture a render is asked for, and under which names.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "scene/model/aovs.h"

namespace strahl {

/// Those of --aov have strahl's names for layers ("depth.Z"), those of a scene its own. A value that both ask for is
/// computed once.
class AovList {
 public:
  AovList() = default;
  AovList(std::set<Aov> plain) : plain_(std::move(plain)) {}
  AovList(std::initializer_list<Aov> plain) : plain_(plain) {}

  void add(Aov aov) { plain_.insert(aov); }
  void add(NamedAov named) { named_.push_back(std::move(named)); }
  void clear() { *this = {}; }

  [[nodiscard]] bool empty() const { return plain_.empty() && named_.empty(); }
  [[nodiscard]] std::size_t size() const { return plain_.size() + named_.size(); }
  [[nodiscard]] bool contains(Aov aov) const;
  [[nodiscard]] bool names_first_samples() const;  ///< Whether the scene's are of first samples, some of them.
  [[nodiscard]] const std::set<Aov>& plain() const { return plain_; }
  [[nodiscard]] std::vector<std::string> plain_names() const;
  [[nodiscard]] const std::vector<NamedAov>& named() const { return named_; }

 private:
  std::set<Aov> plain_;
  std::vector<NamedAov> named_;
};

}  // namespace strahl
