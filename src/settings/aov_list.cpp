// SPDX-License-Identifier: MIT
#include "settings/aov_list.h"

#include <algorithm>

#include "settings/settings.h"

namespace strahl {

bool AovList::contains(Aov aov) const {
  return plain_.contains(aov) ||
         std::any_of(named_.begin(), named_.end(), [aov](const NamedAov& named) { return named.aov == aov; });
}

std::vector<std::string> AovList::plain_names() const {
  std::vector<std::string> names;
  for (const Aov aov : plain_) names.emplace_back(aov_name(aov));
  return names;
}

bool AovList::names_first_samples() const {
  return std::any_of(named_.begin(), named_.end(), [](const NamedAov& named) { return is_of_first_sample(named.aov); });
}

}  // namespace strahl
