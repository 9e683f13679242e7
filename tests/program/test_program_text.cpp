// SPDX-License-Identifier: MIT
// A program's text depends on the effects in use alone: not on a scene's values, nor on effects that it does not use.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "image/temporary_folder.h"
#include "kinds/integrators.h"
#include "opencl/program.h"
#include "program/program_text.h"
#include "scene/loader.h"
#include "scene/model/build.h"

using namespace strahl;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> roots = {"kernels/render.cl", "kernels/intersect.cl"};

std::string text_of(const Scene& scene, const RenderSettings& settings = {}, const std::string& root = roots[0]) {
  return program_source(root, features_of(scene, settings), settings.precision, 8).text;
}

std::string picture_text_of(const Scene& scene, const RenderSettings& settings = {}) {
  return text_of(scene, settings, kinds::integrator(scene.integrator.name).kernel());
}

/// What programs are cached and named by: text and options.
std::string hash_of(const Scene& scene) {
  return program_hash(program_source(roots[0], features_of(scene, {}), Precision::robust, 8));
}

Scene lecture_scene(const std::string& name) {
  return load_scene(STRAHL_SOURCE_DIR "/scenes/lecture/" + name + ".xml").scene;
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(STRAHL_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".xml") paths.push_back(entry.path().string());
  return paths;
}

/// A copy of cl/ that the library reads while this lives.
class KernelCopy {
 public:
  KernelCopy() {
    fs::copy(STRAHL_SOURCE_DIR "/cl", folder_.path(), fs::copy_options::recursive);
    setenv("STRAHL_KERNEL_DIR", folder_.path().c_str(), 1);
  }
  ~KernelCopy() { unsetenv("STRAHL_KERNEL_DIR"); }
  KernelCopy(const KernelCopy&) = delete;
  KernelCopy& operator=(const KernelCopy&) = delete;

  void append(const std::string& path, const std::string& text) const {
    std::ofstream(folder_ / path, std::ios::app) << text;
  }
  /// Before the first line that is no comment.
  void insert(const std::string& path, const std::string& text) const {
    std::string whole = test::bytes_of(folder_ / path);
    std::size_t at = 0;
    while (whole.compare(at, 2, "//") == 0) at = whole.find('\n', at) + 1;
    REQUIRE(at > 0);
    test::put_bytes(folder_ / path, whole.insert(at, text));
  }

 private:
  test::TemporaryFolder folder_;
};

const std::map<std::string, std::string> macros = {
    {"areas", "AREA"},         {"choosers", "CHOOSER"}, {"integrators", "INTEGRATOR"}, {"lights", "LIGHT"},
    {"materials", "MATERIAL"}, {"media", "MEDIUM"},     {"phases", "PHASE"},           {"samplers", "SAMPLER"},
    {"shapes", "SHAPE"},       {"textures", "TEXTURE"}};

/// Another entry of a list, registered as CONTRIBUTING.md says, `first` before all others or after them.
void add_entry(const KernelCopy& kernels, const std::string& list, const std::string& name, bool first) {
  REQUIRE(macros.contains(list));
  const std::map<std::string, std::string> further = {
      {"shapes", ", 3"}, {"areas", ", 3"}, {"materials", ", 3, LOBE_GLOSSY"}};
  const auto more = further.find(list);
  const std::string entry = macros.at(list) + "(" + name + (more == further.end() ? "" : more->second) + ")\n";
  const std::string def = list + "/" + list + ".def";
  // Shapes have a file of either sort an entry, all else is written in lanes.
  std::vector<std::pair<std::string, std::string>> edits = {{"all_lanes.h", "_lanes.h"}};
  if (list == "shapes") edits.emplace_back("all.h", ".h");
  first ? kernels.insert(def, entry) : kernels.append(def, entry);
  for (const auto& [all, suffix] : edits) {
    const std::string file = list + "/" + name + suffix, include = "#include \"" + file + "\"\n";
    kernels.append(file, "int " + list + "_" + name + ";\n");
    first ? kernels.insert(list + "/" + all, include) : kernels.append(list + "/" + all, include);
  }
}

}  // namespace

// But for whether there is a tree: test_calls_for_tree.cpp.
TEST_CASE("Scenes that differ only in values share their program") {
  const Scene original = lecture_scene("lit");
  REQUIRE(std::holds_alternative<PointLight>(original.lights.at(0).emitter));
  const std::string text = text_of(original), hash = hash_of(original);
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> edits = {
      {"colour of a material",
       [](Scene& s) {
         s.materials.back().bsdf = Diffuse{{{0.1, 0.2, 0.3}}};
       }},
      {"one material more", [](Scene& s) { s.materials.push_back(s.materials.back()); }},
      {"colour of a light",
       [](Scene& s) {
         std::get<PointLight>(s.lights[0].emitter).intensity = {9, 8, 7};
       }},
      {"place of a light", [](Scene& s) { std::get<PointLight>(s.lights[0].emitter).position.x += 3; }},
      {"one light more", [](Scene& s) { s.lights.push_back(s.lights[0]); }},
      {"thirty lights more", [](Scene& s) { s.lights.resize(31, s.lights[0]); }},
      {"one shape moved", [](Scene& s) { std::get<Sphere>(s.shapes.back().geometry).center.y += 1; }},
      {"one shape larger", [](Scene& s) { std::get<Sphere>(s.shapes.back().geometry).radius *= 2; }},
      {"one shape more", [](Scene& s) { s.shapes.push_back(s.shapes.back()); }},
      {"a thousand shapes more", [](Scene& s) { s.shapes.resize(1000, s.shapes.back()); }},
      {"a shape flipped", [](Scene& s) { s.shapes[0].flip_normals = true; }},
      {"width", [](Scene& s) { s.film.width = 17; }},
      {"height", [](Scene& s) { s.film.height = 5000; }},
      {"crop",
       [](Scene& s) {
         s.film.crop = Window{1, 2, 3, 4};
       }},
      {"samples", [](Scene& s) { s.sampler.sample_count = 1000; }},
      {"seed", [](Scene& s) { s.sampler.seed = 7; }},
      {"depth", [](Scene& s) { s.integrator.max_depth = 3; }},
      {"hidden emitters", [](Scene& s) { s.integrator.hide_emitters = true; }},
      {"filter",
       [](Scene& s) {
         s.film.filter = {FilterKind::tent, 2, 0.5};
       }},
      {"camera",
       [](Scene& s) {
         s.camera = perspective_camera({1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 10);
       }},
      {"projection", [](Scene& s) { s.camera.projection = Projection::orthographic; }},
      {"clipping", [](Scene& s) { s.camera.near_clip = 1, s.camera.far_clip = 2; }},
  };
  CHECK(edits.size() >= 20);
  for (const auto& [name, edit] : edits) {
    INFO(name);
    Scene edited = original;
    edit(edited);
    CHECK((text_of(edited) == text));  // too long to be printed
    CHECK(hash_of(edited) == hash);
  }
}

TEST_CASE("Another effect, another precision and another width are other programs") {
  const Scene scene = lecture_scene("lit");
  const std::string text = text_of(scene);
  Scene with_disk = scene;
  add(with_disk, Disk{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(text_of(with_disk) != text);
  RenderSettings settings;
  settings.precision = Precision::fp64;
  CHECK(text_of(scene, settings) != text);
  CHECK(program_source(roots[0], features_of(scene, {}), Precision::stable, 16).text != text);
  settings = {};
  settings.aovs = {Aov::depth};
  const std::string with_depth = text_of(scene, settings);
  CHECK(with_depth != text);
  settings.aovs = {Aov::position, Aov::shape_id};
  CHECK(text_of(scene, settings) == with_depth);
}

TEST_CASE("Ahead of the sources stand precision, width and every flag") {
  const Features features = features_of(lecture_scene("lit"), {});
  const auto says = [](const std::string& text, const std::string& line) {
    return text.find("\n#define " + line + "\n") < text.find("#line");
  };
  const std::string single = program_source(roots[0], features, Precision::stable, 16).text;
  CHECK(says(single, "REAL_BITS 32"));
  CHECK(says(single, "TIER_ROBUST 0"));
  CHECK(says(single, "LANES 16"));
  const std::string robust = program_source(roots[0], features, Precision::robust, 16).text;
  CHECK(says(robust, "REAL_BITS 32"));
  CHECK(says(robust, "TIER_ROBUST 1"));
  const std::string twice = program_source(roots[0], features, Precision::fp64, 8).text;
  CHECK(says(twice, "REAL_BITS 64"));
  CHECK(says(twice, "LANES 8"));
  for (const auto& [flag, purpose] : list_features()) {
    INFO(flag);
    CHECK(says(single, "HAS_" + flag + (features.flag(flag) ? " 1" : " 0")));
  }
}

TEST_CASE("A new entry of any list leaves the programs that do not use it as they are") {
  const std::vector<Scene> scenes = {lecture_scene("first-light"), lecture_scene("lit")};
  const auto texts = [&] {
    std::vector<std::string> all;
    for (const Scene& scene : scenes)
      for (const std::string& root : roots) all.push_back(text_of(scene, {}, root));
    return all;
  };
  for (const bool first : {true, false}) {
    const KernelCopy kernels;
    const std::vector<std::string> before = texts();
    for (const std::string& list : list_folders()) add_entry(kernels, list, "novelty", first);
    const std::vector<std::string> after = texts();
    for (const std::string& list : list_folders()) {
      INFO(list);
      CHECK(list_entries(list)[first ? 0 : list_entries(list).size() - 1] == "novelty");
    }
    for (std::size_t i = 0; i < before.size(); ++i) CHECK((after[i] == before[i]));  // too long to be printed
    RenderSettings everything;
    everything.generic = true;
    Scene of_light_paths = scenes[0];
    of_light_paths.integrator.name = "ptracer";
    const std::string generic = picture_text_of(scenes[0], everything);
    const std::string of_lights = picture_text_of(of_light_paths, everything);
    for (const std::string& list : list_folders()) {
      INFO(list);
      CHECK(generic.find("int " + list + "_novelty;") != std::string::npos);
      CHECK(of_lights.find("int " + list + "_novelty;") != std::string::npos);
    }
  }
}

TEST_CASE("A shipped scene's programs hold the entries that it uses and no others") {
  const std::vector<std::string> paths = shipped_scenes();
  CHECK(paths.size() >= 14);
  for (const std::string& path : paths) {
    const Scene scene = load_scene(path).scene;
    const Features features = features_of(scene, {});
    const std::string text = picture_text_of(scene);
    for (const std::string& list : list_folders())
      for (const std::string& entry : list_entries(list)) {
        INFO(path << ": " << list << "/" << entry);
        const bool used = features.has(list, entry);
        const std::string stem = "\"" + list + "/" + entry;
        const auto has_file = [&](const std::string& file) {
          return text.find(file + ".h\"") != std::string::npos || text.find(file + "_lanes.h\"") != std::string::npos;
        };
        const bool is_there = has_file(stem) || has_file(stem + "/" + entry);
        CHECK(is_there == used);
        const std::string row = macros.at(list) + "(" + entry;
        const bool is_listed = text.find(row + ",") != std::string::npos || text.find(row + ")") != std::string::npos;
        CHECK(is_listed == used);
      }
  }
}

TEST_CASE("Programs of paths from the camera hold nothing of those from lights") {
  RenderSettings everything;
  everything.generic = true;
  for (const RenderSettings& settings : {RenderSettings{}, everything}) {
    Scene scene = lecture_scene("lit");
    const std::string text = picture_text_of(scene, settings);
    for (const char* of_lights :
         {"adjoint_lanes.h", "ptracer", "bdpt", "splat_place(", "LightRay_w", "point_ray_w", "techniques"})
      CHECK(text.find(of_lights) == std::string::npos);
    scene.integrator.name = "ptracer";
    const std::string light_tracing = picture_text_of(scene, settings);
    CHECK(light_tracing.find("splat_place(") != std::string::npos);
    for (const char* of_both_ends : {"bdpt_", "techniques"})
      CHECK(light_tracing.find(of_both_ends) == std::string::npos);
    scene.integrator.name = "bdpt";
    const std::string bidirectional = picture_text_of(scene, settings);
    CHECK(bidirectional.find("techniques_turn_w") != std::string::npos);
    CHECK(bidirectional.find("ptracer_step") == std::string::npos);
  }
}

TEST_CASE("First light knows nothing of cylinders") {
  const Scene scene = lecture_scene("first-light");
  for (const std::string& root : roots) {
    const std::string text = text_of(scene, {}, root);
    CHECK(text.find("sphere_") != std::string::npos);
    CHECK(text.find("cylinder") == std::string::npos);
    CHECK(text.find("disks_hit") == std::string::npos);
  }
}

TEST_CASE("Lanes follow a device's vectors, half as many in double") {
  CHECK(default_lanes(16, Precision::stable) == 16);
  CHECK(default_lanes(16, Precision::fp64) == 8);
  CHECK(default_lanes(8, Precision::stable) == 8);
  CHECK(default_lanes(8, Precision::fp64) == 8);
  for (const unsigned width : {1u, 2u, 4u}) {
    CHECK(default_lanes(width, Precision::stable) == 1);
    CHECK(default_lanes(width, Precision::fp64) == 1);
  }
}
