// SPDX-License-Identifier: MIT
// libpng's errors as C++ exceptions. libpng offers setjmp, which must not skip a destructor, or an error function that
// does not return; throwing from it unwinds libpng's frames, which Debian's compilers give unwind tables, and every
// object on the way is destroyed. tests/image/test_png.cpp has truncated and damaged files of every kind.
#pragma once

#include <png.h>

#include <stdexcept>

namespace strahl {

[[noreturn]] inline void throw_png_error(png_structp, png_const_charp message) { throw std::runtime_error(message); }

/// libpng's warnings concern chunks that strahl does not use (colour profiles, dates, ...).
inline void ignore_png_warning(png_structp, png_const_charp) {}

}  // namespace strahl
