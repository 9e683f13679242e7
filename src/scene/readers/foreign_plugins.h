// SPDX-License-Identifier: MIT
// What Mitsuba has and strahl has not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strahl {

/// The types that Mitsuba (3 or 0.x) has of an element; docs/scene-format.md lists them.
[[nodiscard]] const std::vector<std::string>& mitsuba_types(std::string_view tag);

/// `bsdf "hair" is not supported yet` where Mitsuba (3 or 0.x) has such a plugin, else `unknown bsdf "difuse" (did you
/// mean "diffuse"?)`. known: the types that strahl has.
[[nodiscard]] std::string not_available(std::string_view tag, std::string_view type,
                                        const std::vector<std::string>& known);

}  // namespace strahl
