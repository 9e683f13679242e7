// SPDX-License-Identifier: MIT
// `strahl intersect` on a device: NumPy in, NumPy out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/npy.h"

using namespace strahl_test;
using strahl::Matrix;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// Traces rows of 8 or 11 against the unit sphere around the origin.
Matrix trace(const Folder& folder, std::size_t columns, std::vector<double> rays,
             const std::vector<std::string>& more = {}) {
  folder.file("scene.xml", glowing_sphere);
  const std::size_t rows = rays.size() / columns;
  strahl::write_npy(Matrix{rows, columns, std::move(rays)}, folder.path("rays.npy"));
  std::vector<std::string> arguments{"intersect", "scene.xml", "--rays", "rays.npy", "-o", "hits.npy", "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  Matrix hits = strahl::read_npy(folder.path("hits.npy"));
  REQUIRE(hits.rows == rows);
  REQUIRE(hits.columns == 9);
  return hits;
}

std::vector<double> row(const Matrix& matrix, std::size_t index) {
  const auto first = matrix.data.begin() + static_cast<std::ptrdiff_t>(index * matrix.columns);
  return {first, first + static_cast<std::ptrdiff_t>(matrix.columns)};
}

const std::vector<double> miss{inf, -1, -1, -1, 0, 0, 0, 0, 0};

}  // namespace

TEST_CASE("hits and misses; t counts in units of the direction, both ends included") {
  const Folder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Matrix hits = trace(folder, 8, {0, 0, 5, 0, 0, -1, 0,   inf,  // The near side.
                                        0, 0, 5, 0, 0, -2, 0,   2,    // t = 2 counts.
                                        0, 0, 5, 0, 0, -1, 4.5, inf,  // Past the near side: the far one.
                                        0, 0, 5, 0, 0, 1,  0,   inf,  // Away.
                                        0, 0, 5, 0, 0, -1, 0,   3.5,  // Too short.
                                        0, 0, 5, 0, 0, -1, nan, inf});
  CHECK(hits.data[0] == 4);
  CHECK(hits.data[1] == -1);
  CHECK(hits.data[2] == 0);
  CHECK(hits.data[3] == 0);
  CHECK(std::vector<double>(hits.data.begin() + 6, hits.data.begin() + 9) == std::vector<double>{0, 0, 1});
  CHECK(row(hits, 1)[0] == 2);
  CHECK(row(hits, 2)[0] == 6);
  CHECK(row(hits, 2)[8] == -1);
  for (const std::size_t missed : {3U, 4U, 5U}) CHECK(row(hits, missed) == miss);
}

TEST_CASE("the primitive just left is not hit where the ray leaves it") {
  const Folder folder;
  const Matrix hits = trace(folder, 11, {0, 0, 1, 0, 0, 1,  0, inf, -1, 0, 0,    // Outwards.
                                         0, 0, 1, 0, 0, -1, 0, inf, -1, 0, 0});  // Through: the other root.
  CHECK(row(hits, 0) == miss);
  CHECK(row(hits, 1)[0] == 2);
}

TEST_CASE("--any-hit tells whether, not where") {
  const Folder folder;
  const Matrix hits = trace(folder, 8, {0, 0, 5, 0, 0, -1, 0, inf, 0, 0, 5, 0, 0, 1, 0, inf}, {"--any-hit"});
  CHECK(row(hits, 0) == std::vector<double>{0, -1, -1, -1, 0, 0, 0, 0, 0});
  CHECK(row(hits, 1) == miss);
}

TEST_CASE("--coherent, --lanes and --repeat do not change the hits; --repeat is listed") {
  const Folder folder;
  std::vector<double> rays;
  for (int i = 0; i < 100; ++i) rays.insert(rays.end(), {0.013 * i, 0.002 * i, 5, 0.001 * i, 0, -1, 0, inf});
  const Matrix first = trace(folder, 8, rays);
  for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
           {"--coherent"}, {"--lanes", "1"}, {"--lanes", "16"}, {"--repeat", "5", "--stats", "stats.json"}})
    CHECK(trace(folder, 8, rays, how).data == first.data);
  const auto stats = nlohmann::json::parse(read_text(folder.path("stats.json")));
  CHECK(stats.at("kernel_runs").size() == 5);
  auto runs = stats.at("kernel_runs").get<std::vector<double>>();
  std::sort(runs.begin(), runs.end());
  CHECK(stats.at("seconds").at("kernel").get<double>() == Approx(runs[2]));
}

TEST_CASE("the device's bytes are those of the scene and of the largest launch's rays and hits") {
  const Folder folder;
  const auto bytes = [&](std::size_t rays, const std::vector<std::string>& more) {
    std::vector<double> rows;
    for (std::size_t i = 0; i < rays; ++i) rows.insert(rows.end(), {0, 0, 5, 0, 0, -1, 0, inf});
    std::vector<std::string> words{"--stats", "stats.json"};
    words.insert(words.end(), more.begin(), more.end());
    if (std::find(more.begin(), more.end(), "--lanes") == more.end()) words.insert(words.end(), {"--lanes", "1"});
    static_cast<void>(trace(folder, 8, rows, words));
    return nlohmann::json::parse(read_text(folder.path("stats.json"))).at("bytes").at("device").get<std::uint64_t>();
  };
  // A ray: eight floats, the primitive and instance left; t, then the hit's kind and ids; with its surface twice that.
  const std::uint64_t one = bytes(1, {}), thousand = bytes(1001, {}), any = bytes(1001, {"--any-hit"});
  CHECK((thousand - one) % 1000 == 0);
  CHECK(thousand - one > 1000 * 16 * 4);
  CHECK(any < thousand);
  CHECK(any > 1000 * 10 * 4);
  // Rays and hits stand in blocks of as many as there are lanes.
  CHECK(bytes(1, {"--lanes", "8"}) == bytes(8, {"--lanes", "8"}));
  // Launches take turns with the same memory.
  CHECK(bytes((1 << 18) + 1, {"--any-hit"}) == bytes(1 << 18, {"--any-hit"}));
}

TEST_CASE("no rays give no hits") {
  const Folder folder;
  CHECK(trace(folder, 8, {}).data.empty());
}

TEST_CASE("a shape that does not exist is unusable input") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  for (const std::vector<double>& left :
       std::vector<std::vector<double>>{{-1, 1, 0}, {-1, 0, 1}, {0, 0, 0}, {-1, -1, 0}, {0, -1, -1}}) {
    Matrix rays{1, 11, {0, 0, 5, 0, 0, -1, 0, inf}};
    rays.data.insert(rays.data.end(), left.begin(), left.end());
    strahl::write_npy(rays, folder.path("rays.npy"));
    CHECK(folder.run({"intersect", "scene.xml", "--rays", "rays.npy", "-o", "hits.npy"}).code == 3);
  }
}

TEST_CASE("double precision, where the device has it") {
  const Folder folder;
  const Matrix hits = trace(folder, 8, {0.1, 0.2, 5, 0, 0, -1, 0, inf}, {"--precision", "double"});
  CHECK(hits.data[0] == Approx(5 - std::sqrt(1 - 0.05)).epsilon(1e-15));
}
