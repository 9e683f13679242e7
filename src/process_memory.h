// SPDX-License-Identifier: MIT
// How a program of its own (strahl, strahl-bench) has its memory from the C library; a library leaves that to its host.
#pragma once

#include <optional>
#include <string>

namespace strahl {

/// Freed memory stays with the process, in one heap for all threads. To be called before there is another thread or
/// anything large is allocated.
void keep_freed_memory();

/// Begins the program anew, once, so that large blocks come in huge pages where the system gives them: that has to be
/// in the environment before the C library starts. To be called first, with main's argv; the process keeps its number
/// and its start time. Does nothing where GLIBC_TUNABLES decides about it already.
void begin_with_huge_pages(char** argv);

/// GLIBC_TUNABLES with huge pages; none where `present` names them already.
[[nodiscard]] std::optional<std::string> tunables_with_huge_pages(const std::string& present);

}  // namespace strahl
