// SPDX-License-Identifier: MIT
// <spectrum type="..."> (or <texture type="...">) of what is the same everywhere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/xml/color_value.h"
#include "scene/xml/xml_element.h"

namespace strahl {

class Properties;

/// uniform, d65, srgb, rawconstant, regular, irregular, blackbody.
[[nodiscard]] bool is_typed_spectrum(const XmlElement& element);

/// Those types, as a suggestion for a misspelt one.
[[nodiscard]] std::vector<std::string> spectrum_types();

/// Its colour; none after an error. Reports parameters that it does not know.
[[nodiscard]] std::optional<Rgb> read_typed_spectrum(Properties& properties, ColorUse use);

}  // namespace strahl
