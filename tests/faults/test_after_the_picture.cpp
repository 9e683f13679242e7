// SPDX-License-Identifier: MIT
// What is computed once the last sample is there fails: the picture and its statistics are written without it, with a
// warning that says why.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

/// A picture without an error, so that no pilot measures its rounding at the end, if not asked for in `base`.
class LateFault {
 public:
  LateFault() { folder_.file("s.xml", glowing_sphere); }

  [[nodiscard]] Outcome run(const std::vector<std::string>& more, std::map<std::string, std::string> environment = {}) {
    for (const char* name : {"out.exr", "calls.log", "stats.json"}) fs::remove(folder_.path(name));
    environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
    environment["STRAHL_CL_FAULT_LOG"] = folder_.path("calls.log");
    std::vector<std::string> options = base;
    options.insert(options.end(), more.begin(), more.end());
    return folder_.run(options, environment);
  }

  /// How many launches there were.
  [[nodiscard]] int launches(const std::vector<std::string>& more) {
    REQUIRE(run(more).code == 0);
    std::istringstream log(read_text(folder_.path("calls.log")));
    int count = 0;
    for (std::string line; std::getline(log, line);)
      if (line == "clEnqueueNDRangeKernel") ++count;
    return count;
  }

  /// Its last launch fails.
  [[nodiscard]] Outcome fail_last_launch(const std::vector<std::string>& more) {
    REQUIRE(run(more).code == 0);
    std::istringstream log(read_text(folder_.path("calls.log")));
    std::size_t last = 0, call = 0;
    for (std::string line; std::getline(log, line);) {
      ++call;
      if (line == "clEnqueueNDRangeKernel") last = call;
    }
    REQUIRE(last > 0);
    return run(more, {{"STRAHL_CL_FAULT_CALL", std::to_string(last)}, {"STRAHL_CL_FAULT_CODE", "-5"}});
  }

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
  const auto stats = nlohmann::json::parse(read_text(late.folder().path("stats.json")));
  CHECK(stats.at("detail").is_null());
  CHECK(stats.at("rays").at("camera") == 32 * 24 * 4);
}

TEST_CASE("rays are counted in launches of their own, however the picture is divided") {
  LateFault late;
  std::vector<std::string> options{"--spp", "128", "--passes", "128", "--stats", "stats.json"};
  const int of_picture = late.launches(options);
  CHECK(of_picture >= 128);
  options.emplace_back("--stats-detail");
  CHECK(late.launches(options) - of_picture < 64);
}
