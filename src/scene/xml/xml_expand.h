// SPDX-License-Identifier: MIT
// From a scene file to one tree: <default> and $name replaced, <include> spliced in, 0.x names upgraded.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// Document order: a <default> holds from its place on, in included files too; the first one of a name wins, and
/// `defines` (-D) win over all. Null where the file cannot be read; errors are in `diagnostics`. The tree lies in
/// `pool`.
[[nodiscard]] XmlElement* read_expanded_xml(const std::string& path, const std::map<std::string, std::string>& defines,
                                            XmlPool& pool, Diagnostics& diagnostics);

/// `name` beside the file that asks for it, else beside the main scene file; absolute paths stay.
[[nodiscard]] std::string resolve_path(std::string_view name, const std::string& asking_file,
                                       const std::string& main_file);

}  // namespace strahl
