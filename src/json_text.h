// SPDX-License-Identifier: MIT
// The one way in which JSON is written.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace strahl {

/// The value over several lines, two spaces a level, with a newline at its end. A file's name may hold any bytes: what
/// is not UTF-8 becomes U+FFFD, for an exception here would lose what was rendered.
template <class AnyJson>
[[nodiscard]] std::string json_text(const AnyJson& json) {
  return json.dump(2, ' ', false, AnyJson::error_handler_t::replace) + "\n";
}

}  // namespace strahl
