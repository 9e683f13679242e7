// SPDX-License-Identifier: MIT
// `strahl devices` with no platform at all, and the cache of programs. (With devices: tests/device.)
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

/// The ICD loader finds no platform in an empty folder.
std::map<std::string, std::string> no_platform(const Folder& folder) {
  std::filesystem::create_directory(folder.path("vendors"));
  return {{"OCL_ICD_VENDORS", folder.path("vendors/")}};
}

}  // namespace

TEST_CASE("no device at all: exit code 4 and what to install") {
  const Folder folder;
  const Outcome text = folder.run({"devices"}, no_platform(folder));
  CHECK(text.code == 4);
  CHECK(contains(text.err, "strahl: error: "));
  CHECK(contains(text.err, "pocl-opencl-icd"));

  const Outcome json = folder.run({"devices", "--json"}, no_platform(folder));
  CHECK(json.code == 4);
  const Json list = Json::parse(json.out);
  CHECK(list.at("platforms").empty());
  CHECK(list.at("default").is_null());
}

TEST_CASE("a render without a device is exit code 4 and leaves no file") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  CHECK(folder.run({"scene.xml"}, no_platform(folder)).code == 4);
  CHECK(folder.files() == std::vector<std::string>{"scene.xml", "vendors"});
}

TEST_CASE("the cache is cleared without a device") {
  const Folder folder;
  auto environment = no_platform(folder);
  environment["STRAHL_CACHE_DIR"] = folder.path("cache");
  const Outcome json = folder.run({"devices", "--clear-cache", "--json"}, environment);
  CHECK(json.code == 0);
  CHECK(Json::parse(json.out).at("removed") == 0);
  CHECK(contains(folder.run({"devices", "--clear-cache"}, environment).out, "removed 0 cached programs"));
  environment["STRAHL_CACHE_DIR"] = folder.path("\xe4");  // ISO 8859-1
  const Outcome other = folder.run({"devices", "--clear-cache", "--json"}, environment);
  INFO(other.err);
  CHECK(other.code == 0);
  CHECK(contains(Json::parse(other.out).at("directory").get<std::string>(), "/\uFFFD"));
}
