// SPDX-License-Identifier: MIT
// The lines of a kernel file as a preprocessor sees them: directives are looked for outside comments only.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace strahl {

struct KernelLine {
  std::string text;  ///< As written.
  std::string bare;  ///< Without comments and without space at either end.
};

/// The lines of a file. Comments in string literals are none, and a block comment may span lines.
[[nodiscard]] std::vector<KernelLine> kernel_lines(const std::string& text);

/// Name and first word of a directive: {"ifndef", "X"} of `#ifndef X`, {"if", ""} of `#if (X)`; empty for other lines.
[[nodiscard]] std::pair<std::string, std::string> directive(const std::string& bare);

/// The macro of an include guard (#ifndef, #define, ..., #endif around everything), empty where there is none.
[[nodiscard]] std::string include_guard(const std::vector<KernelLine>& lines);

/// "sphere.h" of `#include "sphere.h"`; empty for any other line.
[[nodiscard]] std::string included_path(const std::string& bare);

/// +1 for #if, #ifdef and #ifndef, -1 for #endif, else 0.
[[nodiscard]] int conditional_step(const std::string& bare);

}  // namespace strahl
