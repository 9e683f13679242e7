// SPDX-License-Identifier: MIT
#include "scene/meshes/attribute_fault.h"

#include <fmt/format.h>

#include <algorithm>

namespace strahl {

bool is_finite(const MeshAttribute& attribute) {
  return std::ranges::all_of(attribute.values, [](const Rgb& value) { return is_finite(value); });
}

AttributeFault fault_of(const MeshAttribute& attribute, const char* at, const MeshSource& source) {
  return {attribute.name, source.error_at(at, fmt::format("{} is not made of finite numbers, and a texture shows it",
                                                          in_quotes(attribute.name)))};
}

}  // namespace strahl
