// SPDX-License-Identifier: MIT
// What an OpenEXR header claims, looked at before the library believes it.
#pragma once

#include <string_view>

namespace strahl {

/// Throws std::runtime_error where an attribute is to be longer than the file, for which the library would make room
/// first, or has not the size of its type, after which the library would take its bytes for other attributes. Whatever
/// else is wrong with a header is left to the library. bytes: the whole file.
void require_attributes_fit(std::string_view bytes);

}  // namespace strahl
