// SPDX-License-Identifier: MIT
// Colours of a scene file as linear RGB.
#pragma once

#include <optional>
#include <string>

#include "scene/model/vec.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// <rgb>, <srgb>, <spectrum>, <float>. A measured spectrum becomes its mean, a texture `substitute`, both with a
/// warning. None after an error: not a colour, not finite.
[[nodiscard]] std::optional<Rgb> read_color(const XmlElement& element, const Rgb& substitute, Diagnostics& diagnostics);

/// Within [0, 1], with a warning where it was not.
[[nodiscard]] Rgb clamped_reflectance(const Rgb& reflectance, const SourceLocation& where, std::string_view name,
                                      Diagnostics& diagnostics);

}  // namespace strahl
