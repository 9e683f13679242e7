// SPDX-License-Identifier: MIT
// The elements of the scene language and the attributes that each may and must have.
#pragma once

#include <string_view>

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// Reports unknown elements and attributes and missing attributes in the whole tree, and removes the elements that
/// cannot be used, so that readers meet only well-formed ones. False where the root is no <scene>.
[[nodiscard]] bool check_vocabulary(XmlElement& root, Diagnostics& diagnostics);

/// Reports unknown attributes of <default>, <include> and <path>, which give way to what they say before that.
void check_expanded(const XmlElement& element, Diagnostics& diagnostics);

/// True for elements that stand for a plugin or a set of properties ("shape"), false for values ("float").
[[nodiscard]] bool is_object_tag(std::string_view tag);

}  // namespace strahl
