// SPDX-License-Identifier: MIT
// Rendering on a device whose arithmetic is wrong: kernel sources in which contraction is left on.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

/// The kernels, changed.
std::string kernels_with_contraction(const Folder& folder) {
  const fs::path copy = folder.path("cl");
  fs::copy(fs::path(STRAHL_SOURCE_DIR) / "cl", copy, fs::copy_options::recursive);
  std::string text = read_text((copy / "portable.h").string());
  const std::string pragma = "#pragma OPENCL FP_CONTRACT OFF";
  const std::size_t at = text.find(pragma);
  REQUIRE(at != std::string::npos);
  std::ofstream(copy / "portable.h") << text.replace(at, pragma.size(), "#pragma OPENCL FP_CONTRACT ON");
  return copy.string();
}

}  // namespace

TEST_CASE("a precision that the device cannot keep is refused by name, and replaced by default") {
  const Folder folder;
  const std::string scene = folder.file("scene.xml", glowing_sphere);
  const std::map<std::string, std::string> changed{{"STRAHL_KERNEL_DIR", kernels_with_contraction(folder)}};
  const std::vector<std::string> render{"render", scene, "-d", "pocl", "-o", folder.path("out.pfm"), "--stats", "-"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), render.begin(), render.end());
    return more;
  };

  const Outcome named = folder.run(with({"--precision", "robust"}), changed);
  CHECK(named.code == 4);
  CHECK(contains(named.err, "precision robust"));
  CHECK(contains(named.err, "contracted"));
  CHECK(contains(named.err, "--no-canary"));
  CHECK_FALSE(fs::exists(folder.path("out.pfm")));

  const Outcome by_default = folder.run(render, changed);
  CHECK(by_default.code == 0);
  CHECK(contains(by_default.err, "warning: --precision fast"));
  const auto stats = nlohmann::json::parse(by_default.out);
  CHECK(stats.at("precision") == "fast");
  CHECK(stats.at("canary").at("verdict") == "holds");
  CHECK(contains(stats.at("canary").at("instead"), "robust is refused"));

  const Outcome trusted = folder.run(with({"--precision", "robust", "--no-canary"}), changed);
  CHECK(trusted.code == 0);
  CHECK(nlohmann::json::parse(trusted.out).at("canary").is_null());

  const Outcome sound = folder.run(with({"-q"}));
  CHECK(sound.code == 0);
  CHECK(sound.err.empty());
  CHECK(nlohmann::json::parse(sound.out).at("precision") == "robust");
}
