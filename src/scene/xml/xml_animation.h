// SPDX-License-Identifier: MIT
// <animation> of Mitsuba 0.x: a <transform> for each of several times.
#pragma once

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// Each <animation> below root becomes the <transform> of its latest time at which the shutter is not yet open, else
/// the earliest. Where the shutter sees another pose, there is a warning: strahl renders no motion. For a checked tree.
void freeze_animations(XmlElement& root, Diagnostics& diagnostics);

}  // namespace strahl
