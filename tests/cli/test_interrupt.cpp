// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal: the launch under way is finished, the picture so far is written whole.
#include <sys/stat.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>
#include <vector>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;

namespace {

bool has_ended(pid_t child) {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == child;
}

/// A render of hours that is sent the signals after its first launches began, and `until_it_ends`, if it is one, again
/// and again. What tells that they did: the program's text is written just before, and a launch takes at most 0.25 s.
Outcome interrupted_render(const Folder& folder, const std::vector<int>& signals,
                           const std::vector<std::string>& more = {}, int until_it_ends = 0) {
  folder.file("scene.xml", glowing_sphere);
  const std::string started = folder.path("kernel.cl");
  std::vector<std::string> options{"scene.xml", "-o",        "out.exr",     "--width",       "256",  "--spp",
                                   "2000000",   "--sampler", "independent", "--dump-kernel", started};
  options.insert(options.end(), more.begin(), more.end());
  return folder.run(options, {}, [&](pid_t child) {
    using namespace std::chrono_literals;
    for (int wait = 0; wait < 600 && !std::filesystem::exists(started); ++wait) std::this_thread::sleep_for(100ms);
    std::this_thread::sleep_for(1s);
    for (const int signal : signals) {
      kill(child, signal);
      std::this_thread::sleep_for(10ms);  // Two at once may arrive in any order.
    }
    for (; until_it_ends != 0 && !has_ended(child); std::this_thread::sleep_for(10ms)) kill(child, until_it_ends);
  });
}

}  // namespace

TEST_CASE("an interrupted render leaves a complete picture") {
  const Folder folder;
  const auto [signal, code] =
      GENERATE(std::make_pair(SIGINT, 130), std::make_pair(SIGTERM, 143), std::make_pair(SIGHUP, 129));
  const Outcome outcome = interrupted_render(folder, {signal});
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == code);
  CHECK(contains(outcome.err, "interrupted after "));
  CHECK(folder.files() == std::vector<std::string>{"kernel.cl", "out.exr", "scene.xml"});
  const strahl::Image image = strahl::read_image(folder.path("out.exr"));
  REQUIRE(image.width == 256);
  CHECK(image.at(128, 96, 0) == Approx(4));
  CHECK(image.metadata.count("incomplete") == 1);
}

TEST_CASE("a second signal ends the process, but one that the caller ignores never does") {
  const Folder folder;
  // Nobody reads the picture, so the process is there for the second signal however soon its last launch ends. Where it
  // had no time in between, the two arrived as the first.
  REQUIRE(mkfifo(folder.path("out.exr").c_str(), 0600) == 0);
  CHECK(interrupted_render(folder, {SIGINT}, {}, SIGHUP).signal == SIGHUP);
  CHECK(folder.files() == std::vector<std::string>{"kernel.cl", "out.exr", "scene.xml"});
  for (const char* name : {"kernel.cl", "out.exr"}) std::filesystem::remove(folder.path(name));
  std::signal(SIGHUP, SIG_IGN);  // As nohup does.
  const Outcome outcome = interrupted_render(folder, {SIGINT, SIGHUP});
  std::signal(SIGHUP, SIG_DFL);
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == 130);
  CHECK(strahl::read_image(folder.path("out.exr")).width == 256);
}

TEST_CASE("a frame under way ends as soon as a picture does, and says so") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  std::chrono::steady_clock::time_point sent;
  const Outcome outcome = folder.run(
      {"scene.xml", "--frames", "9", "--time", "60s", "-o", "f.exr", "--stats", "f.json", "--dump-kernel", "kernel.cl"},
      {}, [&](pid_t child) {
        using namespace std::chrono_literals;
        for (int wait = 0; wait < 600 && !std::filesystem::exists(folder.path("kernel.cl")); ++wait)
          std::this_thread::sleep_for(100ms);
        std::this_thread::sleep_for(1s);
        sent = std::chrono::steady_clock::now();
        kill(child, SIGINT);
      });
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count() < 5);
  INFO(outcome.err);
  CHECK(outcome.code == 130);
  CHECK(contains(outcome.err, "f.0001.exr: interrupted"));
  CHECK(folder.files() == std::vector<std::string>{"f.0001.exr", "f.json", "kernel.cl", "scene.xml"});
  const strahl::Image frame = strahl::read_image(folder.path("f.0001.exr"));
  CHECK(frame.at(16, 12, 0) == Approx(4));
  CHECK(frame.metadata.count("incomplete") == 1);
  CHECK(contains(read_text(folder.path("f.json")), "\"frames\": []"));
}

TEST_CASE("a signal ends what is measured beside a complete picture, which stays one") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  // With nothing cached, building the program in double precision takes long.
  const Outcome outcome =
      folder.run({"scene.xml", "-v", "--spp", "4", "--sampler", "independent", "--width", "64", "-d", "pocl", "-o",
                  "out.exr", "--checkpoint", "c.ckpt"},
                 {{"STRAHL_CACHE_DIR", folder.path("cache")}, {"POCL_CACHE_DIR", folder.path("p")}}, [&](pid_t child) {
                   using namespace std::chrono_literals;
                   for (int wait = 0; wait < 6000 && !std::filesystem::exists(folder.path("out.exr")); ++wait)
                     std::this_thread::sleep_for(10ms);
                   kill(child, SIGINT);
                 });
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "float rounding not measured (interrupted)"));
  CHECK_FALSE(contains(outcome.err, "--resume"));
  CHECK(strahl::read_image(folder.path("out.exr")).metadata.count("incomplete") == 0);
}

TEST_CASE("an interrupted picture with -v says that rounding is not measured for that") {
  const Folder folder;
  const Outcome outcome = interrupted_render(folder, {SIGINT}, {"-v"});
  INFO(outcome.err);
  CHECK(outcome.code == 130);
  CHECK(contains(outcome.err, "float rounding not measured (interrupted)"));
}
