// SPDX-License-Identifier: MIT
// One XML file as a tree of elements that know their line and column.
#pragma once

#include <string>

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// The root element, which lies in `pool`. Null after an error, which is then in `diagnostics`: unreadable file,
/// malformed XML, elements nested deeper than 64. `referrer` is the place that asks for the file (for the message; may
/// be unknown).
[[nodiscard]] XmlElement* read_xml_file(const std::string& path, const SourceLocation& referrer, XmlPool& pool,
                                        Diagnostics& diagnostics);

}  // namespace strahl
