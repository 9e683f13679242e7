// SPDX-License-Identifier: MIT
// The folder that a load may read below is its own, whatever other threads load, and comes back after a load within it.
#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <thread>

#include "errors.h"
#include "image/confined_reads.h"
#include "image/temporary_folder.h"
#include "scene/loader.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// Two folders with a file each.
struct Folders {
  TemporaryFolder all;
  std::string a = all / "a", b = all / "b", in_a = a + "/x", in_b = b + "/x";
  Folders() {
    for (const std::string& folder : {a, b}) {
      std::filesystem::create_directory(folder);
      put_bytes(folder + "/x", "x");
    }
  }
};

bool is_refused(const std::string& path) { return !outside_because(path).empty(); }

}  // namespace

TEST_CASE("another thread's load neither opens nor moves a root") {
  const Folders folders;
  const ConfinedReads confined(folders.a);
  CHECK(is_refused(folders.in_b));
  std::thread([&] {
    CHECK_FALSE(is_refused(folders.in_b));
    const ConfinedReads elsewhere(folders.b);
    CHECK(is_refused(folders.in_a));
    CHECK_FALSE(is_refused(folders.in_b));
  }).join();
  CHECK(is_refused(folders.in_b));
  CHECK_FALSE(is_refused(folders.in_a));
}

TEST_CASE("a load within a load leaves the outer one's root as it was") {
  const Folders folders;
  const ConfinedReads confined(folders.a);
  {
    const ConfinedReads inner(folders.b);
    CHECK(is_refused(folders.in_a));
  }
  CHECK(is_refused(folders.in_b));
  CHECK_FALSE(is_refused(folders.in_a));
}

TEST_CASE("a root that is no folder is the caller's error") {
  const Folders folders;
  LoadOptions options;
  for (const std::string& root : {folders.all / "none", folders.in_a}) {
    options.root = root;
    CHECK_THROWS_AS(load_scene(folders.in_a, options), UsageError);
  }
}

TEST_CASE("what is open and has no name is not read") {
  const Folders folders;
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const int removed = ::open(folders.in_a.c_str(), O_RDONLY);
  REQUIRE(removed >= 0);
  std::filesystem::remove(folders.in_a);
  const ConfinedReads confined(folders.a);
  for (const int open : {ends[0], removed}) CHECK(is_refused("/dev/fd/" + std::to_string(open)));
  CHECK_FALSE(is_refused(folders.in_a));  // It is not there: its own message says so.
  for (const int open : {ends[0], ends[1], removed}) ::close(open);
}
