// SPDX-License-Identifier: MIT
// Work that is shared by threads of the host.
#pragma once

#include <cstddef>
#include <functional>

namespace strahl {

/// Of this machine; 1 where it is not known.
[[nodiscard]] unsigned hardware_threads();

/// use(i) for each i below `count`, in any order, on up to so many threads, of which the calling one is one; on fewer
/// where no other can be begun. Returns, or throws what the first failed use threw, once none is under way: those not
/// begun by then are left out.
void on_threads(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& use);

}  // namespace strahl
