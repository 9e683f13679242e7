// SPDX-License-Identifier: MIT
// Ten million triangles from a PLY file: read, put into a tree and rendered within 8 GiB.
#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "bench/mesh_files.h"
#include "cli/program.h"

using namespace strahl_test;

TEST_CASE("a mesh of ten million triangles is rendered within 8 GiB") {
  const Folder folder;
  strahl::bench::write_mesh_file(folder.path("large.ply"), "ply-normals", 10'000'000);
  for (const char* precision : {"robust", "double"}) {
    INFO(precision);
    const Outcome outcome = folder.run({"render", "large.ply", "-d", "pocl", "--precision", precision, "--width", "256",
                                        "--height", "256", "--spp", "1", "--pixel", "128,128", "-o", "large.png"});
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.size() > 2);
    CHECK(outcome.out != "0 0 0\n");
  }
  rusage children{};
  REQUIRE(getrusage(RUSAGE_CHILDREN, &children) == 0);
  CHECK(children.ru_maxrss < 8L << 20);  // kibibytes
}
