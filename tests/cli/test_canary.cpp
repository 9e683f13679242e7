// SPDX-License-Identifier: MIT
// Rendering on a device whose arithmetic is wrong: kernel sources in which contraction is left on.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

/// The kernels, with one text of one file replaced.
std::string changed_kernels(const Folder& folder, const char* file, const std::string& from, const std::string& to) {
  const fs::path copy = folder.path("cl");
  fs::copy(fs::path(STRAHL_SOURCE_DIR) / "cl", copy, fs::copy_options::recursive);
  std::string text = read_text((copy / file).string());
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  std::ofstream(copy / file) << text.replace(at, from.size(), to);
  return copy.string();
}

std::string kernels_with_contraction(const Folder& folder) {
  return changed_kernels(folder, "portable.h", "#pragma OPENCL FP_CONTRACT OFF", "#pragma OPENCL FP_CONTRACT ON");
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

TEST_CASE("tradeoff measures against nothing in a precision that the device cannot keep") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::map<std::string, std::string> changed{{"STRAHL_KERNEL_DIR", kernels_with_contraction(folder)}};
  const Outcome outcome = folder.run({"tradeoff", "scene.xml", "-d", "pocl", "--spp", "1,2", "--seeds", "2", "--width",
                                      "16", "--sampler", "independent", "--no-generic", "--json"},
                                     changed);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.err, "the reference is fast; robust is refused"));
  const auto study = nlohmann::json::parse(outcome.out);
  CHECK(study.at("reference").at("precision") == "fast");
  for (const auto& point : study.at("points")) CHECK(point.at("precision") == "fast");
}

TEST_CASE("a program that does not build ends with 5, the driver's words and the source") {
  const Folder folder;
  const std::string kernels =
      changed_kernels(folder, "kernels/render.cl", "KERNEL", "#error broken on purpose\nKERNEL");
  const Outcome outcome = folder.run(
      {"render", folder.file("scene.xml", glowing_sphere), "-d", "pocl", "--no-canary", "-q", "-o", "out.pfm"},
      {{"STRAHL_KERNEL_DIR", kernels}, {"STRAHL_CACHE_DIR", folder.path("cache")}});
  INFO(outcome.err);
  CHECK(outcome.code == 5);
  CHECK(contains(outcome.err, "broken on purpose"));
  CHECK_FALSE(fs::exists(folder.path("out.pfm")));
  const std::size_t at = outcome.err.find("source: ");
  REQUIRE(at != std::string::npos);
  const std::string source = outcome.err.substr(at + 8, outcome.err.find('\n', at) - at - 8);
  CHECK(contains(read_text(source), "#error broken on purpose"));
}
