// SPDX-License-Identifier: MIT
// --memory-limit: the same picture from a film in bands, scenes that are too large refused with numbers.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;

namespace {

std::uint64_t device_bytes(const Folder& folder) {
  return nlohmann::json::parse(read_text(folder.path("stats.json"))).at("bytes").at("device");
}

}  // namespace

TEST_CASE("a film that does not fit goes in bands, and the picture is the same") {
  const Folder folder;
  folder.file("s.xml", glowing_sphere);
  const std::vector<std::string> options = {"s.xml",     "-q",    "-d",      "pocl",       "--spp", "16",
                                            "--sampler", "sobol", "--stats", "stats.json", "-o"};
  const auto render = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> all = options;
    all.push_back(name);
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(all);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
  };
  render("whole.pfm", {});
  const std::uint64_t whole = device_bytes(folder);
  REQUIRE(whole > 100'000);
  render("bands.pfm", {"--memory-limit", "48k"});
  CHECK(device_bytes(folder) <= 48 << 10);
  CHECK(strahl::read_image(folder.path("whole.pfm")).data == strahl::read_image(folder.path("bands.pfm")).data);
}

TEST_CASE("what cannot fit is refused with what it takes") {
  const Folder folder;
  folder.file("s.xml", glowing_sphere);
  const auto refused = [&](const std::string& scene, const std::string& limit, int code) {
    const Outcome outcome = folder.run({scene, "-q", "-d", "pocl", "--memory-limit", limit, "-o", "x.pfm"});
    CHECK(outcome.code == code);
    return outcome.err;
  };
  for (const char* limit : {"7k", "7KiB"})
    CHECK(contains(refused("s.xml", limit, 4), "a row of the picture takes 6 KiB beside the scene's"));
  const std::string mesh = STRAHL_SOURCE_DIR "/scenes/mesh/torus-and-icosphere.xml";
  for (const char* limit : {"20k", "90k"}) {
    const std::string said = refused(mesh, limit, 4);
    CHECK(contains(said, "by --memory-limit"));
    CHECK(contains(said, "hoose a larger --memory-limit"));  // No device has more by that.
    CHECK_FALSE(contains(said, "-d)"));
  }
  for (const char* wrong : {"0", "12x", "-1", "G", "99999999999G", "iB", "12MB", "12iB"})
    CHECK(contains(refused("s.xml", wrong, 2), "--memory-limit takes bytes"));
  CHECK(folder.files() == std::vector<std::string>{"s.xml"});
}

TEST_CASE("what is traced in double after the last sample must fit as well, which is said before the first") {
  const Folder folder;
  const auto render = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {STRAHL_SOURCE_DIR "/scenes/mesh/torus-and-icosphere.xml",
                                    "-q",
                                    "-d",
                                    "pocl",
                                    "--width",
                                    "32",
                                    "--spp",
                                    "1",
                                    "--memory-limit",
                                    "150k",
                                    "-o",
                                    "x.exr"};
    all.insert(all.end(), more.begin(), more.end());
    return folder.run(all);
  };
  CHECK(render({"--aov", "depth"}).code == 0);
  std::filesystem::remove(folder.path("x.exr"));
  const Outcome refused = render({"--aov", "numeric_error"});
  CHECK(refused.code == 4);
  CHECK(contains(refused.err, "has the scene in memory a second time, in double precision"));
  CHECK(contains(refused.err, "leave that AOV out, or choose a larger --memory-limit"));
  CHECK(folder.files().empty());
}
