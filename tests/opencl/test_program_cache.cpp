// SPDX-License-Identifier: MIT
// The files of the program cache: whole or not there, nobody else's, not too many.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "opencl/own_cache.h"
#include "opencl/program.h"
#include "opencl/program_cache.h"

using namespace strahl;
using Catch::Contains;
using strahl::test::OwnCache;
namespace fs = std::filesystem;

TEST_CASE("Writers and readers of one cache file never meet a half of it") {
  const OwnCache cache;
  const std::vector<unsigned char> binary(200000, 7);
  const auto write_often = [&binary] {
    for (int i = 0; i < 50; ++i) write_cached_binary("name", "key", binary);
  };
  write_often();
  std::thread first(write_often);
  std::thread second(write_often);
  int broken = 0;
  for (int i = 0; i < 200; ++i) broken += read_cached_binary("name", "key") != binary;
  first.join();
  second.join();
  CHECK(broken == 0);
  CHECK(cache.files().size() == 1);
}

TEST_CASE("Entries of others, and what is no file, do not count and are replaced") {
  const OwnCache cache;
  const std::vector<unsigned char> binary(1000, 7);
  REQUIRE(write_cached_binary("name", "key", binary));
  const fs::path file = cache.files().at(0);
  REQUIRE(read_cached_binary("name", "key") == binary);
  const fs::path elsewhere = cache.directory() / "elsewhere";
  fs::rename(file, elsewhere);
  fs::create_symlink(elsewhere, file);
  CHECK(read_cached_binary("name", "key").empty());
  write_cached_binary("name", "key", binary);
  CHECK(read_cached_binary("name", "key") == binary);
  CHECK_FALSE(fs::is_symlink(file));
  if (geteuid() != 0) return;  // Only root can give files away.
  REQUIRE(chown(file.c_str(), 65534, 65534) == 0);
  CHECK(read_cached_binary("name", "key").empty());
  write_cached_binary("name", "key", binary);
  CHECK(read_cached_binary("name", "key") == binary);
}

TEST_CASE("A cache that others can write to is not used, and it is said") {
  const OwnCache cache;
  CHECK(program_cache_fault().empty());
  for (const fs::perms others : {fs::perms::others_write, fs::perms::group_write}) {
    fs::permissions(cache.directory(), fs::perms::owner_all | others);
    CHECK_THAT(program_cache_fault(), Contains("others can write to it") && Contains("chmod go-w"));
    CHECK(program_cache_directory().empty());
    write_cached_binary("name", "key", {1, 2, 3});
    CHECK(cache.files().empty());
  }
  fs::permissions(cache.directory(), fs::perms::owner_all);
  write_cached_binary("name", "key", {1, 2, 3});
  CHECK(read_cached_binary("name", "key").size() == 3);
  fs::permissions(cache.directory(), fs::perms::owner_all | fs::perms::others_write);
  CHECK(read_cached_binary("name", "key").empty());
  // One that is made here is nobody else's, whatever the umask.
  setenv("STRAHL_CACHE_DIR", (cache.directory() / "new" / "cache").c_str(), 1);
  const mode_t mask = umask(0);
  write_cached_binary("name", "key", {1, 2, 3});
  umask(mask);
  CHECK(program_cache_fault().empty());
  CHECK(read_cached_binary("name", "key").size() == 3);
}

TEST_CASE("strahl's own folder in the user's cache is closed to others, one that the user named is left as it is") {
  const OwnCache cache;
  const fs::path own = cache.directory() / "strahl";
  const auto mode_of = [](const fs::path& path) { return fs::status(path).permissions() & fs::perms::all; };
  const char* const before = std::getenv("XDG_CACHE_HOME");
  const std::string cache_home = before != nullptr ? before : "";
  setenv("XDG_CACHE_HOME", cache.directory().c_str(), 1);
  unsetenv("STRAHL_CACHE_DIR");
  // As mkdir makes it under the umask 002.
  fs::create_directory(own);
  fs::permissions(own, fs::perms(0775));
  CHECK(program_cache_fault().empty());
  CHECK(mode_of(own) == fs::perms(0755));
  write_cached_binary("name", "key", {1, 2, 3});
  CHECK(read_cached_binary("name", "key").size() == 3);
  // Where a program that does not build is kept.
  fs::remove_all(own);
  const mode_t mask = umask(2);
  CHECK(keep_failed_program("name", "text") == own / "name.failed.cl");
  umask(mask);
  CHECK(mode_of(own) == fs::perms(0700));
  // A link may lead anywhere.
  fs::remove_all(own);
  fs::create_directory(cache.directory() / "elsewhere");
  fs::permissions(cache.directory() / "elsewhere", fs::perms(0775));
  fs::create_directory_symlink("elsewhere", own);
  CHECK_THAT(program_cache_fault(), Contains("others can write to it"));
  CHECK(mode_of(cache.directory() / "elsewhere") == fs::perms(0775));
  setenv("STRAHL_CACHE_DIR", (cache.directory() / "elsewhere").c_str(), 1);
  CHECK_THAT(program_cache_fault(), Contains("others can write to it"));
  CHECK(mode_of(cache.directory() / "elsewhere") == fs::perms(0775));
  if (before != nullptr)
    setenv("XDG_CACHE_HOME", cache_home.c_str(), 1);
  else
    unsetenv("XDG_CACHE_HOME");
}

TEST_CASE("The source of a program that does not build is kept, through no link, or it is said why not") {
  const OwnCache cache;
  const auto text_of = [](const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const fs::path dumped = cache.directory() / "name.failed.cl", other = cache.directory() / "other";
  for (const std::string text : {"first and longer", "second"}) {
    CHECK(keep_failed_program("name", text) == dumped);
    CHECK(text_of(dumped) == text);
  }
  std::ofstream(other) << "kept";
  fs::remove(dumped);
  fs::create_symlink(other, dumped);
  CHECK_THAT(keep_failed_program("name", "text"), Contains("could not be written to"));
  CHECK(text_of(other) == "kept");

  // Without a cache it is the directory for temporary files, in which others write too.
  const char* const before = std::getenv("TMPDIR");
  const std::string temporary = before != nullptr ? before : "";
  setenv("STRAHL_CACHE_DIR", "/dev/null/none", 1);
  setenv("TMPDIR", cache.directory().c_str(), 1);
  const std::string first = keep_failed_program("name", "text"), second = keep_failed_program("name", "text");
  CHECK(first != second);
  for (const std::string& path : {first, second}) {
    CHECK(path.starts_with((cache.directory() / "name-").string()));
    CHECK(path.ends_with(".failed.cl"));
    CHECK(text_of(path) == "text");
  }
  setenv("TMPDIR", "/dev/null/none", 1);
  CHECK_THAT(keep_failed_program("name", "text"), Contains("TMPDIR"));
  if (before != nullptr)
    setenv("TMPDIR", temporary.c_str(), 1);
  else
    unsetenv("TMPDIR");
}

TEST_CASE("Beyond its limit the cache forgets what was used longest ago") {
  const OwnCache cache;
  setenv("STRAHL_CACHE_MIB", "1", 1);
  const std::vector<unsigned char> binary(300000, 7);
  const auto age = [&](const std::string& name, int hours) {
    for (const fs::path& file : cache.files())
      if (file.filename().string().starts_with(name))
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  const auto has = [&](const std::string& name) {
    const std::vector<fs::path> files = cache.files();
    return std::any_of(files.begin(), files.end(),
                       [&](const fs::path& file) { return file.filename().string().starts_with(name); });
  };
  for (const char* name : {"a", "b", "c"}) write_cached_binary(name, "key", binary);
  age("a", 3);
  age("b", 2);
  age("c", 1);
  REQUIRE(read_cached_binary("a", "key") == binary);  // Used again.
  std::ofstream(cache.directory() / "notes.txt") << std::string(2 << 20, 'x');
  write_cached_binary("d", "key", binary);
  CHECK(has("a"));
  CHECK_FALSE(has("b"));
  CHECK(has("c"));
  CHECK(has("d"));
  CHECK(has("notes.txt"));
  // One that is larger than all stays by itself.
  write_cached_binary("e", "key", std::vector<unsigned char>(3 << 20, 1));
  CHECK(has("e"));
  CHECK_FALSE(has("a"));
  unsetenv("STRAHL_CACHE_MIB");
}

TEST_CASE("A limit of the cache that is no whole number of MiB is told") {
  for (const char* wrong : {"4G", "1.5", "x", "1e3", "-1", " 8", "99999999999999999999999"}) {
    setenv("STRAHL_CACHE_MIB", wrong, 1);
    CHECK_THAT(program_cache_size_fault(),
               Contains("STRAHL_CACHE_MIB is \"" + std::string(wrong) + "\"") && Contains("holds 512 MiB"));
  }
  for (const char* right : {"", "0", "1", "4096", "18446744073709551615"}) {
    setenv("STRAHL_CACHE_MIB", right, 1);
    CHECK(program_cache_size_fault().empty());
  }
  unsetenv("STRAHL_CACHE_MIB");
  CHECK(program_cache_size_fault().empty());
}

TEST_CASE("A hundred processes share a cache that is too small for them") {
  const OwnCache cache;
  setenv("STRAHL_CACHE_MIB", "1", 1);
  std::vector<pid_t> children;
  for (int i = 0; i < 100; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      int wrong = 0;
      for (int turn = 0; turn < 10; ++turn) {
        const auto number = static_cast<unsigned char>((i + turn) % 10);
        const std::string name = "name" + std::to_string(number);
        const std::vector<unsigned char> binary(200000, number);
        const std::vector<unsigned char> found = read_cached_binary(name, "key");
        if (!found.empty() && found != binary) ++wrong;
        if (found.empty()) write_cached_binary(name, "key", binary);
      }
      _exit(wrong == 0 ? 0 : 1);
    }
    children.push_back(child);
  }
  int broken = 0;
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    broken += !WIFEXITED(status) || WEXITSTATUS(status) != 0;
  }
  CHECK(broken == 0);
  std::uintmax_t bytes = 0;
  for (const fs::path& file : cache.files()) {
    CHECK(file.extension() == ".program");
    bytes += fs::file_size(file);
  }
  CHECK(bytes > 0);
  CHECK(bytes <= (1 << 20) + 200200);
  unsetenv("STRAHL_CACHE_MIB");
}
