// SPDX-License-Identifier: MIT
// String parameters that name one of a few things.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "did_you_mean.h"
#include "scene/xml/properties.h"

namespace strahl {

/// The meaning of a string parameter; `absent` where it is not given, and after a warning where it means nothing.
template <class Value>
Value choice(Properties& properties, const char* name, const std::map<std::string, Value>& meanings, Value absent) {
  const std::optional<std::string> given = properties.string(name);
  if (!given) return absent;
  const auto found = meanings.find(*given);
  if (found != meanings.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [word, meaning] : meanings) names.push_back(word);
  properties.diagnostics().unknown(properties.where(name), fmt::format("unknown {} \"{}\"{}; it is ignored", name,
                                                                       *given, did_you_mean(*given, names)));
  return absent;
}

}  // namespace strahl
