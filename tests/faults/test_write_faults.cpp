// SPDX-License-Identifier: MIT
// Every call of a render that writes fails in turn: no crash, no half file, no success that is none, and nothing older
// than the last checkpoint is lost (docs/reliability.md).
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "image/image_io.h"
#include "support/needs.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

#ifdef __SANITIZE_ADDRESS__
// Its runtime must be the first that is loaded.
const strahl::test::Needs needs("a program without sanitizers");
#endif

const std::vector<std::string> render{
    STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "48", "-d", "pocl", "-q"};

std::vector<std::string> with(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A render that goes on from a checkpoint of 32 samples to 40, writing all that a render writes.
class UnwritableRender {
 public:
  UnwritableRender() {
    const Outcome before = folder_.run(with(render, {"--spp", "32", "--checkpoint", "c.ckpt", "-o", "before.exr"}));
    INFO(before.err);
    REQUIRE(before.code == 0);
    kept_ = read_text(folder_.path("c.ckpt"));
    // Also fills the cache of programs.
    REQUIRE(run({}).code == 0);
    picture_ = read_picture();
    calls_ = lines_of(read_text(folder_.path("calls.log")));
    REQUIRE(calls_.size() > 10);
  }

  [[nodiscard]] const std::vector<std::string>& calls() const { return calls_; }

  void fail(std::size_t call, const std::string& kind) {
    INFO("call " << call << " of " << calls_.size() << " (" << calls_[call - 1] << "): " << kind);
    const Outcome outcome = run({{"STRAHL_FAULT_CALL", std::to_string(call)}, {"STRAHL_FAULT_KIND", kind}});
    INFO(outcome.err);
    REQUIRE(outcome.signal == 0);
    const bool is_there = fs::exists(folder_.path("out.exr"));
    if (is_there) CHECK(read_picture().data == picture_.data);
    const strahl::Checkpoint checkpoint = strahl::read_checkpoint(folder_.path("c.ckpt"));
    CHECK(checkpoint.header.least >= 32);
    if (outcome.code == 0) {
      ++successes;
      CHECK(is_there);
      CHECK(checkpoint.header.least == 40);
      CHECK(fs::exists(folder_.path("stats.json")));
    } else {
      ++failures;
      CHECK(outcome.code == 1);
      CHECK(contains(outcome.err, "strahl: error: cannot write"));
    }
    // What is complete and only has no name yet is set aside, or named where even that fails.
    const bool is_set_aside = contains(outcome.err, "the complete file is");
    if (calls_[call - 1] == "rename" && kind != "short") CHECK(is_set_aside);
    hold_set_aside(outcome.err);
    CHECK(leftovers() == 0);
  }

  /// And tried again, as a script would. Whether there was a temporary file in between.
  [[nodiscard]] bool kill_at(std::size_t call) {
    INFO("killed before call " << call << " of " << calls_.size() << " (" << calls_[call - 1] << ")");
    const Outcome killed = run({{"STRAHL_FAULT_CALL", std::to_string(call)}, {"STRAHL_FAULT_KIND", "kill"}});
    CHECK(killed.signal == SIGKILL);
    if (fs::exists(folder_.path("out.exr"))) CHECK(read_picture().data == picture_.data);
    CHECK(strahl::read_checkpoint(folder_.path("c.ckpt")).header.least >= 32);
    const bool is_left = leftovers() > 0;
    const Outcome again = run({}, true);
    INFO(again.err);
    CHECK(again.code == 0);
    CHECK(read_picture().data == picture_.data);
    CHECK(leftovers() == 0);
    return is_left;
  }

  int successes = 0, failures = 0;

 private:
  /// goes_on: with what the run before has left.
  [[nodiscard]] Outcome run(const std::map<std::string, std::string>& fault, bool goes_on = false) {
    if (!goes_on) {
      for (const std::string& name : folder_.files())
        if (name != "cache") fs::remove(folder_.path(name));
      folder_.file("c.ckpt", kept_);
    }
    std::map<std::string, std::string> environment{{"LD_PRELOAD", STRAHL_FAIL_WRITE},
                                                   {"STRAHL_FAULT_FOLDER", folder_.path("")},
                                                   {"STRAHL_FAULT_LOG", folder_.path("calls.log")}};
    environment.insert(fault.begin(), fault.end());
    return folder_.run(with(render, {"--spp", "40", "--resume", "c.ckpt", "-o", "out.exr", "--stats", "stats.json",
                                     "--every", "1h", "--error-map", "map.pfm"}),
                       environment);
  }
  [[nodiscard]] std::ptrdiff_t leftovers() const {
    const std::vector<std::string> names = folder_.files();
    return std::count_if(names.begin(), names.end(), [](const std::string& name) { return name.ends_with(".tmp"); });
  }
  /// Each file that the message says is complete.
  void hold_set_aside(const std::string& message) const {
    const std::string before = "the complete file is \"";
    for (std::size_t at = message.find(before); at != std::string::npos; at = message.find(before, at)) {
      at += before.size();
      const std::string path = folder_.path(message.substr(at, message.find('"', at) - at));
      INFO(path);
      REQUIRE(fs::exists(path));
      if (path.ends_with(".exr")) CHECK(strahl::read_image(path).data == picture_.data);
      if (path.ends_with(".ckpt")) CHECK(strahl::read_checkpoint(path).header.least >= 32);
      fs::remove(path);
    }
  }
  [[nodiscard]] strahl::Image read_picture() const { return strahl::read_image(folder_.path("out.exr")); }

  Folder folder_;
  std::string kept_;
  strahl::Image picture_;
  std::vector<std::string> calls_;
};

}  // namespace

TEST_CASE("each call that writes fails in turn") {
  UnwritableRender faulty;
  // The checkpoint is flushed before it has its name, and its folder after it.
  const auto flushed = std::find(faulty.calls().begin(), faulty.calls().end(), "fsync");
  REQUIRE(faulty.calls().end() - flushed >= 3);
  CHECK(flushed[1] == "rename");
  CHECK(flushed[2] == "fsync");
  const bool is_long = std::getenv("STRAHL_ALL_FAULTS") != nullptr;
  const std::vector<std::string> kinds{"EIO", "ENOSPC", "short"};
  for (std::size_t call = 1; call <= faulty.calls().size(); ++call) {
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
      if (is_long || call % kinds.size() == kind) faulty.fail(call, kinds[kind]);
  }
  // A short write is made good by the next one; all else ends in an error.
  CHECK(faulty.failures > 0);
  CHECK(faulty.successes > 0);
  CHECK(faulty.failures > faulty.successes);
}

TEST_CASE("killed at each call that writes, and tried again") {
  UnwritableRender faulty;
  const bool is_long = std::getenv("STRAHL_ALL_FAULTS") != nullptr;
  int left = 0;
  // Each sort of call at both ends at the least.
  for (std::size_t call = 1; call <= faulty.calls().size(); call += is_long ? 1 : 3)
    left += faulty.kill_at(call) ? 1 : 0;
  CHECK(left > 0);
}

TEST_CASE("a watchdog of launches leaves a slow disk its time") {
  const Folder folder;
  const auto run = [&](const char* every, const std::map<std::string, std::string>& fault) {
    for (const std::string& name : folder.files())
      if (name != "cache") fs::remove(folder.path(name));
    std::map<std::string, std::string> environment{{"LD_PRELOAD", STRAHL_FAIL_WRITE},
                                                   {"STRAHL_FAULT_FOLDER", folder.path("")},
                                                   {"STRAHL_FAULT_LOG", folder.path("calls.log")},
                                                   {"STRAHL_FAULT_NAME", "fsync"},
                                                   {"STRAHL_FAULT_KIND", "slow"}};
    environment.insert(fault.begin(), fault.end());
    const Outcome outcome = folder.run(
        with(render, {"--spp", "64", "--checkpoint", "c.ckpt", "--every", every, "--watchdog", "1s", "-o", "out.exr"}),
        environment);
    INFO("--every " << every << ": " << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(fs::exists(folder.path("out.exr")));
  };
  const auto seconds_of = [&](const char* every, std::size_t call) {
    const auto start = std::chrono::steady_clock::now();
    run(every, {{"STRAHL_FAULT_CALL", std::to_string(call)}});
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  run("1h", {});  // Also fills the cache of programs.
  const std::size_t calls = lines_of(read_text(folder.path("calls.log"))).size();
  REQUIRE(calls >= 2);
  CHECK(seconds_of("1ms", 1) > 2);     // The first checkpoint, which the last one has to wait for.
  CHECK(seconds_of("1h", calls) > 2);  // The picture.
}
