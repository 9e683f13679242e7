// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "process_memory.h"

using namespace strahl;

TEST_CASE("Huge pages are asked for beside what GLIBC_TUNABLES says, unless it names them") {
  CHECK(tunables_with_huge_pages("") == "glibc.malloc.hugetlb=1");
  CHECK(tunables_with_huge_pages("glibc.malloc.check=1") == "glibc.malloc.check=1:glibc.malloc.hugetlb=1");
  for (const char* named : {"glibc.malloc.hugetlb=0", "glibc.malloc.check=1:glibc.malloc.hugetlb=2"})
    CHECK(tunables_with_huge_pages(named) == std::nullopt);
}

#ifdef __GLIBC__
/// Heaps of the C library, as it tells.
int heaps() {
  char* text = nullptr;
  std::size_t size = 0;
  FILE* file = open_memstream(&text, &size);
  malloc_info(0, file);
  std::fclose(file);
  const std::string told(text, size);
  std::free(text);
  int count = 0;
  for (std::size_t at = told.find("<heap nr="); at != std::string::npos; at = told.find("<heap nr=", at + 1)) ++count;
  return count;
}

TEST_CASE("Threads have no heaps of their own") {
  keep_freed_memory();
  const int before = heaps();
  std::vector<std::vector<char>> blocks(4);
  {
    std::vector<std::jthread> threads;
    for (std::vector<char>& block : blocks) threads.emplace_back([&block] { block.assign(100'000, 'x'); });
  }
  REQUIRE(before > 0);
  CHECK(heaps() == before);
}
#endif
