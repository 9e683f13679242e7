// SPDX-License-Identifier: MIT
// Samples of a pixel that are followed in lanes give the picture, the AOVs and the counts of samples followed one by
// one, bit for bit: kinds with a body for packets and without, trees, instances, smooth meshes, drawn and taken lights,
// mirrors, glass, hidden emitters, more samples than a pool holds, and few, so that a work-item takes a span of pixels.
// By programs with every effect, which test_generic.cpp holds to those of the scenes. With STRAHL_LANES=long all tiers
// and widths.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "kinds/entries.h"
#include "kinds/shapes.h"
#include "render/pictures.h"
#include "scene/scene_text.h"
#include "selftest/questions.h"
#include "selftest/shape_proof.h"
#include "support/asked.h"

namespace strahl::test {
namespace {

constexpr int odd_samples = 21;

RenderResult followed(const Scene& scene, RenderSettings settings, bool in_lanes) {
  settings.paths_in_lanes = in_lanes;
  const RenderResult result = render("pocl", scene, settings);
  const int lanes = result.stats.lanes;
  REQUIRE(lanes > 1);
  REQUIRE(result.stats.path_lanes == (in_lanes ? lanes : 1));
  return result;
}

void require_same(const Scene& scene, const RenderSettings& settings) {
  const RenderResult one = followed(scene, settings, false), lanes = followed(scene, settings, true);
  CHECK(one.stats.seconds.kernel > 0);
  REQUIRE(one.color.data.size() > 0);
  CHECK(same_bits(one, lanes));
  CHECK(one.stats.shadow_rays == lanes.stats.shadow_rays);
  CHECK(one.stats.bounce_rays == lanes.stats.bounce_rays);
}

Scene of(const std::string& name) { return small_scene(scene_folder / name, 24, 20, odd_samples); }

RenderSettings plain(Precision precision = Precision::robust, int lanes = 16) {
  RenderSettings settings;
  settings.precision = precision;
  settings.lanes = lanes;
  return settings;
}

bool is_long() {
  const char* run = std::getenv("STRAHL_LANES");
  return run != nullptr && std::string_view(run) == "long";
}

/// By the programs with every effect, which scenes share, or the scene's own.
RenderSettings shared(Precision precision = Precision::robust, int lanes = 16) {
  RenderSettings settings = plain(precision, lanes);
  settings.generic = asks_generic();
  return settings;
}

TEST_CASE("a closed room in lanes") {
  require_pocl();
  const Scene scene = of("cornell/cornell-box.xml");
  require_same(scene, plain());
  if (!is_long()) return;
  require_same(scene, plain(Precision::fp64, 8));
  require_same(scene, plain(Precision::robust, 8));
  require_same(scene, plain(Precision::stable));
}

TEST_CASE("what is reported of first samples, and counts of rays, in lanes") {
  require_pocl();
  Scene scene = of("materials/conductor.xml");
  RenderSettings settings = all_aovs();
  settings.lanes = 16;
  settings.count_rays = true;
  require_same(scene, settings);
}

TEST_CASE("shapes that are asked ray by ray in a tree, and emitters that the camera looks through, in lanes",
          "[slow]") {
  require_pocl();
  Scene scene = of("lights/disk.xml");
  scene.integrator.name = "path";
  scene.integrator.max_depth = 4;
  scene.integrator.hide_emitters = true;
  RenderSettings settings = plain(Precision::robust, 8);
  settings.acceleration = Acceleration::tree;
  require_same(scene, settings);
  if (!is_long()) return;
  settings.acceleration = Acceleration::automatic;
  scene.integrator.hide_emitters = false;
  require_same(scene, settings);
  settings.acceleration = Acceleration::tree;
  require_same(scene, settings);
  Scene rectangle = of("lights/rectangle.xml");
  rectangle.integrator = scene.integrator;
  rectangle.integrator.hide_emitters = true;
  require_same(rectangle, plain());
}

/// As its proof draws it, 0.8 across, there.
Geometry drawn(const std::string& kind, const Vec3& place) {
  oracle::Random random(31);
  const selftest::Question question = selftest::draw_question(kind, oracle::Law::aimed, random);
  Geometry geometry = selftest::proof_of(kind).geometry(question.planes.data());
  kinds::Extent extent;
  std::visit([&](const auto& one) { kinds::extend(extent, one); }, geometry);
  const Box box = extent.box().value_or(Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  const Vec3 middle = 0.5 * (box.min + box.max);
  const double factor = 0.8 / length(box.max - box.min);
  const auto move = [&](const Vec3& p) { return place + factor * (p - middle); };
  std::visit([&](auto& one) { kinds::move(one, move, [&](const Vec3& v) { return factor * v; }); }, geometry);
  std::visit([&](auto& one) { kinds::scale(one, factor); }, geometry);
  return geometry;
}

/// Of every kind that has no shape among them but polygons, which have scenes of their own: one beside each sphere,
/// like it otherwise. So a kind that is new to the kernels needs no lines here.
void add_others(std::vector<Shape>& shapes) {
  std::set<std::string> kinds = {"plane", "triangle", "parallelogram"};
  std::vector<Shape> spheres;
  for (const Shape& shape : shapes) {
    kinds.insert(shape_kind(shape));
    if (std::holds_alternative<Sphere>(shape.geometry)) spheres.push_back(shape);
  }
  for (const std::string& kind : list_entries("shapes")) {
    if (kinds.contains(kind)) continue;
    for (Shape shape : spheres) {
      shape.geometry = drawn(kind, std::get<Sphere>(shape.geometry).center + Vec3{0.2, 0.4, 0.6});
      shapes.push_back(shape);
    }
  }
}

/// A shape of every kind but polygons, most of them flipped, too, of metals that know along from across and of textured
/// paper; with instances of them or without.
Scene all_shapes(bool has_relief, bool has_instances) {
  const SceneFolder folder;
  const std::string steel = has_relief ? "dented" : "steel";
  const auto shape = [](const std::string& type, const std::string& of, const std::string& parameters) {
    return "<shape type='" + type + "'><ref id='" + of + "'/>" + parameters + "</shape>";
  };
  const auto moved = [](const std::string& by) { return "<transform name='to_world'>" + by + "</transform>"; };
  const std::string flipped = "<boolean name='flip_normals' value='true'/>";
  const std::string axis =
      "<point name='p0' value='0, 0, 0'/><point name='p1' value='0.2, 0.9, 0'/><float name='radius' value='0.2'/>";
  const std::string corners = "<point name='min' value='-0.3, -0.2, -0.3'/><point name='max' value='0.3, 0.3, 0.4'/>";
  const std::string own = shape("disk", steel, moved("<scale value='0.5'/><translate value='0.8, 0.3, 0'/>")) +
                          shape("cylinder", steel, axis) + shape("box", "paper", corners) +
                          shape("sphere", steel, moved("<scale value='0.3'/><translate value='-0.7, 0.2, 0'/>"));
  const std::string instances =
      "<shape type='shapegroup' id='group'>" + own + "</shape><shape type='instance'><ref id='group'/>" +
      moved("<rotate y='1' angle='40'/><scale value='0.6'/><translate value='0.4, 1.2, 0'/>") +
      "</shape><shape type='instance'><ref id='group'/>" +
      moved("<rotate x='1' angle='70'/><scale x='-1' y='0.7' z='1.2'/><translate value='-0.5, -0.8, 1'/>") + "</shape>";
  const std::string text =
      "<texture type='bitmap' id='waves'><boolean name='raw' value='true'/><string name='filename' value='" +
      (scene_folder / "textures/waves.png").string() +
      "'/></texture>"
      "<bsdf type='diffuse' id='paper'><ref id='waves' name='reflectance'/></bsdf>"
      "<bsdf type='roughconductor' id='steel'><float name='alpha_u' value='0.1'/><float name='alpha_v' "
      "value='0.5'/></bsdf>"
      "<bsdf type='bumpmap' id='dented'><ref id='waves'/><float name='scale' value='0.05'/><ref id='steel'/></bsdf>"
      "<emitter type='constant'/>" +
      shape("plane", "paper", "<point name='point' value='0, -1, 0'/><vector name='normal' value='0, 1, 0'/>") +
      shape("plane", "steel",
            moved("<scale x='-1'/>") + "<point name='point' value='0, 0, -3'/>" +
                "<vector name='normal' value='0, 0, 1'/>") +
      own + shape("disk", "paper", flipped + moved("<translate value='1.5, 0, -1'/>")) +
      shape("cylinder", "paper", flipped + axis + moved("<scale value='2'/><translate value='-2, 0, -1'/>")) +
      shape("box", steel, flipped + "<point name='min' value='-1, 0.5, -2'/><point name='max' value='0, 1, -1'/>") +
      shape("sphere", "paper", flipped + moved("<scale value='0.4'/><translate value='1, 1, -1'/>")) +
      (has_instances ? instances : "") + "<sensor type='perspective'>" +
      moved("<lookat origin='0.5, 1, 5' target='0, 0, 0' up='0, 1, 0'/>") + "</sensor>";
  Scene scene = small_scene(folder.write("shapes.xml", "<scene version='3.0.0'>" + text + "</scene>"), 24, 20, 21);
  add_others(scene.shapes);
  for (Group& group : scene.groups) add_others(group.shapes);
  scene.integrator.name = "path";
  scene.integrator.max_depth = 4;
  return scene;
}

TEST_CASE("every shape with its coordinates, in lanes") {
  require_pocl();
  require_same(all_shapes(true, true), shared());
  if (!is_long()) return;
  for (const auto& [has_relief, has_instances] : {std::pair{false, true}, {true, true}, {true, false}}) {
    for (const Precision precision : exact_tiers) {
      for (const int lanes : {8, 16}) {
        if (precision == Precision::fp64 && lanes == 16) continue;
        INFO(has_relief << has_instances << ' ' << precision_name(precision) << ' ' << lanes);
        require_same(all_shapes(has_relief, has_instances), plain(precision, lanes));
      }
    }
  }
}

/// The distance to a box from a camera that stands within a wall, parallel to an axis or not.
Scene within_a_wall(double near_clip, double angle) {
  const SceneFolder folder;
  const std::string turn = "<rotate y='1' angle='" + std::to_string(90 + angle) + "'/>", name = "wall.xml";
  Scene scene = small_scene(
      folder.write(name,
                   "<scene version='3.0.0'><integrator type='depth'/>"
                   "<shape type='cube'/><shape type='rectangle'><transform name='to_world'><scale value='20'/>" +
                       turn +
                       "<translate z='5'/></transform></shape><sensor type='perspective'><float "
                       "name='near_clip' value='" +
                       std::to_string(near_clip) +
                       "'/><transform name='to_world'><lookat origin='0, 0, 5' target='0, 0, 0' up='0, 1, 0'/>"
                       "</transform></sensor></scene>"),
      24, 20, odd_samples);
  return scene;
}

TEST_CASE("a camera within a wall sees the wall, or past it what is not too near, in lanes") {
  require_pocl();
  for (const double angle : {0.0, 12.5}) {
    INFO(angle);
    const Scene clipped = within_a_wall(0.01, angle);
    require_same(clipped, shared());
    const RenderResult past = followed(clipped, shared(), true);
    CHECK(lit_pixels(past.color) > 50);
    // Rounding leaves a wall that is turned before the camera or behind it.
    if (angle == 0) CHECK(lit_pixels(followed(within_a_wall(0, angle), shared(), true).color) == 0);
    Scene open = clipped;
    open.shapes.pop_back();
    CHECK(same_bits(past, followed(open, shared(), true)));
  }
}

TEST_CASE(
    "smooth meshes, and in the long run instances in both tiers that keep their bits everywhere, in a tree, in lanes") {
  require_pocl();
  require_same(of("mesh/torus-and-icosphere.xml"), shared());
  if (!is_long()) return;
  require_same(of("instances/mushrooms.xml"), plain(Precision::fp64, 8));
  require_same(of("instances/mushrooms.xml"), plain(Precision::robust, 8));
}

TEST_CASE("glass in a tree, in lanes, and more samples than a pool holds") {
  require_pocl();
  RenderSettings settings = shared(Precision::robust, is_long() ? 8 : 16);
  settings.acceleration = Acceleration::tree;
  const Scene scene = small_scene(scene_folder / "materials/dielectric.xml", 12, 10, 150);
  require_same(scene, settings);
  if (!is_long()) return;
  settings.precision = Precision::fp64;
  require_same(scene, settings);
}

/// Bars of light of each bin that a film has, thin, so that most samples of a pixel are black.
Scene thin_bars() {
  std::string bars;
  const char* const radiances[] = {"3e7, 2e-3, 1e-9", "1, 0, 5e8", "2e-8, 1e-12, 3"};
  for (int i = 0; i < 24; ++i)
    bars += "<shape type=\"rectangle\"><transform name=\"to_world\"><scale x=\"0.004\"/><translate x=\"" +
            std::to_string((2 * i + 1) / 24.0 - 1) + "\" z=\"3\"/><rotate y=\"1\" angle=\"180\"/></transform>" +
            "<emitter type=\"area\"><rgb name=\"radiance\" value=\"" + radiances[i % 3] + "\"/></emitter></shape>";
  Scene scene = load_text(
                    "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"orthographic\"><transform "
                    "name=\"to_world\"><translate z=\"-9\"/></transform></sensor>" +
                    bars + "</scene>")
                    .scene;
  scene.film.width = 12;
  scene.film.height = 10;
  scene.sampler.sample_count = 86;
  return scene;
}

TEST_CASE("light of any size, and black samples, in lanes") {
  require_pocl();
  require_same(thin_bars(), plain());
  if (is_long()) require_same(thin_bars(), plain(Precision::robust, 8));
}

TEST_CASE("blends, masks, bent normals and textures in lanes, by programs of their own", "[slow]") {
  require_pocl();
  require_same(of("materials/blendbsdf.xml"), plain());
  require_same(of("materials/mask.xml"), plain(Precision::robust, 8));
  require_same(of("materials/normalmap.xml"), plain());
  require_same(of("materials/bumpmap.xml"), plain(Precision::robust, 8));
  require_same(of("accuracy/checkerboard.xml"), plain());
}

/// Spans that end before the row does, and rows of a part of the picture.
void require_same_in_spans(Scene scene, const RenderSettings& settings) {
  scene.film.width = 27;
  scene.film.crop = Window{3, 2, 26, 19};
  for (const int samples : {1, 3, 7}) {
    INFO(samples << " samples");
    scene.sampler.sample_count = samples;
    require_same(scene, settings);
  }
}

TEST_CASE("few samples in lanes: meshes, first samples that are reported with textures, branches", "[slow]") {
  require_pocl();
  require_same_in_spans(of("mesh/torus-and-icosphere.xml"), plain());
  RenderSettings settings = all_aovs();
  settings.lanes = 8;
  require_same_in_spans(of("accuracy/checkerboard.xml"), settings);
  Scene branching = of("materials/dielectric.xml");
  branching.integrator.name = "whitted";
  require_same_in_spans(branching, plain(Precision::robust, 8));
}

TEST_CASE("few samples in lanes by any launches") {
  require_pocl();
  const Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 70, 9, 6);
  RenderSettings settings = plain();
  const RenderResult whole = followed(scene, settings, true);
  settings.passes = 4;
  settings.work_group = {4, 2};
  CHECK(same_bits(whole, followed(scene, settings, true)));
}

}  // namespace
}  // namespace strahl::test
