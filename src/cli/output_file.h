// SPDX-License-Identifier: MIT
// Files that are written: whether they can be, asked before the work whose result they hold; and text files.
#pragma once

#include <string>

namespace strahl::cli {

/// Throws Error, with the remedy, where `path` cannot be written.
void require_writable(const std::string& path);

/// "-": standard output. Else complete or absent.
void write_text(const std::string& path, const std::string& text);

}  // namespace strahl::cli
