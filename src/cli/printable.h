// SPDX-License-Identifier: MIT
// Names come from files of unknown people; a terminal obeys what is in them.
#pragma once

#include <string>

namespace strahl::cli {

/// The text with every control character but newline and tab, C1 and DEL included, as "\x1b".
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace strahl::cli
