// SPDX-License-Identifier: MIT
// What is computed once the last sample is there fails: the picture and its statistics are written without it, with a
// warning that says why. Where it takes long, that is no launch that hangs, and what it counts is what there is.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.h"
#include "faults/launches.h"
#include "image/image_io.h"

using namespace strahl_test;
using namespace std::chrono_literals;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A picture without an error, so that no pilot measures its rounding at the end, if not asked for in `base`.
class LateFault {
 public:
  LateFault() { folder_.file("s.xml", glowing_sphere); }

  [[nodiscard]] Outcome run(const std::vector<std::string>& more, std::map<std::string, std::string> environment = {},
                            const std::function<void(pid_t)>& while_running = {}) const {
    for (const char* name : {"out.exr", "calls.log", "stats.json", "c.ckpt"}) fs::remove(folder_.path(name));
    environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
    environment["STRAHL_CL_FAULT_LOG"] = folder_.path("calls.log");
    std::vector<std::string> options = base;
    options.insert(options.end(), more.begin(), more.end());
    return folder_.run(options, environment, while_running);
  }

  /// How many calls of this name a run makes. Others are not in a certain order: a thread clears films when it likes.
  [[nodiscard]] std::ptrdiff_t count(const std::string& name, const std::vector<std::string>& more) const {
    const Outcome outcome = run(more, {{"STRAHL_CL_FAULT_NAME", name}});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string log = read_text(folder_.path("calls.log"));
    return std::count(log.begin(), log.end(), '\n');
  }

  /// The last call of this name does as `how` says.
  [[nodiscard]] Outcome fault_in_last(const std::string& name, const std::vector<std::string>& more,
                                      std::map<std::string, std::string> how,
                                      const std::function<void(pid_t)>& while_running = {}) const {
    REQUIRE(run(more).code == 0);  // Fills the cache of programs: to build one takes calls, too.
    how["STRAHL_CL_FAULT_NAME"] = name;
    how["STRAHL_CL_FAULT_CALL"] = std::to_string(count(name, more));
    return run(more, how, while_running);
  }

  [[nodiscard]] Outcome fail_last_launch(const std::vector<std::string>& more) const {
    return fault_in_last(launch_call, more, {{"STRAHL_CL_FAULT_CODE", "-5"}});
  }

  [[nodiscard]] Json stats() const { return Json::parse(read_text(folder_.path("stats.json"))); }

  [[nodiscard]] const Folder& folder() const { return folder_; }

  std::vector<std::string> base{"s.xml", "--spp", "4", "--no-error", "-d", "pocl", "-q", "-o", "out.exr"};

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("numeric_error fails after the last sample: the picture is there without that layer") {
  LateFault late;
  const Outcome outcome = late.fail_last_launch({"--aov", "depth,numeric_error"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "strahl: warning: --aov numeric_error is left out: "));
  CHECK(contains(outcome.err, "CL_OUT_OF_RESOURCES"));
  CHECK(strahl::read_image(late.folder().path("out.exr")).channels ==
        std::vector<std::string>{"R", "G", "B", "depth.Z"});
}

TEST_CASE("the pilot of float rounding fails: the bill says why it tells none") {
  LateFault late;
  late.base = {"s.xml", "--spp", "4", "-v", "--no-progress", "-d", "pocl", "-o", "out.exr"};
  const Outcome outcome = late.fail_last_launch({});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  const std::size_t bill = outcome.err.find("float rounding not measured (");
  REQUIRE(bill != std::string::npos);
  CHECK(contains(outcome.err.substr(bill), "CL_OUT_OF_RESOURCES"));
  CHECK_FALSE(contains(outcome.err, "too large to be there twice"));
}

TEST_CASE("the run that counts rays fails: the statistics of the picture are written") {
  LateFault late;
  const Outcome outcome = late.fail_last_launch({"--stats", "stats.json", "--stats-detail"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "strahl: warning: --stats-detail counts nothing: "));
  CHECK(contains(outcome.err, "CL_OUT_OF_RESOURCES"));
  CHECK(fs::exists(late.folder().path("out.exr")));
  const Json stats = late.stats();
  CHECK(stats.at("detail").is_null());
  CHECK(stats.at("rays").at("camera") == 32 * 24 * 4);
}

TEST_CASE("rays are counted in launches of their own, however the picture is divided") {
  LateFault late;
  std::vector<std::string> options{"--spp", "128", "--passes", "128", "--stats", "stats.json"};
  const std::ptrdiff_t of_picture = late.count(launch_call, options);
  CHECK(of_picture >= 128);
  options.emplace_back("--stats-detail");
  CHECK(late.count(launch_call, options) - of_picture < 64);
}

TEST_CASE("rays are counted of the samples of a run that a time ended, however few they were") {
  LateFault late;
  late.base = {STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml",
               "--width",
               "8",
               "-d",
               "pocl",
               "--disable",
               "SHARED_SAMPLES",  // So that a launch is of one kernel.
               "-q",
               "-o",
               "out.exr",
               "--stats",
               "stats.json",
               "--stats-detail"};
  REQUIRE(late.run({"--spp", "8"}).code == 0);  // Fills the cache of programs, and asks the canary.
  const std::string first = std::to_string(warm_up_launches / kernels_a_launch + 1);
  // Two launches take all of the time, on any machine where the start takes less than one of them: the first is of one
  // sample of all pixels, the second of one more of some.
  Json counted;
  for (int seconds = 1; seconds <= 16 && (counted.is_null() || counted.at("most_spp") < 2); seconds *= 2) {
    const Outcome outcome =
        late.run({"--time", std::to_string(2 * seconds) + "s"}, {{"STRAHL_CL_FAULT_NAME", launch_call},
                                                                 {"STRAHL_CL_FAULT_CALL", first},
                                                                 {"STRAHL_CL_FAULT_CODE", "slow"},
                                                                 {"STRAHL_CL_FAULT_TIMES", "2"},
                                                                 {"STRAHL_CL_FAULT_SECONDS", std::to_string(seconds)}});
    INFO(outcome.err);
    REQUIRE((outcome.code == 0 || outcome.code == 6));
    counted = late.stats();
  }
  REQUIRE(counted.at("ending") == "deadline");
  REQUIRE(counted.at("most_spp") == 2);
  REQUIRE(late.run({"--spp", "8", "--samples", "0:2", "--checkpoint", "c.ckpt"}).code == 0);
  const Json same = late.stats();
  CHECK(counted.at("rays").at("bounce") == same.at("rays").at("bounce"));
  CHECK(counted.at("visits") == same.at("visits"));
}

TEST_CASE("a watchdog does not count what is built and traced after the last sample") {
  const LateFault late;
  const std::vector<std::string> options{"--aov", "numeric_error", "--watchdog", "1s", "--checkpoint", "c.ckpt"};
  // The last program is that of numeric_error, in double precision.
  const Outcome slow = late.fault_in_last(
      "clBuildProgram", options,
      {{"STRAHL_CL_FAULT_CODE", "slow"}, {"STRAHL_CL_FAULT_TIMES", "1"}, {"STRAHL_CL_FAULT_SECONDS", "2"}});
  INFO(slow.err);
  CHECK(slow.code == 0);
  CHECK(fs::exists(late.folder().path("out.exr")));
  // Where it hangs, the last checkpoint is there.
  const Outcome hung =
      late.fault_in_last("clBuildProgram", options, {{"STRAHL_CL_FAULT_CODE", "hang"}}, [&late](pid_t child) {
        const std::string kept = late.folder().path("c.ckpt");
        for (int i = 0; i < 6000 && !fs::exists(kept); ++i) std::this_thread::sleep_for(5ms);
        CHECK(fs::exists(kept));
        CHECK_FALSE(fs::exists(late.folder().path("out.exr")));
        kill(child, SIGKILL);
      });
  CHECK(hung.signal == SIGKILL);
}
