// SPDX-License-Identifier: MIT
// Rays files that cannot be used: exit code 3, said with the row, before a device is looked for.
#include <catch2/catch.hpp>
#include <limits>

#include "cli/program.h"
#include "image/npy.h"

using namespace strahl_test;

namespace {

Outcome intersect(const Folder& folder, const std::string& rays) {
  folder.file("scene.xml", glowing_sphere);
  return folder.run({"intersect", "scene.xml", "--rays", rays, "-o", "hits.npy", "-d", "no-such-device"});
}

Outcome intersect(const Folder& folder, const strahl::Matrix& rays) {
  strahl::write_npy(rays, folder.path("rays.npy"));
  return intersect(folder, "rays.npy");
}

}  // namespace

TEST_CASE("rays that are in order get as far as the device") {
  const Folder folder;
  CHECK(intersect(folder, strahl::Matrix{1, 8, {0, 0, 5, 0, 0, -1, 0, 9}}).code == 4);
  CHECK(intersect(folder, strahl::Matrix{1, 11, {0, 0, 5, 0, 0, -1, 0, 9, -1, 0, 0}}).code == 4);
}

TEST_CASE("another number of columns is refused") {
  const Folder folder;
  const Outcome outcome = intersect(folder, strahl::Matrix{1, 6, {0, 0, 5, 0, 0, -1}});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "rays.npy: 6 columns"));
}

TEST_CASE("ids must be whole numbers from -1 on") {
  const Folder folder;
  for (const double id :
       {0.5, -2.0, 1e10, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t column : {8U, 9U, 10U}) {
      strahl::Matrix rays{2, 11, {0, 0, 5, 0, 0, -1, 0, 9, -1, -1, -1, 0, 0, 5, 0, 0, -1, 0, 9, -1, -1, -1}};
      rays.data[11 + column] = id;
      const Outcome outcome = intersect(folder, rays);
      CHECK(outcome.code == 3);
      CHECK(contains(outcome.err, "rays.npy: row 1: "));
    }
  }
}

TEST_CASE("what is no npy file is refused") {
  const Folder folder;
  CHECK(intersect(folder, folder.file("text.npy", "0 0 5 0 0 -1 0 9\n")).code == 3);
  CHECK(intersect(folder, "missing.npy").code == 3);
  CHECK_FALSE(std::filesystem::exists(folder.path("hits.npy")));
}
