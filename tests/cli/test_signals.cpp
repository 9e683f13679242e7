// SPDX-License-Identifier: MIT
// Signals that must not cost a picture: a reader that leaves (SIGPIPE), a file that grows too large (SIGXFSZ), a
// snapshot that is asked for early (SIGUSR1). And a dry run, which has nothing to lose.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// As `ulimit -f` of the programs that are run while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

void wait_for(const std::string& path, std::chrono::milliseconds most) {
  for (auto waited = 0ms; waited < most && !fs::exists(path); waited += 10ms) std::this_thread::sleep_for(10ms);
}

bool ends_within(pid_t child, std::chrono::milliseconds most) {
  for (auto waited = 0ms; waited < most; waited += 10ms) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == child)
      return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

/// Sends SIGUSR1 while the scene is read, from a pipe, and no device is opened yet.
class AskedWhileReading {
 public:
  explicit AskedWhileReading(const Folder& folder) : pipe_(folder.path("scene.xml")) {
    REQUIRE(mkfifo(pipe_.c_str(), 0600) == 0);
  }
  void operator()(pid_t child) const {
    std::ofstream scene(pipe_);  // Waits for the reader, who waits for the end.
    scene << glowing_sphere << std::flush;
    kill(child, SIGUSR1);
  }

 private:
  std::string pipe_;
};

/// Runs a line of shell in the folder, with the program in $STRAHL.
int shell(const Folder& folder, const std::string& line) {
  std::signal(SIGPIPE, SIG_DFL);  // Whatever runs the tests has made of it.
  const std::string command = "cd '" + folder.path("") + "' && STRAHL='" STRAHL_PROGRAM "' && " + line;
  return WEXITSTATUS(std::system(command.c_str()));
}

}  // namespace

TEST_CASE("a reader of messages that leaves costs neither picture nor checkpoint nor statistics") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  CHECK(shell(folder,
              "{ \"$STRAHL\" scene.xml -v -o out.exr --checkpoint c.ckpt --stats s.json; echo $? > code; } 2>&1 "
              "| true") == 0);
  CHECK(read_text(folder.path("code")) == "0\n");
  CHECK(folder.files() == std::vector<std::string>{"c.ckpt", "code", "out.exr", "s.json", "scene.xml"});
}

TEST_CASE("a reader of results that leaves is said") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  CHECK(shell(folder, "{ \"$STRAHL\" scene.xml -q -o out.exr --stats - 2> said; echo $? > code; } | true") == 0);
  CHECK(read_text(folder.path("code")) == "1\n");
  CHECK(read_text(folder.path("said")) == "strahl: error: cannot write to standard output: Broken pipe\n");
  CHECK(fs::exists(folder.path("out.exr")));
}

TEST_CASE("a reader of the kernel that leaves costs no picture") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  CHECK(shell(folder,
              "{ \"$STRAHL\" scene.xml -q -o out.exr --dump-kernel - 2> said; echo $? > code; } | head -1 > line") ==
        0);
  CHECK(contains(read_text(folder.path("line")), "-cl-std=CL1.2"));
  CHECK(read_text(folder.path("code")) == "1\n");
  CHECK(read_text(folder.path("said")) ==
        "strahl: error: --dump-kernel: cannot write to standard output: Broken pipe\n");
  CHECK(fs::exists(folder.path("out.exr")));
}

TEST_CASE("a checkpoint and a picture beyond the limit of a file's size are said, and leave nothing") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::vector<std::string> options{"scene.xml", "--width", "128",     "--spp",        "4",
                                         "-q",        "-o",      "out.pfm", "--checkpoint", "c.ckpt"};
  REQUIRE(folder.run(options).code == 0);  // Programs are in the caches now, which the limit would keep out.
  for (const char* name : {"out.pfm", "c.ckpt"}) fs::remove(folder.path(name));
  std::signal(SIGXFSZ, SIG_DFL);  // Whatever runs the tests has made of it.
  const FileSizeLimit limit(40000);
  // LLVM's handler survives the first of the two signals; without LLVM none is.
  const Outcome outcome = folder.run(options);
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == 1);
  for (const char* name : {"out.pfm", "c.ckpt"})
    CHECK(contains(outcome.err, "cannot write \"" + std::string(name) + "\": File too large"));
  CHECK(folder.files() == std::vector<std::string>{"scene.xml"});
}

TEST_CASE("a snapshot that is asked for before the first launch is taken") {
  const Folder folder;
  const AskedWhileReading ask(folder);
  const Outcome outcome =
      folder.run({"scene.xml", "-o", "out.exr", "--width", "128", "--spp", "2000000", "--sampler", "independent"}, {},
                 [&](pid_t child) {
                   ask(child);
                   wait_for(folder.path("out.snapshot.exr"), 60s);
                   kill(child, SIGINT);
                 });
  INFO(outcome.err);
  CHECK(outcome.code == 130);
  REQUIRE(fs::exists(folder.path("out.snapshot.exr")));
  CHECK(strahl::read_image(folder.path("out.snapshot.exr")).metadata.at("incomplete") == "snapshot");
}

TEST_CASE("a command without snapshots goes on when it is asked for one") {
  const Folder folder;
  const Outcome outcome = folder.run({"explain", "scene.xml", "--lanes", "1"}, {}, AskedWhileReading(folder));
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == 0);
}

TEST_CASE("a signal ends a dry run at once, without a prediction") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  // Of a render of days, so that the pilot takes hours.
  const Outcome outcome = folder.run({"scene.xml", "--dry-run", "--width", "1024", "--spp", "2000000", "--sampler",
                                      "independent", "--dump-kernel", folder.path("kernel.cl")},
                                     {}, [&](pid_t child) {
                                       wait_for(folder.path("kernel.cl"), 60s);
                                       std::this_thread::sleep_for(1s);
                                       kill(child, signal);
                                       if (!ends_within(child, 5s)) kill(child, SIGKILL);
                                     });
  INFO(outcome.err);
  CHECK(outcome.signal == signal);
  CHECK(outcome.out.empty());
}
