// SPDX-License-Identifier: MIT
#include "process_memory.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/auxv.h>
#include <unistd.h>
#endif

namespace strahl {

/// What one step of a run gives back the next one asks for: it need not be mapped and cleared again, which took a
/// quarter of the time of a large scene. Blocks of 256 MiB and more go back: a grid of 512 MiB would be held beside its
/// file. All threads have one arena: in those of their own, aligned blocks that PoCL's workers ask for and free in each
/// launch grow by a megabyte a minute (glibc's bug 30723, docs/reliability.md).
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 1 << 26);
  mallopt(M_ARENA_MAX, 1);
#endif
}

std::optional<std::string> tunables_with_huge_pages(const std::string& present) {
  if (present.find("glibc.malloc.hugetlb") != std::string::npos) return std::nullopt;
  return present + (present.empty() ? "" : ":") + "glibc.malloc.hugetlb=1";
}

/// A page's first touch costs a virtual machine so much that a picture of 1024 x 1024 waited longer for its film than
/// for its rays: docs/performance.md.
void begin_with_huge_pages(char** argv) {
#ifdef __GLIBC__
  if (getauxval(AT_SECURE) != 0) return;  // There the variable would not arrive.
  const char* present = getenv("GLIBC_TUNABLES");
  const std::optional<std::string> tunables = tunables_with_huge_pages(present == nullptr ? "" : present);
  if (!tunables || setenv("GLIBC_TUNABLES", tunables->c_str(), 1) != 0) return;
  execv("/proc/self/exe", argv);  // Comes back only where there is no such file: then pages are what they are.
#else
  static_cast<void>(argv);
#endif
}

}  // namespace strahl
