// SPDX-License-Identifier: MIT
// The wall clock jumps while a picture is rendered (set by hand, by a time server, a virtual machine that was asleep):
// limits of time, checkpoints and the watchdog go by clocks that only count up, so that nothing changes.
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "image/image_io.h"
#include "support/needs.h"

using namespace strahl_test;

namespace {

#ifdef __SANITIZE_ADDRESS__
// Its runtime must be the first that is loaded.
const strahl::test::Needs needs_no_sanitizer("a program without sanitizers");
#endif

class JumpingClock {
 public:
  [[nodiscard]] Outcome run(const std::vector<std::string>& more, std::map<std::string, std::string> environment = {}) {
    std::vector<std::string> options{
        STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "24", "-d", "pocl", "-q"};
    options.insert(options.end(), more.begin(), more.end());
    environment["LD_PRELOAD"] = STRAHL_JUMP_CLOCK;
    environment["STRAHL_CLOCK_LOG"] = folder_.path("looks");
    return folder_.run(options, environment);
  }
  [[nodiscard]] const Folder& folder() const { return folder_; }
  [[nodiscard]] nlohmann::json stats() const { return nlohmann::json::parse(read_text(folder_.path("s.json"))); }

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("the shim makes a clock jump") {
  const Folder folder;
  const std::string command =
      "LD_PRELOAD=" STRAHL_JUMP_CLOCK " STRAHL_CLOCK_LOG=" + folder.path("looks") + " date > /dev/null";
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(read_text(folder.path("looks")) == "+x");
}

TEST_CASE("a picture, its checkpoint and a limit of time under a clock that jumps") {
  JumpingClock clock;
  const Outcome warm = clock.run({"--spp", "40", "-o", "one.exr"});  // Also fills the cache of programs.
  INFO(warm.err);
  REQUIRE(warm.code == 0);
  // It was loaded. Neither strahl nor PoCL look at the wall clock here today, and if they do the picture is the same.
  CHECK(contains(read_text(clock.folder().path("looks")), "+"));
  REQUIRE(clock.folder()
              .run({STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "24", "-d", "pocl", "-q", "--spp",
                    "40", "-o", "steady.exr"})
              .code == 0);
  CHECK(strahl::read_image(clock.folder().path("one.exr")).data ==
        strahl::read_image(clock.folder().path("steady.exr")).data);

  // 6: more than 2 % late, as a busy machine makes it.
  const auto start = std::chrono::steady_clock::now();
  const Outcome timed = clock.run({"--time", "3s", "-o", "timed.exr", "--stats", "s.json", "--checkpoint", "c.ckpt",
                                   "--every", "1s", "--watchdog", "20s"});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  INFO(timed.err);
  CHECK((timed.code == 0 || timed.code == 6));
  CHECK(seconds.count() > 2);
  CHECK(seconds.count() < 20);
  CHECK(clock.stats().at("ending") == "deadline");
  for (const auto& [phase, taken] : clock.stats().at("seconds").items()) {
    INFO(phase);
    CHECK(taken >= 0);
    CHECK(taken < 20);
  }
  CHECK(strahl::read_checkpoint(clock.folder().path("c.ckpt")).header.least ==
        clock.stats().at("least_spp").get<int>());
}

TEST_CASE("a watchdog under a clock that jumps bites when its time has come, and not before") {
  JumpingClock clock;
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(clock
              .run({"--spp", "8", "-o", "one.exr", "--watchdog", "60s"},
                   {{"OPENCL_LAYERS", STRAHL_FAIL_OPENCL}, {"STRAHL_CL_FAULT_LOG", clock.folder().path("calls")}})
              .code == 0);
  std::istringstream log(read_text(clock.folder().path("calls")));
  std::size_t call = 0, last = 0;
  for (std::string line; std::getline(log, line);)
    if (++call; line == "clFinish") last = call;
  const Outcome hung =
      clock.run({"--spp", "8", "-o", "two.exr", "--watchdog", "2s"}, {{"OPENCL_LAYERS", STRAHL_FAIL_OPENCL},
                                                                      {"STRAHL_CL_FAULT_CALL", std::to_string(last)},
                                                                      {"STRAHL_CL_FAULT_CODE", "hang"}});
  INFO(hung.err);
  CHECK(hung.code == 1);
  CHECK(contains(hung.err, "has not come back from a launch for 2 s"));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CHECK(seconds.count() > 2);
  CHECK(seconds.count() < 60);
}
