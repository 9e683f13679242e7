// SPDX-License-Identifier: MIT
// What writing a picture is expected to take counts every file that is written.
#include <algorithm>
#include <catch2/catch.hpp>

#include "cli/picture_files.h"

namespace strahl::cli {
namespace {

constexpr double pixels = 256 * 320;

/// The least of a few: whatever else runs only lengthens it.
double seconds(const std::string& path, const AovList& aovs) {
  double least = expected_write_seconds(path, {}, pixels, aovs);
  for (int i = 0; i < 20; ++i) least = std::min(least, expected_write_seconds(path, {}, pixels, aovs));
  return least;
}

TEST_CASE("a PNG or PFM has a file an AOV, an EXR file has channels") {
  const AovList plain{Aov::depth, Aov::normal, Aov::uv, Aov::shape_id, Aov::albedo};
  AovList named;
  for (const char* name : {"a", "b", "c", "d", "e"}) named.add(NamedAov{name, Aov::depth});
  for (const std::string path : {"out.png", "out.pfm"}) {
    INFO(path);
    const double alone = seconds(path, {});
    CHECK(seconds(path, plain) > 3 * alone);  // Six files.
    CHECK(seconds(path, named) < 3 * alone);  // No other file.
  }
  CHECK(seconds("out.exr", named) > 2 * seconds("out.exr", {}));
}

}  // namespace
}  // namespace strahl::cli
