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

/// The same text in UTF-8, so that JSON gives it back as it is and different ones stay different: where some bytes are
/// not UTF-8, or it could be taken for such a text, all beyond ASCII are written as \xe4, and a backslash as \x5c.
[[nodiscard]] inline std::string utf8_text(const std::string& text) {
  const nlohmann::json json(text);
  if (text.find("\\x") == std::string::npos &&
      nlohmann::json::parse(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) == json)
    return text;
  constexpr const char* digits = "0123456789abcdef";
  std::string escaped;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80 && letter != '\\')
      escaped += letter;
    else
      escaped += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
  }
  return escaped;
}

}  // namespace strahl
