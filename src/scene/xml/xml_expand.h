// SPDX-License-Identifier: MIT
// From a scene file to one tree: <default> and $name replaced, <include> spliced in, folders of <path> noted, 0.x names
// upgraded.
#pragma once

#include <map>
#include <string>

#include "scene/xml/diagnostics.h"
#include "scene/xml/search_path.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// Document order: a <default> holds from its place on, in included files too; the first one of a name wins, and
/// `defines` (-D) win over all. Folders of <path> are added to `search_path`, with which the files of <spectrum> are
/// found in the end. Null where the file cannot be read; errors are in `diagnostics`. The tree lies in `pool`.
[[nodiscard]] XmlElement* read_expanded_xml(const std::string& path, const std::map<std::string, std::string>& defines,
                                            SearchPath& search_path, XmlPool& pool, Diagnostics& diagnostics);

}  // namespace strahl
