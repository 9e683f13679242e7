// SPDX-License-Identifier: MIT
#include "settings/aov_list.h"

#include <algorithm>

namespace strahl {

bool AovList::contains(Aov aov) const {
  return plain_.contains(aov) ||
         std::any_of(named_.begin(), named_.end(), [aov](const NamedAov& named) { return named.aov == aov; });
}

}  // namespace strahl
