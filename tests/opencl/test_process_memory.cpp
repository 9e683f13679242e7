// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "process_memory.h"

using namespace strahl;

TEST_CASE("Huge pages are asked for beside what GLIBC_TUNABLES says, unless it names them") {
  CHECK(tunables_with_huge_pages("") == "glibc.malloc.hugetlb=1");
  CHECK(tunables_with_huge_pages("glibc.malloc.check=1") == "glibc.malloc.check=1:glibc.malloc.hugetlb=1");
  for (const char* named : {"glibc.malloc.hugetlb=0", "glibc.malloc.check=1:glibc.malloc.hugetlb=2"})
    CHECK(tunables_with_huge_pages(named) == std::nullopt);
}
