// SPDX-License-Identifier: MIT
// Output files are complete or absent, whatever goes wrong: full disk, missing folder, no permission, an exception.
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>

#include "errors.h"
#include "image/atomic_file.h"
#include "image/file_bytes.h"
#include "image/image_io.h"
#include "image/npy.h"
#include "image/pictures.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// No file may grow beyond `bytes`: what a full disk looks like to a writer, without one.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

/// Root may write anywhere; the test then goes on as nobody.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (was_root_) REQUIRE(::seteuid(65534) == 0);
  }
  ~OrdinaryUser() {
    if (was_root_ && ::seteuid(0) != 0) std::abort();
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
  bool was_root_ = ::geteuid() == 0;
};

/// What writing to `path` says; empty where it works.
std::string fault_of_writing(const std::string& path) {
  try {
    AtomicFile file(path);
    file.write("new");
    file.commit();
    return {};
  } catch (const Error& fault) {
    return fault.what();
  }
}

std::string name_of_descriptor(int descriptor) { return "/dev/fd/" + std::to_string(descriptor); }

/// Noise, which no compression brings below the limit that the tests set.
Image noise() {
  Image image = picture(200, 200, {"R", "G", "B"}, {0});
  unsigned state = 1;
  for (float& value : image.data) value = static_cast<float>((state = state * 1664525U + 1013904223U) >> 8) * 0x1p-24F;
  return image;
}

}  // namespace

TEST_CASE("a committed file is there, an abandoned one is not") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.txt";
  {
    AtomicFile file(path);
    file.write("hello ");
    CHECK_FALSE(fs::exists(path));
    CHECK(folder.names().size() == 1);
    file.write("world");
    file.seek(0);
    file.write("J");
    CHECK(file.tell() == 1);
    file.commit();
  }
  CHECK(bytes_of(path) == "Jello world");
  { AtomicFile(path).write("half"); }
  CHECK(bytes_of(path) == "Jello world");
  CHECK(folder.names() == std::set<std::string>{"a.txt"});
}

TEST_CASE("two writers of one file do not meet") {
  const TemporaryFolder folder;
  AtomicFile first(folder / "a");
  AtomicFile second(folder / "a");
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  CHECK(bytes_of(folder / "a") == "first");
  CHECK(folder.names().size() == 1);
}

TEST_CASE("permissions: the umask's for a new file, the old ones for a replaced file") {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(027);
  AtomicFile(folder / "new").commit();
  ::umask(mask);
  CHECK((fs::status(folder / "new").permissions() & fs::perms::mask) == fs::perms(0640));
  fs::permissions(folder / "new", fs::perms(0604));
  AtomicFile(folder / "new").commit();
  CHECK((fs::status(folder / "new").permissions() & fs::perms::mask) == fs::perms(0604));
}

TEST_CASE("a symbolic link stays one, its target is replaced") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "deep");
  put_bytes(folder / "deep/target", "old");
  fs::create_symlink("deep/target", folder / "link");
  AtomicFile file(folder / "link");
  file.write("new");
  file.commit();
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(bytes_of(folder / "deep/target") == "new");
}

TEST_CASE("a symbolic link to what is not there yet stays one, and leads to it") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "deep");
  fs::create_symlink("deep/second", folder / "first");
  fs::create_symlink(folder / "target", folder / "deep/second");
  AtomicFile file(folder / "first");
  file.write("new");
  file.commit();
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "deep/second"));
  CHECK(bytes_of(folder / "target") == "new");
  CHECK(folder.names() == std::set<std::string>{"deep", "first", "target"});
  fs::create_symlink("loop", folder / "loop");
  CHECK_THROWS_AS(AtomicFile(folder / "loop").commit(), Error);
  fs::create_symlink("none/x", folder / "nowhere");
  CHECK_THROWS_WITH(AtomicFile(folder / "nowhere"), Contains("none\" does not exist"));
}

TEST_CASE("a name as long as names can be") {
  const TemporaryFolder folder;
  const std::string name(255, 'x');
  AtomicFile(folder / name).commit();
  CHECK(folder.names() == std::set<std::string>{name});
}

TEST_CASE("places that cannot be written to") {
  const TemporaryFolder folder;
  put_bytes(folder / "file", "");
  CHECK_THROWS_WITH(AtomicFile(folder / "no/a.png"), Contains("does not exist; create it first"));
  CHECK_THROWS_WITH(AtomicFile(folder / "file/a.png"), Contains("is not a folder"));
  CHECK_THROWS_WITH(AtomicFile(folder.path()), Contains("is a folder; name a file"));
  CHECK_THROWS_AS(AtomicFile(""), Error);
  CHECK(folder.names() == std::set<std::string>{"file"});
}

TEST_CASE("no permission") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "closed");
  put_bytes(folder / "kept", "old");
  fs::permissions(folder.path(), fs::perms(0755));
  fs::permissions(folder / "closed", fs::perms(0555));
  fs::permissions(folder / "kept", fs::perms(0444));
  const OrdinaryUser nobody;
  CHECK_THROWS_WITH(AtomicFile(folder / "closed/a.png"), Contains("no permission to write here"));
  CHECK_THROWS_WITH(AtomicFile(folder / "kept"), Contains("no permission to write here"));
  CHECK(bytes_of(folder / "kept") == "old");
}

TEST_CASE("a full disk leaves the older file and nothing else") {
  const TemporaryFolder folder;
  const Image image = noise();
  Matrix matrix{100, 100, std::vector<double>(10000, 0.1)};
  for (const std::string name : {"a.png", "a.exr", "a.pfm", "a.npy"}) {
    INFO(name);
    put_bytes(folder / name, "old");
    const auto write = [&] {
      name == "a.npy" ? write_npy(matrix, folder / name) : void(write_image(image, folder / name));
    };
    {
      const FileSizeLimit limit(20000);
      CHECK_THROWS_WITH(write(), Contains(name) && Contains("File too large"));
    }
    CHECK(bytes_of(folder / name) == "old");
    CHECK(folder.names().size() == 1);
    CHECK_NOTHROW(write());
    CHECK(bytes_of(folder / name).size() > 20000);
    fs::remove(folder / name);
  }
}

TEST_CASE("a device is written to and not replaced, and says that it is full") {
  const TemporaryFolder folder;
  CHECK_NOTHROW(write_npy({1, 2, {3, 4}}, "/dev/null"));
  CHECK(fs::is_character_file("/dev/null"));
  if (!fs::exists("/dev/full")) return;  // Linux alone has it.
  fs::create_symlink("/dev/full", folder / "a.png");
  CHECK_THROWS_WITH(write_image(noise(), folder / "a.png"), Contains("the disk is full"));
  CHECK_THROWS_WITH(write_npy({1, 2, {3, 4}}, "/dev/full"), Contains("the disk is full"));
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a failure that somebody swallowed still fails the commit") {
  const TemporaryFolder folder;
  {
    const FileSizeLimit limit(10);
    AtomicFile file(folder / "a");
    CHECK_THROWS_AS(file.write(std::string(100000, 'x')), Error);
    CHECK_THROWS_AS(file.commit(), Error);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("whole files are read, and unreadable ones say why") {
  const TemporaryFolder folder;
  for (const std::size_t size : {0, 1, 4095, 65536, 200000}) {
    const std::string bytes(size, 'z');
    put_bytes(folder / "a", bytes);
    CHECK(read_file(folder / "a") == bytes);
  }
  ::mkfifo((folder / "pipe").c_str(), 0600);
  const pid_t child = ::fork();
  if (child == 0) {
    put_bytes(folder / "pipe", std::string(300000, 'p'));
    ::_exit(0);
  }
  CHECK(read_file(folder / "pipe") == std::string(300000, 'p'));
  CHECK_THROWS_WITH(read_file(folder / "none"), Contains("there is no such file"));
  CHECK_THROWS_WITH(read_file(folder.path()), Contains("it is a folder"));
  CHECK_THROWS_AS(read_file(folder / "none"), InputError);
}

TEST_CASE("pictures go into a pipe as they go into a file") {
  const TemporaryFolder folder;
  for (const std::string extension : {".exr", ".png", ".pfm"}) {
    INFO(extension);
    const std::string pipe = folder / ("pipe" + extension), file = folder / ("file" + extension);
    write_image(noise(), file);
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const pid_t reader = ::fork();
    if (reader == 0) {
      put_bytes(folder / ("read" + extension), read_file(pipe));
      ::_exit(0);
    }
    CHECK_NOTHROW(write_image(noise(), pipe));
    REQUIRE(::waitpid(reader, nullptr, 0) == reader);
    CHECK(read_file(folder / ("read" + extension)) == read_file(file));
    CHECK(fs::is_fifo(pipe));
  }
}

TEST_CASE("an open pipe is written to by its descriptor's name, through links too") {
  const TemporaryFolder folder;
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const std::string path = name_of_descriptor(ends[1]);
  fs::create_symlink(path, folder / "link");
  for (const std::string& name : {path, folder / "link"}) {
    INFO(name);
    CHECK(fault_of_writing(name).empty());
    char read[8] = {};
    REQUIRE(::read(ends[0], read, sizeof read) == 3);
    CHECK(std::string(read) == "new");
  }
  CHECK(folder.names() == std::set<std::string>{"link"});
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_CASE("an open file that was removed is written to") {
  const TemporaryFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  REQUIRE(file >= 0);
  fs::remove(folder / "a");
  CHECK(fault_of_writing(name_of_descriptor(file)).empty());
  char read[8] = {};
  REQUIRE(::pread(file, read, sizeof read, 0) == 3);
  CHECK(std::string(read) == "new");
  CHECK(folder.names().empty());
  ::close(file);
}

TEST_CASE("what is open already is written on, not begun anew") {
  const TemporaryFolder folder;
  put_bytes(folder / "log", "old ");
  const int file = ::open((folder / "log").c_str(), O_WRONLY | O_APPEND);
  REQUIRE(file >= 0);
  {
    AtomicFile behind(name_of_descriptor(file));
    CHECK_FALSE(behind.can_seek());
    behind.write(std::string("new"));
    behind.commit();
  }
  CHECK(bytes_of(folder / "log") == "old new");
  CHECK(folder.names().size() == 1);
  ::close(file);
  const int closed_to_writing = ::open((folder / "log").c_str(), O_RDONLY);
  CHECK_FALSE(fault_of_writing(name_of_descriptor(closed_to_writing)).empty());
  ::close(closed_to_writing);
}

TEST_CASE("where the target cannot be replaced at the end, the complete file stays, and is named") {
  const TemporaryFolder folder;
  const std::string target = folder / "a.png", aside = folder / ("a.unplaced-" + std::to_string(::getpid()) + ".png");
  // Again and again leaves one.
  for (const char* text : {"first", "second"}) {
    AtomicFile file(target);
    file.write(std::string(text));
    fs::create_directory(target);
    CHECK_THROWS_WITH(file.commit(),
                      Contains(target + "\": it is a folder") && Contains("the complete file is \"" + aside + "\""));
    CHECK(bytes_of(aside) == text);
    fs::remove(target);
  }
  CHECK(folder.names().size() == 1);
  const std::string longest(255, 'x');
  AtomicFile file(folder / longest);
  fs::create_directory(folder / longest);
  CHECK_THROWS_WITH(file.commit(), Contains("the complete file is"));
  CHECK(folder.names().size() == 3);
}

TEST_CASE("another user's file in a sticky folder is refused beforehand") {
  if (::geteuid() != 0) return;  // Only root can give files away.
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms(0755));
  fs::create_directory(folder / "sticky");
  put_bytes(folder / "sticky/theirs", "old");
  fs::permissions(folder / "sticky", fs::perms(01777));
  fs::permissions(folder / "sticky/theirs", fs::perms(0666));
  REQUIRE(::chown((folder / "sticky/theirs").c_str(), 1, 1) == 0);
  {
    const OrdinaryUser nobody;
    CHECK_THROWS_WITH(AtomicFile(folder / "sticky/theirs"), Contains("belongs to another user"));
    CHECK(fault_of_writing(folder / "sticky/ours").empty());
    CHECK(fault_of_writing(folder / "sticky/ours").empty());
  }
  CHECK(bytes_of(folder / "sticky/theirs") == "old");
  CHECK(fault_of_writing(folder / "sticky/theirs").empty());
}

TEST_CASE("a mount point is refused beforehand") {
  const TemporaryFolder folder;
  put_bytes(folder / "a", "old");
  put_bytes(folder / "b", "other");
  constexpr int no_mounts = 77;
  const pid_t child = ::fork();
  if (child == 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWNS) != 0) ::_exit(no_mounts);
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    if (::mount((folder / "b").c_str(), (folder / "a").c_str(), nullptr, MS_BIND, nullptr) != 0) ::_exit(no_mounts);
    ::_exit(fault_of_writing(folder / "a").find("it is a mount point") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  if (WEXITSTATUS(status) == no_mounts) return;  // Where nobody may mount anything.
  CHECK(status == 0);
  CHECK(folder.names() == std::set<std::string>{"a", "b"});
  CHECK(bytes_of(folder / "b") == "other");
}
