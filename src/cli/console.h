// SPDX-License-Identifier: MIT
// The two streams: results on standard output, everything said about them on standard error.
#pragma once

#include <string>

namespace strahl::cli {

/// Results. Throws Error where they cannot be written.
void print(const std::string& text);

/// One line on standard error. Never throws: a closed standard error must not cost a picture.
void say(const std::string& line) noexcept;

/// A line on a terminal's standard error that the next one, and whatever is said or printed, takes the place of; empty:
/// wipes it. From any thread.
void show_line(const std::string& line) noexcept;

/// Opens what the caller left closed of the three standard streams, unwritable, so that no picture takes the number of
/// one of them and messages end up in it.
void reserve_standard_streams() noexcept;

}  // namespace strahl::cli
