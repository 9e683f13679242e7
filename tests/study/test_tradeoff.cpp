// SPDX-License-Identifier: MIT
// A trade-off study on a device, in small: what it writes, that stopping and going on changes nothing, and the laws
// that errors keep. 4 s.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "errors.h"
#include "image/file_bytes.h"
#include "image/image_io.h"
#include "render/pictures.h"
#include "study/tradeoff/tradeoff.h"

namespace strahl::test {
namespace {
namespace fs = std::filesystem;

/// A folder that goes with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("strahl-tradeoff-" + std::to_string(getpid()) + "-" + next());
  ~Folder() { fs::remove_all(path); }
  static std::string next() {
    static int count = 0;
    return std::to_string(count++);
  }
};

Scene small_room() { return small_scene(scene_folder / "lights/constant.xml", 32, 24, 1); }

TradeoffOptions small_study(const Scene& scene, const Folder& folder) {
  TradeoffAxes axes;
  axes.precisions = {Precision::robust, Precision::fp64};
  axes.samplers = {SamplerKind::sobol};
  axes.spps = {1, 4, 16};
  axes.depths = {1, -1};
  axes.generic = false;
  TradeoffOptions options;
  options.plan = plan_tradeoff(scene.integrator, axes, Precision::fp64, 256);
  options.folder = folder.path.string();
  options.scene_path = "constant.xml";
  options.command = "strahl tradeoff constant.xml";
  return options;
}

nlohmann::json json_in(const Folder& folder) {
  return nlohmann::json::parse(read_file((folder.path / "tradeoff.json").string()));
}

/// Without what a clock has measured.
nlohmann::json timeless(nlohmann::json json) {
  for (auto& point : json["points"])
    for (const char* name : {"seconds", "pareto", "program_from_cache"}) point.erase(name);
  json.erase("fits");
  json["reference"].erase("seconds");
  return json;
}

TEST_CASE("what a study writes, and what it goes on from") {
  require_pocl();
  const Device device = Device::open("pocl", {true});
  const Scene scene = small_room();
  const Folder whole, parts;

  const TradeoffStudy study = study_tradeoff(device, scene, small_study(scene, whole));
  REQUIRE(study.complete);
  CHECK(study.taken_over == 0);
  const nlohmann::json json = json_in(whole);
  REQUIRE(json["points"].size() == 2 * 3 + 3);
  CHECK(json["width"] == 32);
  CHECK(json["reference"]["precision"] == "double");
  CHECK(json["reference"]["spp"] == 256);
  CHECK(json["reference"]["rmse"] > 0);
  CHECK(json["reference"]["rmse_low"] < json["reference"]["rmse"]);
  CHECK(json["reference"]["rmse_high"] > json["reference"]["rmse"]);
  int front = 0;
  std::map<std::string, std::string> programs;
  for (const auto& point : json["points"]) {
    INFO(point["id"]);
    for (const char* name : {"program", "bvh", "upload", "kernel", "wall"}) CHECK(point["seconds"][name] >= 0);
    CHECK(point["seconds"]["kernel"] > 0);
    CHECK(point["seconds"]["wall"] > point["seconds"]["kernel"]);
    for (const char* name : {"mse", "rmse", "relmse", "mae", "psnr", "ssim", "flip"}) CHECK(point[name] > 0);
    CHECK(point["bias2"] >= 0);
    // Emission alone is the same from every seed.
    CHECK((point["variance"] > 0) == (point["max_depth"] == -1));
    CHECK((point["rmse_low"] < point["rmse"]) == (point["max_depth"] == -1));
    CHECK((point["rmse"] < point["rmse_high"]) == (point["max_depth"] == -1));
    CHECK(point["seeds"] == 3);
    for (const char* name : {"picture", "difference"}) CHECK(fs::exists(whole.path / point[name].get<std::string>()));
    front += point["pareto"] ? 1 : 0;
    programs[point["id"]] = point["program"];
    // What depth 1 leaves out no number of samples brings back.
    if (point["max_depth"] == 1) CHECK(point["bias2"] > 5 * point["bias2_error"].get<double>());
    if (point["max_depth"] == -1) CHECK(point["bias2"] < 4 * point["bias2_error"].get<double>());
  }
  CHECK(front >= 2);
  // One sample has the program that many have, so that it is compiled once.
  CHECK(programs.at("robust-sobol-dinf-1spp-specialised") == programs.at("robust-sobol-dinf-16spp-specialised"));
  CHECK(programs.at("double-sobol-dinf-1spp-specialised") == programs.at("double-sobol-dinf-16spp-specialised"));
  CHECK(json["fits"].size() == 3);
  CHECK(fs::exists(whole.path / "reference.exr"));
  CHECK(fs::exists(whole.path / "reference.png"));
  const std::string csv = read_file((whole.path / "tradeoff.csv").string());
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 10);
  CHECK(csv.substr(0, csv.find('\n')).find("id,precision,sampler,max_depth,spp") == 0);
  CHECK(csv.find("seconds.kernel") != std::string::npos);
  CHECK(read_file((whole.path / "report.html").string()).find("robust-sobol-dinf-16spp-specialised") !=
        std::string::npos);

  // The same in three goes: stopped in the reference, then among the points.
  const auto stop_at = [](const std::string& what) {
    return [what](const TradeoffProgress& progress) { return progress.what.find(what) == std::string::npos; };
  };
  CHECK_FALSE(study_tradeoff(device, scene, small_study(scene, parts), stop_at("reference")).complete);
  const TradeoffStudy begun = study_tradeoff(device, scene, small_study(scene, parts), stop_at("double"));
  CHECK_FALSE(begun.complete);
  CHECK(begun.points.size() == 3);
  CHECK_FALSE(fs::exists(parts.path / "tradeoff.json"));
  // A damaged point is measured again.
  fs::resize_file(parts.path / "points/robust-sobol-dinf-4spp-specialised.json", 100);
  double share = 0;
  const TradeoffStudy ended =
      study_tradeoff(device, scene, small_study(scene, parts), [&](const TradeoffProgress& progress) {
        CHECK(progress.what.find("reference") == std::string::npos);
        CHECK(progress.share <= 1);
        share = progress.share;
        return true;
      });
  REQUIRE(ended.complete);
  CHECK(ended.taken_over == 2);
  CHECK(share > 0.5);
  CHECK(timeless(json_in(parts)) == timeless(json));
  for (const auto& point : json["points"]) {
    const std::string picture = point["picture"];
    CHECK(read_file((parts.path / picture).string()) == read_file((whole.path / picture).string()));
  }

  // Another study does not mix with it.
  TradeoffOptions other = small_study(scene, parts);
  other.seeds = 2;
  CHECK_THROWS_WITH(study_tradeoff(device, scene, other), Catch::Contains("seeds") && Catch::Contains("--restart"));
  Scene brighter = scene;
  brighter.shapes.back().radiance = Rgb{1, 2, 3};
  CHECK_THROWS_WITH(study_tradeoff(device, brighter, small_study(scene, parts)), Catch::Contains("scene"));
  CHECK(study_tradeoff(device, scene, small_study(scene, parts)).taken_over == 9);
}

TEST_CASE("independent samples: the error falls as their root; somebody's reference") {
  require_pocl();
  const Device device = Device::open("pocl", {true});
  const Scene scene = small_room();
  const Folder folder;
  TradeoffAxes axes;
  axes.precisions = {Precision::robust};
  axes.samplers = {SamplerKind::independent};
  axes.spps = {4, 16, 64, 256};
  axes.generic = false;
  TradeoffOptions options;
  options.plan = plan_tradeoff(scene.integrator, axes, Precision::fp64, 2048);
  options.folder = folder.path.string();
  options.seeds = 4;
  const TradeoffStudy study = study_tradeoff(device, scene, options);
  REQUIRE(study.fits.size() == 1);
  for (const TradeoffFit& fit : study.fits) {
    REQUIRE(fit.samples);
    CHECK(fit.samples->slope == Approx(-0.5).margin(0.03));
  }
  for (const TradeoffPoint& point : study.points) {
    INFO(point.setting.id());
    CHECK(point.error.bias2 < 4 * point.error.bias2_error);
    CHECK(point.error.mse == Approx(point.error.variance).epsilon(0.1));
  }

  // Against a picture that is 0.1 too bright everywhere the bias is that.
  Image brighter = study.reference.picture;
  for (float& value : brighter.data) value += 0.1F;
  options.reference_file = (folder.path / "brighter.exr").string();
  static_cast<void>(write_image(brighter, options.reference_file));
  CHECK_THROWS_WITH(study_tradeoff(device, scene, options), Catch::Contains("reference"));
  options.restart = true;
  options.plan.settings = {options.plan.settings.back()};
  const TradeoffStudy biased = study_tradeoff(device, scene, options);
  CHECK_FALSE(biased.reference.rmse);
  CHECK(biased.points.front().error.bias2 == Approx(0.01).epsilon(0.1));
  options.reference_file = (folder.path / "smaller.exr").string();
  brighter.width = 8;
  brighter.height = 8;
  brighter.data.resize(8 * 8 * 3);
  static_cast<void>(write_image(brighter, options.reference_file));
  CHECK_THROWS_AS(study_tradeoff(device, scene, options), InputError);
}

}  // namespace
}  // namespace strahl::test
