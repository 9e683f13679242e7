// SPDX-License-Identifier: MIT
// Indices of refraction by name, as Mitsuba has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace strahl {

/// Of "water", "bk7", ...; upper and lower case alike. None where the name is unknown.
[[nodiscard]] std::optional<double> refractive_index(std::string_view name);

/// All of them, for messages.
[[nodiscard]] std::vector<std::string> refractive_names();

}  // namespace strahl
