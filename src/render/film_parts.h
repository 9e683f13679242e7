// SPDX-License-Identifier: MIT
// How threads share a film at the end of a picture.
#pragma once

#include <cstddef>
#include <vector>

#include "render/goal.h"

namespace strahl {

/// Parts of a film of so many rows, from the top down: whole bands of an ErrorLaw, each part so small that it stays in
/// a processor's cache, but not so flat that the row above, which is looked at as well, would count. As many for each
/// thread, and as high, as bands allow; one part where it is not worth a thread.
[[nodiscard]] std::vector<Rows> film_parts(int height, std::size_t row_bytes, unsigned threads);

/// Of this machine, as far as they help: more of them wait for the memory.
[[nodiscard]] unsigned film_threads();

}  // namespace strahl
