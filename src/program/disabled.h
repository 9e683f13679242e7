// SPDX-License-Identifier: MIT
// Which effects a picture can do without, for --disable: what is left out of the program is left out of what is packed
// too, so that such a program renders a simpler scene, never a wrong one. docs/cli.md says what takes each one's place.
#pragma once

#include <set>
#include <string>

namespace strahl {

/// Why nothing can be rendered without an effect, and what to do instead; empty: it can be left out. Throws UsageError
/// that lists the names where there is no such effect.
[[nodiscard]] std::string needed_because(const std::string& name);

/// The names, and what means nothing without them: without EMISSION there are no area lights, without these no areas.
/// Throws UsageError where one cannot be left out.
[[nodiscard]] std::set<std::string> disabled_effects(const std::set<std::string>& disabled);

}  // namespace strahl
