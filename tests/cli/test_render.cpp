// SPDX-License-Identifier: MIT
// `strahl render` on a device: the files it leaves and what it says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
using strahl::Image;

namespace {

/// Runs `strahl scene.xml MORE`; must succeed.
Outcome render(const Folder& folder, const std::vector<std::string>& more) {
  folder.file("scene.xml", glowing_sphere);
  std::vector<std::string> arguments{"scene.xml"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return outcome;
}

}  // namespace

TEST_CASE("without -o the scene's name gets .png") {
  const Folder folder;
  const Outcome outcome = render(folder, {});
  CHECK(folder.files() == std::vector<std::string>{"scene.png", "scene.xml"});
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "\n  time     "));
  CHECK(contains(outcome.err, "scene.png 32×24 · 1 spp"));
}

TEST_CASE("-q says nothing, -v more") {
  const Folder folder;
  CHECK(render(folder, {"-q"}).err.empty());
  const Outcome verbose = render(folder, {"-v"});
  for (const char* part : {"device ", "program ", "launches "}) CHECK(contains(verbose.err, part));
}

TEST_CASE("notes on the scene are told with -v alone, and --sensor chooses its camera") {
  const Folder folder;
  std::string text = glowing_sphere;
  text.replace(text.find("</scene>"), 0,
               "<sensor type=\"perspective\" id=\"far\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"8\"/>"
               "<integer name=\"height\" value=\"5\"/></film></sensor>");
  folder.file("two.xml", text);
  const std::vector<std::string> plain{"two.xml", "-d", "pocl", "-o", "x.pfm"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = plain;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.code == 0);
    return outcome.err;
  };
  CHECK_FALSE(contains(with({}), "note: "));
  CHECK(contains(with({"-v"}), "note: the first <sensor> is used; this one is left out (--sensor far takes it)"));
  CHECK(strahl::read_image(folder.path("x.pfm")).width == 32);
  CHECK_FALSE(contains(with({"-v", "--sensor", "far"}), "note: "));
  CHECK(strahl::read_image(folder.path("x.pfm")).width == 8);
}

TEST_CASE("EXR and PFM keep linear values") {
  const Folder folder;
  for (const char* name : {"out.exr", "out.pfm"}) {
    render(folder, {"-o", name});
    const Image image = strahl::read_image(folder.path(name));
    REQUIRE(image.width == 32);
    REQUIRE(image.height == 24);
    CHECK(image.at(16, 12, 0) == 4.0F);
    CHECK(image.at(16, 12, 1) == 2.0F);
    CHECK(image.at(16, 12, 2) == 1.0F);
    CHECK(image.at(0, 0, 0) == 0.0F);
  }
}

TEST_CASE("clipped pixels are counted; a lamp in sight is no reason for another exposure") {
  const Folder folder;
  const std::string bill = render(folder, {"--stats", "stats.json"}).err;
  CHECK(contains(bill, "  clipped  "));
  CHECK(contains(bill, "% of the pixels are brighter than white"));
  CHECK_FALSE(contains(bill, "--exposure"));
  CHECK_FALSE(contains(bill, "highlights"));
  CHECK(contains(read_text(folder.path("stats.json")), "\"clipped_pixels\": 0."));
  CHECK_FALSE(contains(render(folder, {"--exposure", "-2"}).err, "clipped"));
  const Image image = strahl::read_image(folder.path("scene.png"));
  CHECK(image.at(16, 12, 0) == Approx(1.0).margin(0.01));
  CHECK(image.at(16, 12, 2) == Approx(0.25).margin(0.01));
}

TEST_CASE("the bill has a line for each question; --brief closes with one") {
  const Folder folder;
  const std::string bill = render(folder, {"--spp", "4"}).err;
  for (const char* part : {"\n  time     ", "\n  error    ", "\n  clipped  "}) CHECK(contains(bill, part));
  std::istringstream lines(bill);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 160);
  const std::string brief = render(folder, {"--brief", "--no-progress"}).err;
  CHECK(std::count(brief.begin(), brief.end(), '\n') == 1);
  CHECK(contains(brief, "scene.png · "));
}

TEST_CASE("size, crop and pixel") {
  const Folder folder;
  render(folder, {"--width", "64", "-o", "wide.exr"});
  const Image wide = strahl::read_image(folder.path("wide.exr"));
  CHECK(wide.width == 64);
  CHECK(wide.height == 48);  // The aspect ratio stays.
  render(folder, {"--width", "10", "--height", "30", "-o", "tall.exr"});
  CHECK(strahl::read_image(folder.path("tall.exr")).height == 30);

  render(folder, {"-o", "all.exr", "--integrator", "normals"});
  render(folder, {"-o", "part.exr", "--integrator", "normals", "--crop", "10,8,20,15"});
  const Image all = strahl::read_image(folder.path("all.exr"));
  const Image part = strahl::read_image(folder.path("part.exr"));
  REQUIRE(part.width == 10);
  REQUIRE(part.height == 7);
  bool same = true;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 10; ++x)
      for (int c = 0; c < 3; ++c) same = same && part.at(x, y, c) == all.at(x + 10, y + 8, c);
  CHECK(same);

  const Outcome pixel = render(folder, {"--pixel", "16,12"});
  CHECK(pixel.out == "4 2 1\n");
  CHECK_FALSE(std::filesystem::exists(folder.path("scene.png")));
  render(folder, {"--pixel", "16,12", "-o", "one.exr"});
  CHECK(strahl::read_image(folder.path("one.exr")).width == 1);
}

TEST_CASE("AOVs: layers of an EXR, files beside a PNG") {
  const Folder folder;
  const std::string list = "depth,normal,geo_normal,position,uv,shape_id,primitive_id,numeric_error";
  render(folder, {"-o", "out.exr", "--aov", list});
  const Image layers = strahl::read_image(folder.path("out.exr"));
  const auto channel = [&](const std::string& name) {
    const auto found = std::find(layers.channels.begin(), layers.channels.end(), name);
    INFO(name);
    REQUIRE(found != layers.channels.end());
    return static_cast<int>(found - layers.channels.begin());
  };
  CHECK(layers.at(16, 12, channel("R")) == 4.0F);
  CHECK(layers.at(16, 12, channel("normal.Z")) == Approx(1).margin(0.02));
  CHECK(layers.at(16, 12, channel("position.Z")) == Approx(1).margin(0.02));
  CHECK(layers.at(16, 12, channel("numeric_error.ULP")) <= 0.51F);

  render(folder, {"-o", "out.png", "--aov", list});
  for (const char* name :
       {"depth", "normal", "geo_normal", "position", "uv", "shape_id", "primitive_id", "numeric_error"}) {
    INFO(name);
    const Image layer = strahl::read_image(folder.path(std::string("out.") + name + ".png"));
    CHECK(layer.width == 32);
    CHECK(std::any_of(layer.data.begin(), layer.data.end(), [](float value) { return value > 0; }));
    CHECK(std::all_of(layer.data.begin(), layer.data.end(), [](float value) { return value <= 1; }));
  }
  // Towards the camera: 0.5 + 0.5 (0, 0, 1).
  const Image normal = strahl::read_image(folder.path("out.normal.png"));
  CHECK(normal.at(16, 12, 2) == Approx(1).margin(0.02));
  CHECK(normal.at(16, 12, 0) == Approx(0.5).margin(0.05));
  CHECK(normal.at(0, 0, 2) == 0);
}

TEST_CASE("a depth picture is scaled in a PNG, and kept in an EXR") {
  const Folder folder;
  const Outcome png = render(folder, {"--integrator", "depth", "--spp", "16"});
  CHECK(contains(png.err, "divided by the largest"));
  const Image scaled = strahl::read_image(folder.path("scene.png"));
  CHECK(*std::max_element(scaled.data.begin(), scaled.data.end()) == 1.0F);
  render(folder, {"--integrator", "depth", "--spp", "16", "-o", "depth.exr"});
  const Image depth = strahl::read_image(folder.path("depth.exr"));
  CHECK(depth.at(16, 12, 0) == Approx(4).margin(0.05));

  // What rounding to its codes has cost the file, as lengths.
  const double white = std::stod(scaled.metadata.at("depth.white"));
  double squares = 0;
  for (std::size_t i = 0; i < depth.data.size(); ++i)
    squares += std::pow(white * static_cast<double>(scaled.data[i]) - static_cast<double>(depth.data[i]), 2);
  const double rmse = std::sqrt(squares / static_cast<double>(depth.data.size()));
  CHECK(rmse > 0.001);
  render(folder, {"--integrator", "depth", "--spp", "16", "--stats", "stats.json"});
  const auto stats = nlohmann::json::parse(read_text(folder.path("stats.json")));
  CHECK(stats.at("error").at("budget").at("output").get<double>() == Approx(rmse).epsilon(0.01));
}

TEST_CASE("the picture says how it came to be") {
  const Folder folder;
  render(folder, {"-o", "out.exr", "--spp", "3", "--sampler", "independent", "--seed", "11"});
  const auto metadata = strahl::read_image(folder.path("out.exr")).metadata;
  const auto has = [&](const std::string& key, const std::string& value) {
    INFO(key);
    REQUIRE(metadata.count(key) == 1);
    CHECK(metadata.at(key) == value);
  };
  has("command", "strahl scene.xml -o out.exr --spp 3 --sampler independent --seed 11");
  has("scene", "scene.xml");
  has("spp", "3");
  has("seed", "11");
  has("precision", "robust");
  has("Software", "strahl " STRAHL_VERSION);
  CHECK_FALSE(metadata.at("device").empty());
}

TEST_CASE("what is disabled is missing, and the picture and its statistics say so") {
  const Folder folder;
  render(folder, {"-o", "out.exr", "--disable", "EMISSION", "--disable", "TWOSIDED", "--stats", "stats.json"});
  const Image image = strahl::read_image(folder.path("out.exr"));
  CHECK(*std::max_element(image.data.begin(), image.data.end()) == 0);
  CHECK(image.metadata.at("disabled") == "EMISSION, TWOSIDED");
  CHECK(contains(read_text(folder.path("stats.json")), "\"disabled\": [\n    \"EMISSION\",\n    \"TWOSIDED\"\n  ]"));
}

TEST_CASE("how it is computed does not change the picture", "[slow]") {
  const Folder folder;
  const std::vector<std::string> picture{"--integrator", "normals", "--spp", "6", "--sampler", "independent", "-o"};
  const auto bytes = [&](const std::vector<std::string>& how) {
    std::vector<std::string> arguments = picture;
    arguments.push_back("out.pfm");
    arguments.insert(arguments.end(), how.begin(), how.end());
    render(folder, arguments);
    return read_text(folder.path("out.pfm"));
  };
  const std::string first = bytes({});
  REQUIRE_FALSE(first.empty());
  for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{{"--lanes", "1"},
                                                                                   {"--lanes", "8"},
                                                                                   {"--lanes", "16"},
                                                                                   {"--work-group", "8x8"},
                                                                                   {"--work-group", "1"},
                                                                                   {"--passes", "3"},
                                                                                   {"--generic"},
                                                                                   {"--no-progress"},
                                                                                   {"--aov", "depth"}}) {
    INFO(how.front() << ' ' << how.back());
    CHECK(bytes(how) == first);
  }
  CHECK(bytes({"--seed", "1"}) != first);
}

TEST_CASE("the program's text is written as it is built") {
  const Folder folder;
  render(folder, {"--dump-kernel", "kernel.cl"});
  CHECK(contains(read_text(folder.path("kernel.cl")), "kernel"));
}
