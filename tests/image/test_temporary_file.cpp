// SPDX-License-Identifier: MIT
// Temporary files of writers that were killed are removed by the next one; those of the living, of other machines and
// of others stay.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>

#include "image/atomic_file.h"
#include "image/temporary_file.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
namespace fs = std::filesystem;

namespace {

/// A process that has begun a file in the folder, and waits.
class Writer {
 public:
  explicit Writer(const std::string& folder) {
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    child_ = ::fork();
    REQUIRE(child_ >= 0);
    if (child_ == 0) {
      AtomicFile file(folder + "/picture.png");
      file.write("half a picture");
      if (::write(ready[1], "x", 1) != 1) _exit(1);
      while (true) ::pause();
    }
    char byte = 0;
    REQUIRE(::read(ready[0], &byte, 1) == 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Writer() { kill(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = -1;
  }

 private:
  pid_t child_ = -1;
};

void write_to(const std::string& path) {
  AtomicFile file(path);
  file.write("x");
  file.commit();
}

}  // namespace

TEST_CASE("what a killed writer left is removed by the next file in its folder, what a living one has is not") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  fs::create_directory(folder / "b");
  Writer writer(folder / "a"), other(folder / "b");
  CHECK(std::distance(fs::directory_iterator(folder / "a"), {}) == 1);
  write_to(folder / "a/while-it-lives");
  CHECK(std::distance(fs::directory_iterator(folder / "a"), {}) == 2);
  other.kill();
  CHECK(std::distance(fs::directory_iterator(folder / "b"), {}) == 1);
  write_to(folder / "b/after-it");
  CHECK(std::distance(fs::directory_iterator(folder / "b"), {}) == 1);
  CHECK(fs::exists(folder / "b/after-it"));
}

TEST_CASE("a folder is looked through once") {
  const TemporaryFolder folder;
  write_to(folder / "first");
  Writer(folder.path()).kill();
  CHECK(folder.names().size() == 2);
  write_to(folder / "second");
  CHECK(folder.names().size() == 3);
}

TEST_CASE("what is not surely abandoned stays") {
  const TemporaryFolder folder;
  const TemporaryFile ours = make_temporary_file(folder.path());
  REQUIRE(ours.descriptor >= 0);
  const std::string name = fs::path(ours.path).filename(), boot = name.substr(8, 32);
  CHECK(name.substr(0, 8) == ".strahl-");
  CHECK(boot.find_first_not_of("0123456789abcdef") == std::string::npos);
  ::close(ours.descriptor);
  // Of another machine or an earlier start, as it was called before, and things that are no files.
  std::string elsewhere = boot;
  elsewhere[5] = elsewhere[5] == 'a' ? 'b' : 'a';
  put_bytes(folder / (".strahl-" + elsewhere + "-1-0.tmp"), "x");
  put_bytes(folder / ".strahl-1-0.tmp", "x");
  put_bytes(folder / (".strahl-" + boot + "-1-0.png"), "x");
  put_bytes(folder / "target", "x");
  fs::create_symlink("target", folder / (".strahl-" + boot + "-1-1.tmp"));
  fs::create_directory(folder / (".strahl-" + boot + "-1-2.tmp"));
  REQUIRE(::mkfifo((folder / (".strahl-" + boot + "-1-3.tmp")).c_str(), 0600) == 0);
  // Locked, as by a writer.
  const TemporaryFile locked = make_temporary_file(folder.path());
  const std::size_t before = folder.names().size();
  remove_abandoned_files(folder.path());
  CHECK(folder.names().size() == before - 1);
  CHECK_FALSE(fs::exists(ours.path));
  CHECK(fs::exists(locked.path));
  ::close(locked.descriptor);
}
