// SPDX-License-Identifier: MIT
// One of several devices fails in the midst of a picture, whatever call it is that fails: it is dropped, the others do
// its part, and the picture has the bits of one device; where all fail, there is no picture (docs/reliability.md).
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <sstream>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "faults/launches.h"
#include "image/image_io.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

const char* const pocl_platform = "Portable Computing Language";

/// A scene in small, on PoCL alone and on PoCL and llvmpipe.
class SharedRender {
 public:
  SharedRender() {
    REQUIRE(run("pocl", {}).code == 0);
    picture_ = strahl::read_image(folder_.path("out.exr"));
  }

  [[nodiscard]] Outcome run(const std::string& devices, std::map<std::string, std::string> environment,
                            const std::vector<std::string>& more = {}) {
    for (const char* name : {"out.exr", "calls.log"}) fs::remove(folder_.path(name));
    environment["RUSTICL_ENABLE"] = "llvmpipe";
    environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
    environment["STRAHL_CL_FAULT_LOG"] = folder_.path("calls.log");
    std::vector<std::string> options{STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml",
                                     "--width",
                                     "12",  // llvmpipe, left alone, takes a tenth of a second for a launch of that.
                                     "--spp",
                                     "20",
                                     "-d",
                                     devices,
                                     "-q",
                                     "-o",
                                     "out.exr"};
    options.insert(options.end(), more.begin(), more.end());
    return folder_.run(options, environment);
  }

  /// Calls with PoCL's queue, in their order, of a render where it has the most of the picture.
  [[nodiscard]] std::vector<std::string> calls() {
    REQUIRE(run("pocl,llvmpipe", {{"STRAHL_CL_FAULT_QUEUE", pocl_platform}}).code == 0);
    check_picture();
    std::vector<std::string> calls;
    std::istringstream log(read_text(folder_.path("calls.log")));
    for (std::string line; std::getline(log, line);) calls.push_back(line);
    return calls;
  }

  void check_picture() {
    const strahl::Image image = strahl::read_image(folder_.path("out.exr"));
    CHECK(image.data == picture_.data);
    CHECK(image.metadata.at("rmse") == picture_.metadata.at("rmse"));
    CHECK(image.metadata.count("incomplete") == 0);
  }

  [[nodiscard]] const Folder& folder() const { return folder_; }

 private:
  Folder folder_;
  strahl::Image picture_;
};

std::map<std::string, std::string> gone_from(std::size_t call, const std::string& platform = pocl_platform) {
  return {{"STRAHL_CL_FAULT_QUEUE", platform},
          {"STRAHL_CL_FAULT_CALL", std::to_string(call)},
          {"STRAHL_CL_FAULT_CODE", "-5"}};
}

void check_dropped(SharedRender& render, const Outcome& outcome) {
  INFO(outcome.err);
  REQUIRE(outcome.signal == 0);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "strahl: warning: "));
  CHECK(contains(outcome.err, "was dropped, and the other devices did its part"));
  CHECK(contains(outcome.err, pocl_platform));
  CHECK(contains(outcome.err, "CL_OUT_OF_RESOURCES"));
  render.check_picture();
}

}  // namespace

TEST_CASE("a device that is gone at any of its calls is dropped") {
  SharedRender render;
  const std::vector<std::string> calls = render.calls();
  const std::size_t begin = first_launch(calls);
  // The first of each sort of call, and one in the midst, when some of its rows are in the film.
  std::map<std::string, std::size_t> places;
  // Those that hold a queue and let it go fail after the picture.
  for (std::size_t call = begin; call <= calls.size(); ++call)
    if (!contains(calls[call - 1], "CommandQueue")) places.try_emplace(calls[call - 1], call);
  REQUIRE(places.size() >= 5);
  places["in the midst"] = begin + (calls.size() - begin) / 3;
  for (const auto& [name, call] : places)
    for (const char* devices : {"pocl,llvmpipe", "llvmpipe,pocl"}) {
      // Which device is the first decides where the film is, not which call may fail.
      if (devices != std::string("pocl,llvmpipe") && name != "in the midst" && name != "clEnqueueReadBuffer") continue;
      INFO(devices << ", " << name << ", call " << call << " of " << calls.size());
      check_dropped(render, render.run(devices, gone_from(call)));
    }
}

TEST_CASE("a device that is gone before the first sample ends the render") {
  SharedRender render;
  const Outcome outcome = render.run("llvmpipe,pocl", gone_from(1));
  INFO(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "strahl: error: "));
  CHECK_FALSE(fs::exists(render.folder().path("out.exr")));
}

TEST_CASE("all devices gone: no picture, and each is named; the checkpoint keeps what was there") {
  SharedRender render;
  REQUIRE(render.run("pocl", {}, {"--spp", "16", "--checkpoint", "c.ckpt"}).code == 0);
  // Calls of both, from the first launch of samples on.
  REQUIRE(render.run("pocl,llvmpipe", {{"STRAHL_CL_FAULT_QUEUE", "*"}}).code == 0);
  std::vector<std::string> calls;
  std::istringstream log(read_text(render.folder().path("calls.log")));
  for (std::string line; std::getline(log, line);) calls.push_back(line);
  const std::size_t begin = first_launch(calls, 2);
  for (const std::size_t call : {begin, begin + 4, begin + 8}) {
    INFO("call " << call << " of " << calls.size());
    const Outcome outcome = render.run("pocl,llvmpipe", gone_from(call, "*"), {"--resume", "c.ckpt"});
    INFO(outcome.err);
    CHECK(outcome.signal == 0);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "strahl: error: none of 2 devices is left"));
    CHECK(contains(outcome.err, pocl_platform));
    CHECK(contains(outcome.err, "llvmpipe"));
    CHECK_FALSE(fs::exists(render.folder().path("out.exr")));
    CHECK(strahl::read_checkpoint(render.folder().path("c.ckpt")).header.least >= 16);
  }
}

TEST_CASE("a device that hangs holds up the others, until the watchdog ends that") {
  SharedRender render;
  const std::vector<std::string> calls = render.calls();
  const std::size_t call = first_launch(calls) + 1;
  REQUIRE(calls.at(call - 1) == "clFinish");
  std::map<std::string, std::string> environment = gone_from(call);
  environment["STRAHL_CL_FAULT_CODE"] = "hang";
  const Outcome outcome =
      render.run("pocl,llvmpipe", environment, {"--watchdog", "5s", "--checkpoint", "c.ckpt", "--every", "1ms"});
  INFO(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "has not come back from a launch for 5 s"));
  CHECK_FALSE(fs::exists(render.folder().path("out.exr")));
}

TEST_CASE("a device is dropped while a picture is gone on with, and what is kept is whole") {
  SharedRender render;
  const std::size_t begin = first_launch(render.calls());
  REQUIRE(render.run("pocl", {}, {"--spp", "16", "--checkpoint", "c.ckpt"}).code == 0);
  check_dropped(render, render.run("pocl,llvmpipe", gone_from(begin + 3), {"--resume", "c.ckpt", "--every", "1ms"}));
  CHECK(strahl::read_checkpoint(render.folder().path("c.ckpt")).header.least == 20);
}
