// SPDX-License-Identifier: MIT
// .vol files and the media that they fill: parameters of Mitsuba 3 and 0.x, faults.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "errors.h"
#include "scene/scene_text.h"
#include "scene/volumes/vol_reader.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string header(std::int32_t encoding, std::int32_t width, std::int32_t height, std::int32_t depth,
                   std::int32_t channels) {
  std::string bytes = "VOL\x03";
  for (const std::int32_t word : {encoding, width, height, depth, channels}) append(bytes, word);
  for (const float side : {-1.F, -2.F, -3.F, 1.F, 2.F, 3.F}) append(bytes, side);
  return bytes;
}

std::string floats(std::int32_t width, std::int32_t height, std::int32_t depth, const std::vector<float>& values) {
  std::string bytes = header(1, width, height, depth, 1);
  for (const float value : values) append(bytes, value);
  return bytes;
}

struct VolumeFolder : SceneFolder {
  VolumeFolder() { write("a.vol", floats(2, 1, 3, {0, 1, 2, 3, 4, 0.1F})); }
  [[nodiscard]] LoadedScene load(const std::string& medium, const std::string& version = "3.0.0") const {
    return load_scene(write("scene.xml", "<scene version=\"" + version +
                                             "\">\n<shape type=\"sphere\"><medium name=\"interior\" " + medium +
                                             "</medium></shape>\n<sensor type=\"perspective\"/></scene>\n"));
  }
  [[nodiscard]] std::string fault(const std::string& bytes) const {
    try {
      static_cast<void>(read_vol(write("b.vol", bytes)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

std::string grid(const std::string& name, const std::string& parameters = "") {
  return "<volume name=\"" + name + "\" type=\"gridvolume\"><string name=\"filename\" value=\"a.vol\"/>" + parameters +
         "</volume>";
}

TEST_CASE("a .vol has its texels, x first, and its box") {
  const VolumeFolder folder;
  const VolumeGrid grid = read_vol(folder.path("a.vol"));
  CHECK(grid.texels.width == 2);
  CHECK(grid.height == 1);
  CHECK(grid.depth == 3);
  CHECK(grid.texels.is_grey);
  CHECK(grid.texels.reals == std::vector<float>{0, 1, 2, 3, 4, 0.1F});
  CHECK(grid.largest.g == 4);
  CHECK(grid.low.y == -2);
  CHECK(grid.high.z == 3);
  const std::string codes("\xff\0\x33\0\0\0", 6);
  const VolumeGrid bytes = read_vol(folder.write("b.vol", header(3, 1, 2, 1, 3) + codes));
  CHECK_FALSE(bytes.texels.is_grey);
  CHECK(bytes.largest.r == 1);
  CHECK(bytes.largest.b == Approx(0.2));
  CHECK(read_vol(folder.write("c.vol", floats(2, 1, 1, {-1, 2}))).texels.repaired == 1);
}

TEST_CASE("what is no .vol says why") {
  const VolumeFolder folder;
  CHECK_THAT(folder.fault("VOL"), Contains("b.vol\" is not a .vol file of version 3"));
  CHECK_THAT(folder.fault("VOL\x03"), Contains("ends within its header of 48 bytes"));
  CHECK_THAT(folder.fault(header(2, 1, 1, 1, 1)), Contains("encoding 2; 1 (float32) and 3 (bytes)"));
  CHECK_THAT(folder.fault(header(1, 1, 1, 1, 4)), Contains("4 channels"));
  CHECK_THAT(folder.fault(header(1, 1 << 30, 1 << 30, 1 << 30, 1)), Contains("a grid has at most"));
  CHECK_THAT(folder.fault(header(1, 0, 1, 1, 1)), Contains("0 x 1 x 1 texels"));
  CHECK_THAT(folder.fault(header(1, 10, 10, 10, 1)), Contains("has 48 bytes; its header promises 10 x 10 x 10"));
  for (const int axis : {0, 1, 2}) {
    const auto side = [&](int which) { return which == axis ? (1 << 24) + 1 : 1; };
    CHECK_THAT(folder.fault(header(3, side(0), side(1), side(2), 1)),
               Contains("a side of a grid has at most 16777216"));
  }
}

TEST_CASE("a heterogeneous medium has Mitsuba's parameters") {
  const VolumeFolder folder;
  const LoadedScene loaded =
      folder.load("type=\"heterogeneous\">" +
                  grid("sigma_t",
                       "<string name=\"filter_type\" value=\"nearest\"/><string name=\"wrap_mode\" value=\"mirror\"/>"
                       "<boolean name=\"use_grid_bbox\" value=\"true\"/>"
                       "<transform name=\"to_world\"><scale value=\"2\"/></transform>") +
                  "<volume name=\"albedo\" type=\"constvolume\"><rgb name=\"value\" value=\".1 .2 .3\"/></volume>"
                  "<float name=\"scale\" value=\"5\"/>");
  CHECK(loaded.warnings.empty());
  const Medium& medium = loaded.scene.media.at(0);
  REQUIRE(medium.is_heterogeneous());
  CHECK(medium.sigma_t.value.g == 5);
  CHECK(medium.sigma_t.largest().g == 20);
  CHECK(medium.sigma_t.filter == TextureFilter::nearest);
  CHECK(medium.sigma_t.wrap == TextureWrap::mirror);
  CHECK(medium.sigma_t.world_from_cube.point({0, 0, 0}).y == -4);
  CHECK(medium.sigma_t.world_from_cube.point({1, 1, 1}).z == 6);
  CHECK(medium.albedo.value.b == 0.3);
  CHECK_FALSE(medium.albedo.grid);
}

TEST_CASE("a heterogeneous medium without a grid fills the unit cube") {
  const VolumeFolder folder;
  const LoadedScene loaded = folder.load("type=\"heterogeneous\"><float name=\"sigma_t\" value=\"3\"/>");
  REQUIRE(loaded.scene.media.at(0).is_heterogeneous());
  CHECK(loaded.scene.media.at(0).sigma_t.largest().r == 3);
}

TEST_CASE("Mitsuba 0.x says density, and its grids fill their boxes") {
  const VolumeFolder folder;
  const LoadedScene loaded =
      folder.load("type=\"heterogeneous\"><string name=\"method\" value=\"woodcock\"/>" + grid("density"), "0.6.0");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.media.at(0).sigma_t.world_from_cube.point({0, 0, 0}).z == -3);
}

TEST_CASE("a box that is no box is refused") {
  const VolumeFolder folder;
  for (const float side : {std::nanf(""), -1.F, std::numeric_limits<float>::infinity()}) {
    std::string bytes = floats(2, 1, 1, {0, 1});
    for (const std::size_t at : {28U, 40U}) std::memcpy(bytes.data() + at, &side, sizeof side);
    folder.write("a.vol", bytes);
    CHECK_THROWS_WITH(
        folder.load("type=\"heterogeneous\">" + grid("sigma_t", "<boolean name=\"use_grid_bbox\" value=\"true\"/>")),
        Contains("must be finite and not singular"));
    CHECK_NOTHROW(folder.load("type=\"heterogeneous\">" + grid("sigma_t")));
  }
}

TEST_CASE("sigma_s does not take the place of a grid") {
  const VolumeFolder folder;
  const LoadedScene loaded =
      folder.load("type=\"heterogeneous\"><float name=\"sigma_s\" value=\"1\"/>" + grid("sigma_t"));
  CHECK(loaded.scene.media.at(0).sigma_t.largest().r == 4);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK_THAT(loaded.warnings[0].message, Contains("sigma_s"));
}

TEST_CASE("a homogeneous medium is given by one pair of parameters") {
  const VolumeFolder folder;
  const auto number = [](const std::string& name) { return "<float name=\"" + name + "\" value=\".5\"/>"; };
  const auto load = [&](const std::string& inside) { return folder.load("type=\"homogeneous\">" + inside); };
  CHECK(load(number("sigma_t") + number("albedo")).warnings.empty());
  const LoadedScene apart = load(number("sigma_s") + number("sigma_a") + number("scale"));
  CHECK(apart.warnings.empty());
  CHECK(apart.scene.media.at(0).sigma_t.value.g == 0.5);
  CHECK(apart.scene.media.at(0).albedo.value.g == 0.5);
  for (const std::string split : {"sigma_s", "sigma_a"})
    for (const std::string whole : {"sigma_t", "albedo"})
      CHECK_THROWS_WITH(load(number(whole) + number(split)),
                        Contains("error: \"" + split + "\" and \"" + whole + "\" contradict each other"));
  // Of what varies alone.
  const LoadedScene dense = load(number("density"));
  REQUIRE(dense.warnings.size() == 1);
  CHECK_THAT(dense.warnings[0].message, Contains("unknown parameter \"density\""));
  CHECK(dense.scene.media.at(0).sigma_t.value.g == 1);
}

TEST_CASE("the weight of a blendphase is held to [0, 1], as Mitsuba has it") {
  const VolumeFolder folder;
  const auto load = [&](const std::string& weight) {
    return folder.load("type=\"homogeneous\"><phase type=\"blendphase\"><float name=\"weight\" value=\"" + weight +
                       "\"/><phase type=\"hg\"/><phase type=\"rayleigh\"/></phase>");
  };
  for (const auto& [weight, second] : {std::pair{"1.5", 1.0}, {"-.5", 0.0}, {".25", 0.25}}) {
    INFO(weight);
    const LoadedScene loaded = load(weight);
    CHECK(loaded.scene.media.at(0).phases.at(1).share == second);
    CHECK(loaded.scene.media.at(0).phases.at(0).share == 1 - second);
    CHECK(loaded.warnings.size() == (weight == std::string(".25") ? 0 : 1));
    if (!loaded.warnings.empty()) CHECK_THAT(loaded.warnings[0].message, Contains("outside [0, 1]"));
  }
}

TEST_CASE("the weight of a blendphase may be a volume that is alike everywhere, or a colour") {
  const VolumeFolder folder;
  for (const std::string weight :
       {"<volume type=\"constvolume\" name=\"weight\"><float name=\"value\" value=\".25\"/></volume>",
        "<rgb name=\"weight\" value=\".5 .25 0\"/>"}) {
    INFO(weight);
    const LoadedScene loaded = folder.load("type=\"homogeneous\"><phase type=\"blendphase\">" + weight +
                                           "<phase type=\"hg\"/><phase type=\"rayleigh\"/></phase>");
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.media.at(0).phases.at(1).share == 0.25);
  }
}

TEST_CASE("emitters may be within a medium, which the boundaries tell") {
  const std::string fog = "<medium type=\"homogeneous\"/>";
  for (const char* type : {"point", "spot", "constant"}) {
    INFO(type);
    const LoadedScene loaded = load_text(around("<emitter type=\"" + std::string(type) + "\">" + fog + "</emitter>"));
    for (const Diagnostic& warning : loaded.warnings) CHECK(warning.message.find("medium") == std::string::npos);
  }
  CHECK(load_text(around("<shape type=\"sphere\"><emitter type=\"area\">" + fog + "</emitter></shape>"))
            .warnings.empty());
}

TEST_CASE("faults of grids name the place") {
  const VolumeFolder folder;
  CHECK_THROWS_WITH(folder.load("type=\"heterogeneous\"><volume name=\"sigma_t\" type=\"gridvolume\"/>"),
                    Contains("needs the string \"filename\""));
  CHECK_THROWS_WITH(folder.load("type=\"heterogeneous\"><volume name=\"sigma_t\" type=\"gridvolume\"><string "
                                "name=\"filename\" value=\"none.vol\"/></volume>"),
                    Contains("none.vol"));
  // Texels above 1 are no albedo.
  CHECK_THROWS_WITH(folder.load("type=\"heterogeneous\">" + grid("albedo")),
                    Contains("albedo of a medium must lie within [0, 1]"));
  const LoadedScene even = folder.load("type=\"homogeneous\">" + grid("sigma_t"));
  REQUIRE(even.warnings.size() == 1);
  CHECK_THAT(even.warnings[0].message, Contains("belongs to a medium of type heterogeneous"));
}

}  // namespace
