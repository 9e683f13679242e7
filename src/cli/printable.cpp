// SPDX-License-Identifier: MIT
#include "cli/printable.h"

#include <fmt/format.h>

namespace strahl::cli {

std::string printable(const std::string& text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto after = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const bool is_control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f;
    if (byte == 0xc2 && after >= 0x80 && after < 0xa0) {  // U+0080 to U+009F in UTF-8.
      safe += fmt::format("\\x{:02x}", after);
      ++i;
    } else if (is_control) {
      safe += fmt::format("\\x{:02x}", byte);
    } else {
      safe += text[i];
    }
  }
  return safe;
}

}  // namespace strahl::cli
