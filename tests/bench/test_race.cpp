// SPDX-License-Identifier: MIT
// Races: who answers otherwise has no time, everybody runs as often, and the report says what the rounds said. 2 s.
#include <catch2/catch.hpp>
#include <set>

#include "bench/plot.h"
#include "bench/race.h"
#include "bench/strahl_contender.h"
#include "bench/traversal.h"
#include "bench/traversal_report.h"
#include "image/temporary_folder.h"
#include "study/generated/scenes.h"
#include "study/ray_sets.h"
#include "support/devices.h"

namespace strahl::test {
namespace {

using namespace strahl::bench;

/// Answers what it was told to, in times that it was told.
class Puppet : public Contender {
 public:
  Puppet(std::string variant, std::vector<double> answers, std::vector<double> seconds)
      : variant_(std::move(variant)), answers_(std::move(answers)), seconds_(std::move(seconds)) {}
  [[nodiscard]] std::string program() const override { return variant_ == "robust" ? "strahl" : "peer"; }
  [[nodiscard]] std::string variant() const override { return variant_; }
  void load(const RaySet&) override {}
  double trace() override { return seconds_[calls_++ % seconds_.size()]; }
  [[nodiscard]] std::vector<double> distances() override { return answers_; }
  [[nodiscard]] double build_seconds() const override { return 0.25; }

 private:
  std::string variant_;
  std::vector<double> answers_, seconds_;
  std::size_t calls_ = 0;
};

constexpr double miss = std::numeric_limits<double>::infinity();

Race puppet_race(std::vector<double> answers) {
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(
      std::make_unique<Puppet>("robust", std::vector<double>(answers.size(), 2.0), std::vector<double>{9, 1, 2, 4}));
  contenders.push_back(std::make_unique<Puppet>("1 robust", answers, std::vector<double>{9, 2, 6, 2}));
  return race(contenders, RaySet{RayKind::primary, std::vector<Ray>(answers.size())}, 3);
}

TEST_CASE("the warm-up does not count, ratios are of the same round") {
  const Race race = puppet_race(std::vector<double>(1000, 2.0));
  CHECK(race.entries[0].seconds == std::vector<double>{1, 2, 4});
  CHECK(race.entries[1].seconds == std::vector<double>{2, 6, 2});
  CHECK(speed_ratio(race.entries[0], race.entries[1]) == 2);  // Of 2, 3 and 1/2.
  CHECK(race.entries[1].hits == 1000);
}

TEST_CASE("other answers than the first's have no time") {
  for (const double wrong : {miss, 2.01}) {
    std::vector<double> answers(2000, 2.0);
    std::fill_n(answers.begin(), 40, wrong);
    CHECK(puppet_race(answers).entries[1].differing == 40);
    answers[77] = wrong;
    CHECK_THROWS_WITH(puppet_race(answers), Catch::Contains("41 of 2000 primary rays"));
  }
}

TEST_CASE("measurements survive JSON, and the report has them") {
  Traversal all{"a device", "a machine", "1.2.3", 2, 3, {}, {{"terrain-10000", 10000, "strahl", {0.5, 0.25, 1}, 7.5}}};
  for (const std::size_t primitives : {10000, 1000000}) {
    Race one = puppet_race(std::vector<double>(1000, 2.0));
    one.scene = "terrain-" + std::to_string(primitives);
    one.primitives = primitives;
    all.races.push_back(one);
  }
  const Traversal again = traversal_of_json(json(all));
  CHECK(json(again) == json(all));
  CHECK_THROWS_AS(traversal_of_json("{\"device\": 3}"), InputError);
  const auto plots = traversal_plots(again);
  REQUIRE(plots.count("terrain-primary.svg") == 1);
  REQUIRE(plots.count("peers.svg") == 1);
  CHECK(plots.at("terrain-primary.svg").find(">peer 1 robust</text>") != std::string::npos);
  const std::string text = markdown(again, plots, "");
  CHECK(text.find("### terrain-1000000: 1,000,000 primitives") != std::string::npos);
  CHECK(text.find("| strahl robust | 0.00 | 0 | × 2.00 |") != std::string::npos);
  CHECK(text.find("| terrain-10000 | strahl | 0.500 | 0.02 | 7.50 |") != std::string::npos);
  CHECK(text.find("(peers.svg)") != std::string::npos);
}

Race race_of(const std::vector<std::pair<std::string, double>>& ours, bool has_peer) {
  Race one{"ten", 11, "primary", 1000, {}};
  for (const auto& [variant, seconds] : ours) one.entries.push_back({"strahl", variant, {seconds}, 0, 500, 0});
  if (has_peer) one.entries.push_back({"peer", "1", {1}, 0, 500, 0});
  return one;
}

std::string report_of(const Race& race) {
  const Traversal all{"a device", "a machine", "1.2.3", 7, 1, {race}, {}};
  return markdown(all, traversal_plots(all), "");
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("the threads that are told are the peers', where there are some") {
  CHECK(has(report_of(race_of({{"robust", 2}}, true)), "on all of a device; a machine, the peers with 7 threads; "));
  CHECK_FALSE(has(report_of(race_of({{"robust", 2}}, false)), "threads"));
}

TEST_CASE("tiers are told beside fast of the same width, and not without it") {
  const std::string both = report_of(race_of({{"robust", 3}, {"robust coherent", 9}, {"fast", 2}}, false));
  CHECK(has(both, "| time, `fast` = 1 | fast | robust |\n"));
  CHECK(has(both, "| ten, primary | 1.00 | 1.50 |\n"));
  CHECK(has(both, "tiers.svg"));
  const std::string widths =
      report_of(race_of({{"robust 4 wide", 3}, {"robust 8 wide", 8}, {"fast 4 wide", 2}, {"fast 8 wide", 2}}, false));
  CHECK(has(widths, "| fast 4 wide | fast 8 wide | robust 4 wide | robust 8 wide |\n"));
  CHECK(has(widths, "| ten, primary | 1.00 | 1.00 | 1.50 | 4.00 |\n"));
  for (const Race& race : {race_of({{"robust", 3}, {"stable", 2}}, false), race_of({{"fast", 2}}, true),
                           race_of({{"robust 8 wide", 3}, {"fast", 2}}, false)}) {
    const std::string text = report_of(race);
    CHECK_FALSE(has(text, "What each tier costs"));
    CHECK_FALSE(has(text, "tiers.svg"));
    CHECK_FALSE(has(text, "nan"));
  }
}

TEST_CASE("files of one device make one report, those of several none") {
  const TemporaryFolder folder;
  const Traversal one{"a device", "a machine", "1.2.3", 2, 1, {race_of({{"robust", 2}}, false)}, {}};
  Traversal other = one;
  other.races[0].scene = "terrain-10000";
  put_bytes(folder / "one.json", json(one));
  put_bytes(folder / "same.json", json(other));
  const Traversal both = traversal_of_files({folder / "one.json", folder / "same.json"});
  REQUIRE(both.races.size() == 2);
  CHECK(both.races[0].scene == "ten");
  CHECK(both.races[1].scene == "terrain-10000");
  other.device = "another device";
  put_bytes(folder / "other.json", json(other));
  CHECK_THROWS_WITH(traversal_of_files({folder / "one.json", folder / "other.json"}),
                    Catch::Contains("other.json is of another device (a machine), and") &&
                        Catch::Contains("one.json is of a device (a machine)"));
  put_bytes(folder / "none.json", "{}");
  CHECK_THROWS_WITH(traversal_of_files({folder / "none.json"}), Catch::Contains("none.json: no measurements"));
}

TEST_CASE("the measurements that are kept can be read, those without trees too") {
  const std::string kept = STRAHL_SOURCE_DIR "/docs/performance/";
  CHECK(traversal_of_files({kept + "traversal.json"}).trees.size() == 6);
  const Traversal without = traversal_of_files({kept + "traversal_avx2.json"});
  CHECK(without.trees.empty());
  CHECK(without.races.size() == 9);
}

TEST_CASE("the line at 1 lies within bars that are all lower") {
  const std::string plot = bar_plot("title", "x", {"a"}, {{"low", {}, {0.5}}}, 1);
  const std::size_t line = plot.rfind("<line ");
  REQUIRE(line != std::string::npos);
  const std::size_t y = plot.find("y1=\"", line) + std::string("y1=\"").size();
  CHECK(std::stod(plot.substr(y)) >= 40);  // The top of the axes.
}

TEST_CASE("strahl races against itself") {
  require_pocl();
  const Device device = Device::open("pocl");
  const Traversal all = measure_traversal(device,
                                          {{"ten", "lattice-2"},
                                           {RayKind::primary, RayKind::shadow, RayKind::diffuse},
                                           {Precision::robust, Precision::fast},
                                           {},
                                           false,
                                           32,
                                           2,
                                           0},
                                          [](const std::string&) {});
  REQUIRE(all.races.size() == 6);
  CHECK(all.races[0].rays == 1024);
  CHECK(all.races[3].primitives == 8);
  for (const Race& race : all.races) {
    std::vector<std::string> variants;
    for (const Entry& entry : race.entries) variants.push_back(entry.variant);
    CHECK(std::set<std::string>(variants.begin(), variants.end()) ==
          std::set<std::string>{"robust", "robust coherent", "fast", "fast coherent"});
    for (const Entry& entry : race.entries) CHECK(entry.seconds.size() == 2);
    CHECK(race.entries[0].hits > 0);
    CHECK(race.entries[0].hits <= race.rays);
  }
}

TEST_CASE("a scene whose lights are no points gets a lamp for its shadow rays; warnings of its file are told") {
  const TemporaryFolder folder;
  put_bytes(folder / "sky.xml", R"(<scene version="3.0.0"><sensor type="perspective"><transform name="to_world">
    <lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform></sensor>
    <emitter type="constant"/><shape type="sphere"><float name="raduis" value="2"/></shape></scene>)");
  std::string told;
  const Scene scene = bench_scene(folder / "sky.xml", [&](const std::string& line) { told += line; });
  CHECK(told.find("raduis") != std::string::npos);
  CHECK(scene.lights.size() == 2);
  CHECK_NOTHROW(shadow_rays(scene, {}, {}));
}

}  // namespace
}  // namespace strahl::test
