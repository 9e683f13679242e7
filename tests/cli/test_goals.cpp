// SPDX-License-Identifier: MIT
// --time, --max-error, --frames, --dry-run and --error-map as a user meets them: exit codes, files, what is said.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

const std::string room = STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml";

Json json_of(const Folder& folder, const std::string& name) { return Json::parse(read_text(folder.path(name))); }

}  // namespace

TEST_CASE("times that are none") {
  const Folder folder;
  for (const char* wrong : {"", "s", "-1s", "0", "1 s", "1day", "nan", "1e999"}) {
    const Outcome outcome = folder.run({"render", room, std::string("--time=") + wrong});
    INFO(wrong << ": " << outcome.err);
    CHECK(outcome.code == 2);
  }
  CHECK(folder.run({"render", room, "--frames", "2"}).code == 2);
  CHECK(folder.run({"render", room, "--frames", "2", "--time", "1s", "--error-map", "e.exr"}).code == 2);
  CHECK(folder.run({"render", room, "--frames", "2", "--time", "1s", "--stats", "-", "--stats-detail"}).code == 2);
  CHECK(folder.run({"render", room, "--time", "1s", "--passes", "3"}).code == 2);
  CHECK(folder.run({"render", room, "--max-error", "0"}).code == 2);
  CHECK(folder.run({"render", room, "--max-error", "0.1", "--no-error"}).code == 2);
}

TEST_CASE("the bill: an error with its interval and its causes") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", room, "--width", "32", "--spp", "8", "-o", "a.png", "--stats", "a.json",
                                      "--error-map", "e.exr", "-v"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  for (const char* part : {"RMSE ", "95 %", "noise ", "8-bit output ", "float rounding ", "half the noise: "})
    CHECK(contains(outcome.err, part));
  const Json error = json_of(folder, "a.json").at("error");
  CHECK(error.at("rmse_low") < error.at("rmse"));
  CHECK(error.at("rmse") < error.at("rmse_high"));
  CHECK(error.at("rmse") > error.at("budget").at("noise"));
  CHECK(error.at("budget").at("output") > 1e-4);
  CHECK(error.at("budget").at("clipping") > 0.1);  // The lamp is in sight.
  CHECK(error.at("budget").at("float_rounding") < 1e-4);
  CHECK(strahl::read_image(folder.path("e.exr")).width == 32);
  const Json seconds = json_of(folder, "a.json").at("seconds");
  double sum = 0;
  for (const auto& [phase, value] : seconds.items())
    if (phase != "total") sum += value.get<double>();
  CHECK(sum == Approx(seconds.at("total").get<double>()));
}

TEST_CASE("a map of the error that is asked for is there, or the exit code says so") {
  const Folder folder;
  folder.file("s.xml", glowing_sphere);  // Of one sample.
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"s.xml", "-d", "pocl", "-q", "-o", "a.pfm", "--error-map", "e.pfm"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.run(arguments);
  };
  const auto has = [&](const char* name) { return std::filesystem::exists(folder.path(name)); };
  for (const std::vector<std::string>& few : std::vector<std::vector<std::string>>{
           {}, {"--spp", "3"}, {"--spp", "64", "--samples", "0:2", "--checkpoint", "a.ckpt"}}) {
    const Outcome refused = run(few);
    INFO(refused.err);
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "--error-map: the error is told from 4 samples a pixel or more"));
    CHECK_FALSE(has("a.pfm"));
  }
  // Known at the end, and so is that the goal was missed.
  const Outcome black = run({"--time", "1ms"});
  INFO(black.err);
  CHECK(black.code == 1);
  CHECK(contains(black.err, "strahl: error: --error-map \"e.pfm\" is not written: a pixel has fewer than 4 samples"));
  CHECK(contains(black.err, "strahl: --time 1ms: some pixels have no sample and are black"));
  CHECK(has("a.pfm"));
  CHECK_FALSE(has("e.pfm"));
  CHECK(run({"--spp", "4"}).code == 0);
  CHECK(has("e.pfm"));
  CHECK(run({"--max-error", "1"}).code == 0);

  for (const char* range : {"0:1", "1:3"})
    REQUIRE(folder
                .run({"s.xml", "-d", "pocl", "-q", "--spp", "3", "--samples", range, "--checkpoint",
                      std::string(range).substr(0, 1) + ".ckpt"})
                .code == 0);
  const Outcome merged = folder.run({"merge", "0.ckpt", "1.ckpt", "-o", "m.pfm", "--error-map", "m-e.pfm"});
  INFO(merged.err);
  CHECK(merged.code == 1);
  CHECK(contains(merged.err, "strahl: error: --error-map \"m-e.pfm\" is not written"));
  CHECK(has("m.pfm"));
  CHECK_FALSE(has("m-e.pfm"));
}

TEST_CASE("an error that is reached, one that is not, and one that nothing tells") {
  const Folder folder;
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", room, "--width", "32", "-o", "a.exr", "--stats", "a.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.run(arguments);
  };
  CHECK(run({"--max-error", "0.5"}).code == 0);
  CHECK(json_of(folder, "a.json").at("ending") == "error");
  const Outcome missed = run({"--max-error", "1e-4", "--spp", "8"});
  CHECK(missed.code == 6);
  CHECK(contains(missed.err, "--max-error"));
  CHECK(strahl::read_image(folder.path("a.exr")).width == 32);
  // Ended before the first look at 8 samples.
  CHECK(run({"--max-error", "10", "--spp", "4"}).code == 0);
  CHECK(json_of(folder, "a.json").at("ending") == "samples");
  const Outcome unknown = run({"--max-error", "0.5", "--spp", "2"});
  CHECK(unknown.code == 6);
  CHECK(json_of(folder, "a.json").at("error").is_null());
}

TEST_CASE("less time than the start takes") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", room, "--width", "32", "--time", "1ms", "-o", "a.exr"});
  CHECK(outcome.code == 6);
  CHECK(contains(outcome.err, "at least "));
  CHECK(strahl::read_image(folder.path("a.exr")).width == 32);
}

TEST_CASE("what writing takes is measured where there is no folder for temporary files, too") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", room, "--width", "16", "--spp", "4", "--time", "60s", "-o", "a.exr"},
                                     {{"TMPDIR", folder.path("nowhere")}});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(folder.files() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("frames without a sample in some pixels are told") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", room, "--frames", "1", "--time", "0.01ms", "-o", "f.exr"});
  INFO(outcome.err);
  CHECK(outcome.code == 6);
  CHECK(contains(outcome.err, "in 1 of 1 frames some pixels have no sample"));
}

TEST_CASE("frames are held against an error, each by itself") {
  const Folder folder;
  const auto frames = [&](const std::string& error, const std::string& spp) {
    return folder.run({"render", room, "--width", "16", "--frames", "2", "--time", "5s", "--spp", spp, "--max-error",
                       error, "-q", "-o", "f.exr"});
  };
  const Outcome missed = frames("1e-6", "16");
  CHECK(missed.code == 6);
  CHECK(contains(missed.err, "strahl: --max-error 1e-06: missed in 2 of 2 frames; the largest error is 0."));
  CHECK(folder.files() == std::vector<std::string>{"f.0001.exr", "f.0002.exr"});
  const Outcome unknown = frames("10", "2");
  CHECK(unknown.code == 6);
  CHECK(contains(unknown.err, "missed in 2 of 2 frames; in 2 it is not known"));
  const Outcome reached = frames("10", "16");
  INFO(reached.err);
  CHECK(reached.code == 0);
}

TEST_CASE("frames against the clock") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", room, "--width", "16", "--frames", "3", "--time", "2s", "--spp", "4",
                                      "-o", "f.exr", "--stats", "f.json"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(folder.files() == std::vector<std::string>{"f.0001.exr", "f.0002.exr", "f.0003.exr", "f.json"});
  CHECK(json_of(folder, "f.json").at("in_time") == 3);
  const strahl::Image first = strahl::read_image(folder.path("f.0001.exr"));
  CHECK(contains(first.metadata.at("command"), "--frames 3"));
  CHECK(first.metadata.at("spp") == "4");
  CHECK(first.metadata.at("seed") != strahl::read_image(folder.path("f.0002.exr")).metadata.at("seed"));
  CHECK_FALSE(first.data == strahl::read_image(folder.path("f.0002.exr")).data);
}

TEST_CASE("rounding is not measured where that would take more than a twentieth of the run") {
  const Folder folder;
  // A cache of its own: the double program would have to be built.
  const Outcome outcome =
      folder.run({"render", room, "--width", "16", "--spp", "4", "-o", "a.exr", "--stats", "a.json"},
                 {{"STRAHL_CACHE_DIR", folder.path("cache")}});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.err, "float rounding not measured"));
  CHECK(json_of(folder, "a.json").at("error").at("budget").at("float_rounding").is_null());
}

TEST_CASE("a prediction has intervals and writes no picture") {
  const Folder folder;
  const Outcome outcome =
      folder.run({"render", room, "--width", "32", "--spp", "64", "--dry-run", "--stats", "d.json"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "samples  64 a pixel"));
  CHECK(contains(outcome.out, "90 of 100"));
  CHECK(folder.files() == std::vector<std::string>{"d.json"});
  const Outcome piped = folder.run({"render", room, "--width", "32", "--spp", "64", "--dry-run", "--stats", "-"});
  CHECK(Json::parse(piped.out).at("predicted").at("spp") == 64);
  const Json predicted = json_of(folder, "d.json").at("predicted");
  for (const std::string what : {"seconds", "spp", "rmse"}) {
    CHECK(predicted.at(what) > 0);
    CHECK(predicted.at(what + "_interval").at("low") <= predicted.at(what));
    CHECK(predicted.at(what) <= predicted.at(what + "_interval").at("high"));
  }
  CHECK(json_of(folder, "d.json").at("pilot").at("seconds") > 0);
}

TEST_CASE("a prediction says that it is without numeric_error") {
  const Folder folder;
  const Outcome outcome = folder.run(
      {"render", room, "-d", "pocl", "--width", "32", "--spp", "8", "--dry-run", "--aov", "depth,numeric_error"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "without --aov numeric_error"));
  CHECK_FALSE(contains(folder.run({"render", room, "-d", "pocl", "--width", "32", "--spp", "8", "--dry-run"}).err,
                       "numeric_error"));
}

TEST_CASE("an error of samples that are not finite is not reached") {
  const Folder folder;
  folder.file("bright.xml", R"(<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="2"/></integrator>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="16"/></film>
  </sensor>
  <emitter type="constant"><rgb name="radiance" value="3e38, 1, 1"/></emitter>
  <shape type="sphere">
    <bsdf type="diffuse"><rgb name="reflectance" value="0.9, 0.9, 0.9"/></bsdf>
    <emitter type="area"><rgb name="radiance" value="3e38, 2, 1"/></emitter>
  </shape>
</scene>
)");
  const Outcome outcome = folder.run({"bright.xml", "--max-error", "1e38", "-o", "a.exr", "--stats", "a.json"});
  INFO(outcome.err);
  CHECK(outcome.code == 6);
  CHECK(contains(outcome.err, "--max-error 1e+38: not known, samples were not finite"));
  CHECK(json_of(folder, "a.json").at("saturated_samples") > 0);
  CHECK(json_of(folder, "a.json").at("error").is_null());
  // Nothing else would end it: it ends where it first looks.
  CHECK(json_of(folder, "a.json").at("spp") == 8);
  CHECK(json_of(folder, "a.json").at("ending") == "unknown error");
  // A prediction says the same, and that few samples are another reason.
  const Outcome predicted = folder.run({"bright.xml", "--spp", "64", "--dry-run"});
  CHECK(predicted.code == 0);
  CHECK(contains(predicted.out, "error    not known: samples of the pilot were not finite"));
  const Outcome endless = folder.run({"bright.xml", "--max-error", "1", "--dry-run", "--stats", "d.json"});
  CHECK(endless.code == 0);
  CHECK(contains(endless.out, "time     not known: samples of the pilot were not finite"));
  CHECK(json_of(folder, "d.json").at("predicted").at("seconds").is_null());
  CHECK(json_of(folder, "d.json").at("predicted").at("seconds_interval").is_null());
  CHECK(json_of(folder, "d.json").at("pilot").at("seconds") < 10);
  CHECK(contains(folder.run({"render", room, "--width", "16", "--spp", "2", "--dry-run"}).out,
                 "error    not known: a pixel has fewer than 4 samples"));
}

TEST_CASE("the scene's own number of samples is refused only where it is the goal, and named") {
  const Folder folder;
  std::string text = glowing_sphere;
  const std::string film = "<film type";
  text.insert(text.find(film),
              "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"2000000\"/></sampler>");
  folder.file("many.xml", text);
  // Of light paths in 320 x 240 pixels a film holds 111848 a pixel.
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"many.xml", "--integrator", "ptracer", "--width", "320", "-o", "a.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.run(arguments);
  };
  const Outcome refused = run({});
  INFO(refused.err);
  CHECK(refused.code == 3);
  CHECK(contains(refused.err, "many.xml:6:5: error: "));
  CHECK(contains(refused.err, "sample_count is 2000000"));
  const Outcome stated = run({"--spp", "1000000"});
  CHECK(stated.code == 2);
  CHECK(contains(stated.err, "--spp 1000000: the film holds 1 to"));
  CHECK(run({"--spp", "1"}).code == 0);
  CHECK(run({"--max-error", "1e9", "--spp", "4"}).code == 0);
  CHECK(contains(run({"--time", "1ms"}).err, "--time 1ms:"));  // Missed, not refused.
}
