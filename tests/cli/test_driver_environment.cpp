// SPDX-License-Identifier: MIT
// What the environment does to PoCL, which offers no device where it cannot make its cache: asked of `strahl devices`,
// which compiles nothing. And a driver that cannot be loaded, for want of memory or of its file.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const char* const pocl = "Portable Computing Language";

/// PoCL as `strahl devices --json` has it.
Json pocl_of(const Outcome& outcome) {
  const Json all = Json::parse(outcome.out);
  for (const Json& platform : all.at("platforms"))
    if (platform.at("name") == pocl) return platform;
  return nullptr;
}

std::string temporary_cache(const Folder& folder) {
  return folder.path("tmp/strahl-pocl-" + std::to_string(geteuid()));
}

/// Nothing of PoCL's own decides but what the test sets.
std::map<std::string, std::string> with(const Folder& folder, const std::map<std::string, std::string>& more) {
  fs::create_directories(folder.path("tmp"));
  std::map<std::string, std::string> all{
      {"POCL_CACHE_DIR", ""}, {"XDG_CACHE_HOME", ""}, {"TMPDIR", folder.path("tmp")}};
  for (const auto& [name, value] : more) all[name] = value;
  return all;
}

}  // namespace

TEST_CASE("PoCL has its device where the home cannot be written") {
  const Folder folder;
  const std::string file = folder.file("file", "");
  for (const std::map<std::string, std::string>& home : std::vector<std::map<std::string, std::string>>{
           {{"HOME", "/dev/null"}}, {{"XDG_CACHE_HOME", file}}, {{"HOME", "/proc"}}}) {
    INFO(home.begin()->first << "=" << home.begin()->second);
    const Outcome outcome = folder.run({"devices", "--json"}, with(folder, home));
    INFO(outcome.err);
    const Json pocl = pocl_of(outcome);
    REQUIRE_FALSE(pocl.is_null());
    CHECK(outcome.code == 0);
    CHECK(pocl.at("devices").size() == 1);
    CHECK(contains(pocl.at("note"), "cannot be written"));
    CHECK(contains(pocl.at("note"), temporary_cache(folder)));
    const fs::perms rights = fs::status(temporary_cache(folder)).permissions();
    CHECK((rights & (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none);
  }
}

TEST_CASE("a folder for the cache that somebody else could write is not taken, and why there is no device is said") {
  const Folder folder;
  const auto environment = with(folder, {{"HOME", "/dev/null"}});
  fs::create_directory(temporary_cache(folder));
  fs::permissions(temporary_cache(folder), fs::perms::all);
  const Json pocl = pocl_of(folder.run({"devices", "--json"}, environment));
  REQUIRE_FALSE(pocl.is_null());
  CHECK(contains(pocl.at("skipped"), "\"/dev/null/.cache/pocl/kcache\" cannot be written"));
  CHECK(contains(pocl.at("skipped"), "POCL_CACHE_DIR"));
}

TEST_CASE("a cache that is named and cannot be written is named in the reason") {
  const Folder folder;
  const Json pocl = pocl_of(folder.run({"devices", "--json"}, with(folder, {{"POCL_CACHE_DIR", "/proc/none"}})));
  REQUIRE_FALSE(pocl.is_null());
  CHECK(contains(pocl.at("skipped"), "its cache \"/proc/none\" (POCL_CACHE_DIR) cannot be written"));
}

TEST_CASE("a relative XDG_CACHE_HOME is ignored") {
  const Folder folder;
  const Outcome outcome =
      folder.run({"devices", "--json"}, with(folder, {{"XDG_CACHE_HOME", "rel"}, {"HOME", folder.path("home")}}));
  REQUIRE_FALSE(pocl_of(outcome).is_null());
  CHECK_FALSE(fs::exists(folder.path("rel")));
  CHECK(fs::exists(folder.path("home/.cache/pocl/kcache")));
}

TEST_CASE("a driver that cannot be loaded is named, with the linker's reason") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  fs::create_directory(folder.path("vendors"));
  folder.file("vendors/none.icd", "libno-such-driver.so.7\n");
  const Outcome outcome = folder.run({"scene.xml"}, {{"OCL_ICD_VENDORS", folder.path("vendors")}});
  CHECK(outcome.code == 4);
  CHECK(contains(outcome.err, "libno-such-driver.so.7 cannot be loaded: "));
  CHECK(contains(outcome.err, "No such file"));
}

#ifndef __SANITIZE_ADDRESS__  // Whose shadow is larger than the limit.
TEST_CASE("too little memory for a driver is out of memory, not a missing driver") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::string line = "cd " + folder.path("") + " && ulimit -v 150000 && " + STRAHL_PROGRAM +
                           " scene.xml -o x.png 2>said; test $? -eq 1";
  CHECK(std::system(line.c_str()) == 0);
  const std::string said = read_text(folder.path("said"));
  INFO(said);
  CHECK(contains(said, "strahl: error: out of memory: the OpenCL driver "));
  CHECK(contains(said, "ulimit -v"));
  CHECK_FALSE(contains(said, "install"));
}
#endif
