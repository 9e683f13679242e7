// SPDX-License-Identifier: MIT
// Colours of a scene file as linear RGB.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/model/vec.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

struct SpectrumCurve;

/// What a colour is for: it decides what values are possible, and how a spectrum becomes one.
enum class ColorUse {
  reflectance,  ///< A share of the light, within [0, 1].
  unclamped,    ///< A part of a reflectance, which is clamped as a whole: of any sign.
  emission,     ///< Not negative.
  value,        ///< Of refraction or roughness: not negative.
  height        ///< Of a texture alone: of any sign.
};

/// <rgb>, <srgb>, <spectrum>, <blackbody>, <float>; of a texture `substitute`, with a warning. None after an error: not
/// a colour, not finite.
[[nodiscard]] std::optional<Rgb> read_color(const XmlElement& element, ColorUse use, const Rgb& substitute,
                                            Diagnostics& diagnostics);

/// What the curve looks like; a reflectance within [0, 1], whatever the gamut of sRGB makes of it.
[[nodiscard]] Rgb color_of_curve(const SpectrumCurve& curve, ColorUse use);

/// Within [0, 1], with a warning where it was not.
[[nodiscard]] Rgb clamped_reflectance(const Rgb& reflectance, const SourceLocation& where, std::string_view name,
                                      Diagnostics& diagnostics);

}  // namespace strahl
