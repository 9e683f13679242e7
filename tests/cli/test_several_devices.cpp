// SPDX-License-Identifier: MIT
// `-d A,B`: the picture and the told error of one device, with each goal, kept, gone on with, in parts; and what is
// refused.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.h"
#include "cli/same_picture.h"
#include "image/image_io.h"

using namespace strahl_test;

namespace {

const std::string both = "pocl,llvmpipe";

/// Of a small picture on these devices; mesh and lamp, so that the devices pack what is not alike.
Outcome render_on(const Folder& folder, const std::string& devices, std::vector<std::string> more) {
  more.insert(more.begin(), {STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "24", "-d", devices,
                             "--no-progress", "--brief"});
  return folder.run(more, {{"RUSTICL_ENABLE", "llvmpipe"}});
}

void make_on(const Folder& folder, const std::string& devices, const std::vector<std::string>& more) {
  const Outcome outcome = render_on(folder, devices, more);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK_FALSE(contains(outcome.err, "warning"));
}

}  // namespace

TEST_CASE("two devices make the picture of one, and say who did what") {
  const Folder folder;
  const std::vector<std::string> options{"--spp", "16", "--aov", "normal,shape_id"};
  const auto with = [&options](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    return more;
  };
  make_on(folder, "pocl", with({"-o", "one.exr", "--stats", "one.json"}));
  make_on(folder, both, with({"-o", "two.exr", "--stats", "two.json"}));
  make_on(folder, "llvmpipe,pocl", with({"-o", "turned.exr"}));
  require_same_picture(folder, "one.exr", "two.exr");
  require_same_picture(folder, "one.exr", "turned.exr");
  CHECK(nlohmann::json::parse(read_text(folder.path("one.json"))).at("shares").is_null());
  const auto shares = nlohmann::json::parse(read_text(folder.path("two.json"))).at("shares");
  REQUIRE(shares.size() == 2);
  CHECK(contains(shares[0].at("device"), "Portable Computing Language"));
  CHECK(contains(shares[1].at("device"), "llvmpipe"));
  CHECK(shares[0].at("samples").get<int>() + shares[1].at("samples").get<int>() == 24 * 24 * 16);
  CHECK(shares[0].at("seconds") > 0);
  CHECK(shares[0].at("fault").is_null());
  CHECK(contains(strahl::read_image(folder.path("two.exr")).metadata.at("device"), "llvmpipe"));
}

TEST_CASE("a name whose bracket has a comma is one device") {
  const Folder folder;
  const Outcome outcome = render_on(folder, "no such (device, nor this), pocl", {"--spp", "1", "-o", "x.exr"});
  INFO(outcome.err);
  CHECK(outcome.code == 4);
  CHECK(contains(outcome.err, "\"no such (device, nor this)\""));
}

TEST_CASE("a checkpoint of one goes on with two, and of two with one") {
  const Folder folder;
  make_on(folder, "pocl", {"--spp", "40", "-o", "whole.exr"});
  const bool two_first = GENERATE(true, false);
  const std::string first = two_first ? both : "pocl", then = two_first ? "pocl" : both;
  make_on(folder, first, {"--spp", "32", "-o", "part.exr", "--checkpoint", "c.ckpt", "--every", "1ms"});
  // --spp 40 has the division of 32.
  make_on(folder, then, {"--spp", "40", "-o", "sum.exr", "--resume", "c.ckpt"});
  require_same_picture(folder, "whole.exr", "sum.exr");
}

TEST_CASE("interrupted in its midst, it goes on") {
  const Folder folder;
  make_on(folder, "pocl", {"--spp", "1024", "-o", "whole.exr"});
  const Outcome stopped =
      folder.run({STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml", "--width", "24", "-d", both, "-q", "--spp",
                  "1024", "-o", "part.exr", "--checkpoint", "c.ckpt", "--every", "1ms"},
                 {{"RUSTICL_ENABLE", "llvmpipe"}}, [&](pid_t child) {
                   for (int i = 0; i < 60000 && !std::filesystem::exists(folder.path("c.ckpt")); ++i)
                     std::this_thread::sleep_for(std::chrono::milliseconds(1));
                   kill(child, SIGINT);
                 });
  INFO(stopped.err);
  REQUIRE(stopped.code == 130);
  CHECK(strahl::read_image(folder.path("part.exr")).metadata.count("incomplete") == 1);
  make_on(folder, both, {"--spp", "1024", "-o", "sum.exr", "--resume", "c.ckpt"});
  require_same_picture(folder, "whole.exr", "sum.exr");
}

TEST_CASE("parts of samples by one and by two add up") {
  const Folder folder;
  make_on(folder, "pocl", {"--spp", "24", "-o", "whole.exr"});
  make_on(folder, both, {"--spp", "24", "--samples", "0:10", "--checkpoint", "a.ckpt"});
  make_on(folder, "pocl", {"--spp", "24", "--samples", "10:11", "--checkpoint", "b.ckpt"});
  make_on(folder, both, {"--spp", "24", "--samples", "11:24", "--checkpoint", "c.ckpt"});
  const Outcome merged = folder.run({"merge", "a.ckpt", "b.ckpt", "c.ckpt", "-o", "sum.exr", "-q"});
  INFO(merged.err);
  REQUIRE(merged.code == 0);
  require_same_picture(folder, "whole.exr", "sum.exr");
}

TEST_CASE("an error or a time as the goal") {
  const Folder folder;
  make_on(folder, "pocl", {"--max-error", "0.1", "-o", "one.exr"});
  make_on(folder, both, {"--max-error", "0.1", "-o", "two.exr"});
  require_same_picture(folder, "one.exr", "two.exr");
  // 6: late. A busy machine may be, and the picture is there all the same.
  const Outcome timed = render_on(folder, both, {"--time", "3s", "-o", "timed.exr", "--stats", "timed.json"});
  INFO(timed.err);
  CHECK((timed.code == 0 || timed.code == 6));
  const auto stats = nlohmann::json::parse(read_text(folder.path("timed.json")));
  CHECK(stats.at("ending") == "deadline");
  CHECK(stats.at("least_spp") > 0);
  CHECK(strahl::read_image(folder.path("timed.exr")).width == 24);
}

TEST_CASE("what several devices cannot do is refused") {
  const Folder folder;
  const auto refused = [&folder](const std::string& devices, const std::vector<std::string>& more, int code,
                                 const std::string& word) {
    std::vector<std::string> all{"--spp", "1", "-o", "x.exr"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = render_on(folder, devices, all);
    INFO(outcome.err);
    CHECK(outcome.code == code);
    CHECK(contains(outcome.err, word));
    CHECK(folder.files().empty());
  };
  refused("pocl,pocl", {}, 2, "twice");
  refused("0,0:0", {}, 2, "twice");
  refused("pocl,", {}, 2, "a device's name is empty");
  refused(",", {}, 2, "a device's name is empty");
  refused("pocl,no-such-device", {}, 4, "no-such-device");
  refused(both, {"--precision", "stable"}, 2, "robust and double");
  refused(both, {"--precision", "fast"}, 2, "robust and double");
  refused(both, {"--precision", "double"}, 4, "fp64");
  refused(both, {"--frames", "2", "--time", "1s"}, 2, "--frames renders on one device");
  refused(both, {"--dry-run"}, 2, "--dry-run predicts");
}
