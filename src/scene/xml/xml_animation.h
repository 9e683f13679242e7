// SPDX-License-Identifier: MIT
// <animation> of Mitsuba 0.x: a <transform> for each of several times.
#pragma once

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// Makes each <animation> below root the <transform> of its earliest time. Where a shutter closes later, motion would
/// show, which strahl does not render: a warning.
void hold_animations(XmlElement& root, Diagnostics& diagnostics);

}  // namespace strahl
