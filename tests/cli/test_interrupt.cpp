// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal: the launch under way is finished, the picture so far is written whole.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;

namespace {

/// A render of hours that is sent `signal` after its first launches began. What tells that they did: the program's text
/// is written just before, and a launch takes at most 0.25 s.
Outcome interrupted_render(const Folder& folder, int signal) {
  folder.file("scene.xml", glowing_sphere);
  const std::string started = folder.path("kernel.cl");
  return folder.run({"scene.xml", "-o", "out.exr", "--width", "256", "--spp", "2000000", "--sampler", "independent",
                     "--dump-kernel", started},
                    {}, [&](pid_t child) {
                      using namespace std::chrono_literals;
                      for (int wait = 0; wait < 600 && !std::filesystem::exists(started); ++wait)
                        std::this_thread::sleep_for(100ms);
                      std::this_thread::sleep_for(1s);
                      kill(child, signal);
                    });
}

}  // namespace

TEST_CASE("an interrupted render leaves a complete picture") {
  const Folder folder;
  const auto [signal, code] =
      GENERATE(std::make_pair(SIGINT, 130), std::make_pair(SIGTERM, 143), std::make_pair(SIGHUP, 129));
  const Outcome outcome = interrupted_render(folder, signal);
  INFO(outcome.err);
  CHECK(outcome.signal == 0);
  CHECK(outcome.code == code);
  CHECK(contains(outcome.err, "interrupted"));
  CHECK(folder.files() == std::vector<std::string>{"kernel.cl", "out.exr", "scene.xml"});
  const strahl::Image image = strahl::read_image(folder.path("out.exr"));
  REQUIRE(image.width == 256);
  CHECK(image.at(128, 96, 0) == Approx(4));
  CHECK(image.metadata.count("incomplete") == 1);
}
