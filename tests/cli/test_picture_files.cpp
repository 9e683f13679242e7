// SPDX-License-Identifier: MIT
// What writing a picture writes, by which its time is told: every file counts.
#include <catch2/catch.hpp>

#include "cli/picture_files.h"

namespace strahl::cli {
namespace {

TEST_CASE("a PNG or PFM has a file an AOV, an EXR file has channels") {
  const AovList plain{Aov::depth, Aov::normal, Aov::uv, Aov::shape_id, Aov::albedo};
  AovList named;
  for (const char* name : {"a", "b", "c", "d", "e"}) named.add(NamedAov{name, Aov::depth});
  for (const std::string path : {"out.png", "out.pfm"}) {
    INFO(path);
    CHECK(written_files(path, {}).files == 1);
    CHECK(written_files(path, plain).files == 6);
    CHECK(written_files(path, named).files == 1);
    CHECK(written_files(path, plain).channels == 3);
  }
  for (const AovList& aovs : {plain, named}) {
    CHECK(written_files("out.exr", aovs).files == 1);
    CHECK(written_files("out.exr", aovs).channels == 18);
  }
}

}  // namespace
}  // namespace strahl::cli
