// SPDX-License-Identifier: MIT
// Copies of the film for checkpoints: where there is no memory for one the render goes on without, and a resumed render
// takes the memory of the film that it has read.
#include <catch2/catch.hpp>
#include <filesystem>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "image/image_io.h"
#include "support/needs.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

#ifdef __SANITIZE_ADDRESS__
// Its allocator is its own.
const strahl::test::Needs needs("a program without sanitizers");
#endif

/// Of 61 x 61 pixels the film's words take as many bytes as nothing else does.
class SmallRender {
 public:
  [[nodiscard]] Outcome run(const std::vector<std::string>& more, int refused_from = 0) const {
    std::vector<std::string> options{
        STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "61", "-d", "pocl", "--no-progress"};
    options.insert(options.end(), more.begin(), more.end());
    if (refused_from == 0) return folder_.run(options);
    return folder_.run(options, {{"LD_PRELOAD", STRAHL_FAIL_MEMORY},
                                 {"STRAHL_FAULT_BYTES", std::to_string(61 * 61 * 208)},
                                 {"STRAHL_FAULT_FIRST", std::to_string(refused_from)}});
  }
  [[nodiscard]] bool has(const std::string& name) const { return fs::exists(folder_.path(name)); }
  [[nodiscard]] strahl::Image picture(const std::string& name) const { return strahl::read_image(folder_.path(name)); }
  [[nodiscard]] int least_samples(const std::string& name) const {
    return strahl::read_checkpoint(folder_.path(name)).header.least;
  }

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("no memory for a checkpoint's copy is a warning, and the picture is there") {
  const SmallRender render;
  REQUIRE(render.run({"--spp", "64", "-o", "one.exr"}).code == 0);
  const Outcome outcome = render.run(
      {"--spp", "64", "-o", "out.exr", "--checkpoint", "c.ckpt", "--every", "1ms", "--snapshot-every", "1ms"}, 1);
  INFO(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "strahl: warning: cannot write \"c.ckpt\": no memory is left for a copy of the film"));
  CHECK(contains(outcome.err, "strahl: warning: cannot write \"out.snapshot.exr\": no memory"));
  CHECK(contains(outcome.err, "strahl: error: cannot write \"c.ckpt\": no memory"));
  CHECK_FALSE(render.has("c.ckpt"));
  CHECK((render.picture("out.exr").data == render.picture("one.exr").data));
}

TEST_CASE("a resumed render holds no film more than the first one") {
  const SmallRender render;
  REQUIRE(render.run({"--spp", "40", "-o", "one.exr"}).code == 0);
  REQUIRE(render.run({"--spp", "32", "-o", "out.exr", "--checkpoint", "c.ckpt"}, 2).code == 0);
  for (const char* every : {"1h", "1ms"}) {
    const Outcome outcome = render.run({"--spp", "40", "-o", "out.exr", "--resume", "c.ckpt", "--every", every}, 2);
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(render.least_samples("c.ckpt") == 40);
  }
  CHECK((render.picture("out.exr").data == render.picture("one.exr").data));
}
