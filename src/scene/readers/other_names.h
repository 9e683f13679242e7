// SPDX-License-Identifier: MIT
// Types of plugins as some scene files write them, in Mitsuba's names.
#pragma once

#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// Renames in the whole tree, where Mitsuba has no plugin of the type that is given:
/// - types that differ from a plugin's in capitals alone ("Rectangle");
/// - <bsdf type="mirror">, which becomes an ideal `conductor` with its `reflectance`;
/// - <bsdf type="glass">, which becomes `dielectric`, or `roughdielectric` where `alpha` is given.
void use_mitsuba_names(XmlElement& root, XmlPool& pool);

}  // namespace strahl
