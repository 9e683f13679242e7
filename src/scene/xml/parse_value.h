// SPDX-License-Identifier: MIT
// Numbers, lists and switches from the text of an attribute; independent of the locale.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/vec.h"

namespace strahl {

/// The whole text as a number; too large is infinite, too small is 0. "inf" and "nan" are read: callers say that the
/// value is not finite.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
/// Beyond the range of int it is the nearest one.
[[nodiscard]] std::optional<int> parse_integer(std::string_view text);
[[nodiscard]] std::string lower_case(std::string_view text);
/// "true" and "false", in upper or lower case.
[[nodiscard]] std::optional<bool> parse_boolean(std::string_view text);
/// Words separated by commas and white space; they point into the text.
[[nodiscard]] std::vector<std::string_view> split_list(std::string_view text);
/// Numbers separated by commas and white space.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(std::string_view text);
/// The three numbers of "#rrggbb", from 0 to 255.
[[nodiscard]] std::optional<std::array<int, 3>> parse_hex(std::string_view text);
/// The same, sRGB-encoded, as linear RGB.
[[nodiscard]] std::optional<Rgb> parse_hex_color(std::string_view text);
/// One sRGB-encoded component as linear light (IEC 61966-2-1).
[[nodiscard]] double linear_from_srgb(double encoded);

}  // namespace strahl
