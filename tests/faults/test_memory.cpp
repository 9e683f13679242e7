// SPDX-License-Identifier: MIT
// A process that makes one picture after the other takes no more and more memory: neither the program's own nor what it
// has the drivers hold (buffers, events, kernels).
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "cli/program.h"
#include "support/needs.h"

using namespace strahl_test;

namespace {

#ifdef __SANITIZE_ADDRESS__
// Its allocator is its own.
const strahl::test::Needs needs_no_sanitizer("a program without sanitizers");
#endif

struct Line {
  long files = 0, own = 0, libraries = 0;
};

}  // namespace

TEST_CASE("many pictures in one process") {
  const Folder folder;
  const bool is_long = std::getenv("STRAHL_ALL_FAULTS") != nullptr;
  const std::string frames = is_long ? "2000" : "400";
  // Samples end each picture, so that a busy machine has the same work in it: another shape of launch would be another
  // kernel, which the driver loads and keeps.
  const std::vector<std::string> render{
      STRAHL_SOURCE_DIR "/scenes/lecture/lit.xml", "-D", "res=32", "-dpocl", "-q", "--spp=8", "--time=10s", "-of.pfm"};
  const auto with_frames = [&render](const std::string& count) {
    std::vector<std::string> options = render;
    options.insert(options.end(), {"--frames", count});
    return options;
  };
  // Fills the cache of programs: a compiler's memory is no part of this. 6: late, on a busy machine.
  const auto made = [](const Outcome& outcome) { return outcome.code == 0 || outcome.code == 6; };
  REQUIRE(made(folder.run(with_frames("1"))));
  const Outcome outcome = folder.run(with_frames(frames), {{"LD_PRELOAD", STRAHL_COUNT_MEMORY},
                                                           {"STRAHL_MEMORY_LOG", folder.path("memory.log")},
                                                           {"STRAHL_MEMORY_EVERY", "100"}});
  INFO(outcome.err);
  REQUIRE(made(outcome));
  std::istringstream log(read_text(folder.path("memory.log")));
  std::vector<Line> lines;
  for (std::string text; std::getline(log, text);) {
    std::istringstream words(text);
    Line line;
    words >> line.files >> line.own >> line.libraries;
    lines.push_back(line);
  }
  REQUIRE(lines.size() == (is_long ? 20 : 4));
  INFO("after " << lines.front().files << " and " << lines.back().files << " pictures: own " << lines.front().own
                << " and " << lines.back().own << " bytes, libraries " << lines.front().libraries << " and "
                << lines.back().libraries);
  // It counts.
  CHECK(lines.front().own > 100000);
  CHECK(lines.front().libraries > 1000000);
  CHECK(static_cast<double>(lines.back().own) < 1.01 * static_cast<double>(lines.front().own));
  CHECK(static_cast<double>(lines.back().libraries) < 1.01 * static_cast<double>(lines.front().libraries));
  if (is_long)
    WARN("own " << lines.front().own << " and " << lines.back().own << " bytes, libraries " << lines.front().libraries
                << " and " << lines.back().libraries);
}
