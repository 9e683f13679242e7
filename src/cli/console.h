// SPDX-License-Identifier: MIT
// The two streams: results on standard output, everything said about them on standard error.
#pragma once

#include <string>

namespace strahl::cli {

/// Results. Throws Error where they cannot be written.
void print(const std::string& text);

/// One line on standard error. Never throws: a closed standard error must not cost a picture.
void say(const std::string& line) noexcept;

/// Opens what the caller left closed of the three standard streams, unwritable, so that no picture takes the number of
/// one of them and messages end up in it.
void reserve_standard_streams() noexcept;

}  // namespace strahl::cli
