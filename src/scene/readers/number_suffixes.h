// SPDX-License-Identifier: MIT
// Numbers as programs in C write them, "0.5f", which early versions of Mitsuba 2 read.
#pragma once

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// Takes the f from behind each number of the tree's attributes, with a warning: Mitsuba 3.9 refuses it. Names, types
/// and texts stay as they are.
void drop_number_suffixes(XmlElement& root, XmlPool& pool, Diagnostics& diagnostics);

}  // namespace strahl
