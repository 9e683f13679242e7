// SPDX-License-Identifier: MIT
// The three buffers of a scene, read back by the rules of cl/scene/layout.h.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "scene/model/build.h"

using namespace strahl;
using Ints = std::vector<std::int32_t>;
using Reals = std::vector<double>;

namespace {

/// A packed scene and the ways to read it.
template <typename Real>
struct Read {
  Features features;
  int lanes;
  PackedScene<Real> packed;

  Read(const Scene& scene, const PackOptions& options, const RenderSettings& settings = {})
      : features(features_of(scene, settings)),
        lanes(options.lanes),
        packed(pack_scene<Real>(scene, features, in_lists(options))) {}

  static PackOptions in_lists(PackOptions options) {
    options.acceleration = Acceleration::list;
    return options;
  }

  [[nodiscard]] int header(int field) const { return packed.index.at(static_cast<std::size_t>(field)); }
  [[nodiscard]] Ints ints(int at, int count) const {
    const auto from = packed.index.begin() + at;
    return {from, from + count};
  }
  [[nodiscard]] Reals shading(int at, int count) const {
    REQUIRE(at >= 0);
    REQUIRE(static_cast<std::size_t>(at + count) <= packed.shading.size());
    return {packed.shading.begin() + at, packed.shading.begin() + at + count};
  }
  [[nodiscard]] int row(const std::string& kind, int field) const {
    const int entry = features.entry_index("shapes", kind);
    REQUIRE(entry >= 0);
    return header(layout::HEADER_INTS + entry * layout::SHAPE_INTS + field);
  }
  [[nodiscard]] int slots(const std::string& kind) const { return row(kind, layout::SHAPE_BLOCKS) * lanes; }
  [[nodiscard]] Ints ids(const std::string& kind) const { return ints(row(kind, layout::SHAPE_IDS), slots(kind)); }
  [[nodiscard]] Ints parts_of(const std::string& kind) const {
    return ints(row(kind, layout::SHAPE_IDS) + slots(kind), slots(kind));
  }
  /// Real `plane` of the primitive in `slot`, of a kind that has `planes` of them.
  [[nodiscard]] Real plane(const std::string& kind, int slot, int plane, int planes) const {
    const int block = slot / lanes;
    return packed.geometry.at(
        static_cast<std::size_t>(row(kind, layout::SHAPE_GEOMETRY) + (block * planes + plane) * lanes + slot % lanes));
  }
  [[nodiscard]] Ints part(int number) const {
    return ints(header(layout::HEADER_PARTS) + number * layout::PART_INTS, layout::PART_INTS);
  }
};

Mesh two_triangles() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  return mesh;
}

Cube unit_cube() { return {{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }

}  // namespace

TEST_CASE("Ids count the primitives of the scene in file order") {
  Scene scene;
  for (const Geometry& geometry :
       {Geometry(Sphere{}), Geometry(unit_cube()), Geometry(two_triangles()), Geometry(Plane{})})
    add(scene, geometry);
  CHECK(first_ids(scene) == std::vector<std::int64_t>{0, 1, 7, 9, 10});
  CHECK(first_ids(Scene{}) == std::vector<std::int64_t>{0});
}

TEST_CASE("Blocks are plane-major, and what fills the last one up has no id") {
  Scene scene;
  for (int i = 0; i < 10; ++i) add(scene, Sphere{{i + 0.25, i + 0.5, i + 0.75}, i + 1.0});
  for (const int lanes : {1, 8, 16}) {
    const Read<double> read(scene, {lanes, {}});
    const int blocks = lanes == 1 ? 10 : lanes == 8 ? 2 : 1;
    REQUIRE(read.row("sphere", layout::SHAPE_BLOCKS) == blocks);
    CHECK(read.packed.geometry.size() == static_cast<std::size_t>(blocks * lanes * 4 + 6));  // and their bounds
    const Ints ids = read.ids("sphere"), parts = read.parts_of("sphere");
    for (int slot = 0; slot < blocks * lanes; ++slot) {
      INFO(lanes << " lanes, slot " << slot);
      const bool used = slot < 10;
      CHECK(ids[static_cast<std::size_t>(slot)] == (used ? slot : -1));
      CHECK(parts[static_cast<std::size_t>(slot)] == (used ? slot : 0));
      CHECK(read.plane("sphere", slot, 0, 4) == (used ? slot + 0.25 : 0));
      CHECK(read.plane("sphere", slot, 2, 4) == (used ? slot + 0.75 : 0));
      CHECK(read.plane("sphere", slot, 3, 4) == (used ? slot + 1 : 0));
    }
  }
}

TEST_CASE("Kinds that alternate in a scene stand apart in the buffers and keep their ids") {
  Scene scene;
  add(scene, Sphere{{0, 0, 0}, 1});
  add(scene, unit_cube());
  add(scene, Sphere{{5, 0, 0}, 2});
  add(scene, Rectangle{{9, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Read<double> read(scene, {8, {}});
  CHECK(read.ids("sphere") == Ints{0, 7, -1, -1, -1, -1, -1, -1});
  CHECK(read.ids("parallelogram") == Ints{1, 2, 3, 4, 5, 6, 8, -1});
  CHECK(read.parts_of("sphere") == Ints{0, 2, 0, 0, 0, 0, 0, 0});
  CHECK(read.parts_of("parallelogram") == Ints{1, 1, 1, 1, 1, 1, 3, 0});
  CHECK(read.packed.geometry.size() == 8 * (4 + 12) + 6);
  CHECK(read.plane("sphere", 1, 0, 4) == 5);
  CHECK(read.plane("parallelogram", 6, 0, 12) == 9);
}

TEST_CASE("The header says what a program does not know: width, seed, depth") {
  Scene scene;
  add(scene, Sphere{});
  scene.film.width = 640;
  scene.sampler.seed = 77;
  scene.integrator.max_depth = 5;
  const Read<double> read(scene, {1, {}});
  CHECK(read.header(layout::HEADER_WIDTH) == 640);
  CHECK(read.header(layout::HEADER_SEED) == 77);
  CHECK(read.header(layout::HEADER_INTEGRATOR) == 0);  // the only one in the program
  CHECK(read.header(layout::HEADER_MAX_DEPTH) == 5);
  CHECK(read.header(layout::HEADER_HIDE_EMITTERS) == 0);
  CHECK(read.shading(read.header(layout::HEADER_FILTER), layout::FILTER_CELLS + 1) ==
        filter_quantiles(scene.film.filter, SamplerKind::independent));
  CHECK(read.shading(read.header(layout::HEADER_CAMERA) + layout::CAMERA_D, 3) == Reals{0, 0, 1});

  CHECK(read.header(layout::HEADER_STRICT_NORMALS) == 0);
  scene.integrator.hide_emitters = scene.integrator.strict_normals = true;
  RenderSettings generic;
  generic.generic = true;
  const Read<double> all(scene, {1, {}}, generic);
  CHECK(all.header(layout::HEADER_HIDE_EMITTERS) == 1);
  CHECK(all.header(layout::HEADER_STRICT_NORMALS) == 1);
  const std::vector<std::string> integrators = list_entries("integrators");
  CHECK(integrators.at(static_cast<std::size_t>(all.header(layout::HEADER_INTEGRATOR))) == "direct");
}

TEST_CASE("Every shape has a part: its look and its frame") {
  Scene scene;
  const int red = add(scene, Diffuse{{{0.75, 0.5, 0.25}}});
  add(scene, Box{{0, 0, 0}, {1, 1, 1}}, red);
  Shape lamp = emitting(Sphere{{0, 0, 0}, 1, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}}, {3, 4, 5});
  lamp.flip_normals = true;
  add(scene, lamp);
  const Read<double> read(scene, {8, {}});
  CHECK(read.part(0) == Ints{0, 0, red, -1, -1, -1, 0, -1, -1, -1, -1, -1, -1});
  const Ints part = read.part(1);
  CHECK(part[layout::PART_SHAPE] == 1);
  CHECK(part[layout::PART_FIRST_ID] == 1);
  CHECK(part[layout::PART_MATERIAL] == 0);
  CHECK(read.shading(part[layout::PART_RADIANCE], 3) == Reals{3, 4, 5});
  CHECK(part[layout::PART_FLIP] == 1);
  CHECK(read.shading(part[layout::PART_AXES], 9) == Reals{0, 1, 0, 0, 0, 1, 1, 0, 0});

  const Ints material =
      read.ints(read.header(layout::HEADER_MATERIALS) + red * layout::MATERIAL_INTS, layout::MATERIAL_INTS);
  CHECK(material[layout::MATERIAL_KIND] == 0);
  CHECK(read.shading(material[layout::MATERIAL_SLOTS], 3) == Reals{0.75, 0.5, 0.25});
  CHECK(material[layout::MATERIAL_BACK] == -1);
}

TEST_CASE("A texture has its row, and shapes then say how fast u and v change") {
  Scene scene;
  scene.textures = {{"", Checkerboard{{1, 0.5, 0.25}, {0, 0.125, 0}, {2, 3, 4, 5, 6, 7}}, {}}};
  const int tiles = add(scene, Conductor{{{1, 1, 1}, 0}});
  add(scene, Rectangle{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, tiles);
  add(scene, Sphere{{0, 0, 0}, 2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, tiles);
  const Read<double> read(scene, {8, {}});
  const Ints material =
      read.ints(read.header(layout::HEADER_MATERIALS) + tiles * layout::MATERIAL_INTS, layout::MATERIAL_INTS);
  CHECK(material[layout::MATERIAL_KIND] == read.features.entry_index("materials", "conductor"));
  CHECK(material[layout::MATERIAL_SLOTS] == ~0);
  const Ints texture = read.ints(read.header(layout::HEADER_TEXTURES), layout::TEXTURE_INTS);
  CHECK(texture[layout::TEXTURE_KIND] == 0);
  CHECK(read.shading(texture[layout::TEXTURE_REALS], 12) == Reals{1, 0.5, 0.25, 0, 0.125, 0, 2, 3, 4, 5, 6, 7});
  CHECK(texture[layout::TEXTURE_FILTER] == 8);
  scene.sampler.kind = SamplerKind::centre;
  const Read<double> centred(scene, {8, {}});
  CHECK(centred.ints(centred.header(layout::HEADER_TEXTURES), layout::TEXTURE_INTS)[layout::TEXTURE_FILTER] == 1);
  CHECK(read.shading(read.part(0)[layout::PART_UV_RATES], 2) == Reals{0.25, 0.5});
  const Reals sphere = read.shading(read.part(1)[layout::PART_UV_RATES], 2);
  CHECK(sphere[0] == Approx(0.25 * std::numbers::inv_pi));
  CHECK(sphere[1] == Approx(0.5 * std::numbers::inv_pi));
}

TEST_CASE("A mesh has a part for each of its materials, and its triangles know theirs") {
  Scene scene;
  const int sheet = add(scene, Diffuse{}, true);
  add(scene, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  Mesh mesh = two_triangles();
  mesh.triangles.push_back({0, 1, 3});
  mesh.parts = {{0, {}}, {sheet, Rgb{1, 2, 3}}};
  mesh.part_of_triangle = {1, 0, 1};
  add(scene, mesh);
  add(scene, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Read<double> read(scene, {8, {}});
  CHECK(read.ids("triangle") == Ints{0, 1, 2, 3, 4, -1, -1, -1});
  CHECK(read.parts_of("triangle") == Ints{0, 2, 1, 2, 3, 0, 0, 0});
  CHECK(read.part(1) == Ints{1, 1, 0, -1, -1, -1, 0, -1, -1, -1, -1, -1, -1});
  CHECK(read.part(2)[layout::PART_SHAPE] == 1);
  CHECK(read.part(2)[layout::PART_FIRST_ID] == 1);
  CHECK(read.part(2)[layout::PART_MATERIAL] == sheet);
  CHECK(read.shading(read.part(2)[layout::PART_RADIANCE], 3) == Reals{1, 2, 3});
  CHECK(read.part(3) == Ints{2, 4, 0, -1, -1, -1, 0, -1, -1, -1, -1, -1, -1});
}

TEST_CASE("Lights with textures: their rows, texture coordinates of their places, and power by the mean") {
  Scene scene;
  scene.integrator.name = "path";
  Texture board{"", Checkerboard{{6, 6, 6}, {2, 2, 2}}, {}};
  board.is_unbounded = true;
  scene.textures = {Texture{"", Checkerboard{}, {}}, board};
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.uvs = {{0.5, 0.25}, {1, 0.25}, {0.5, 1}};
  mesh.triangles = {{0, 1, 2}};
  for (const Geometry& geometry : {Geometry(mesh), Geometry(Box{{0, 0, 0}, {1, 1, 1}}), Geometry(Sphere{})}) {
    Shape shape = emitting(geometry, {1, 2, 3});
    shape.radiance_texture = 1;
    add(scene, shape);
  }
  add(scene, emitting(Sphere{}, {4, 8, 12}));
  const auto light = [&](const Read<double>& read, int i) {
    return read.ints(read.header(layout::HEADER_LIGHTS) + i * layout::LIGHT_INTS, layout::LIGHT_INTS);
  };
  const Read<double> read(scene, {1, {}});
  REQUIRE(read.header(layout::HEADER_LIGHT_COUNT) == 4);
  for (int i = 0; i < 4; ++i) {
    CHECK(light(read, i)[layout::LIGHT_TEXTURE] == (i < 3 ? 1 : -1));
    CHECK(read.part(i)[layout::PART_GLOW] == (i < 3 ? 1 : -1));
  }
  CHECK(read.shading(light(read, 0)[layout::LIGHT_UVS], 6) == Reals{0.5, 0.25, 0.5, 0, 0, 0.75});
  CHECK(read.shading(light(read, 1)[layout::LIGHT_UVS], 36) == Reals(36, 0));
  CHECK(read.shading(light(read, 2)[layout::LIGHT_UVS], 9) == Reals{1, 0, 0, 0, 1, 0, 0, 0, 1});
  CHECK(light(read, 3)[layout::LIGHT_UVS] == -1);
  // The two spheres are as bright on the average: a texture of mean 4 on 1, 2, 3.
  RenderSettings by_power;
  by_power.light_choice = "power";
  const Read<double> powers(scene, {1, {}}, by_power);
  const Reals rarities = powers.shading(powers.header(layout::HEADER_CHANCES), 4);
  CHECK(rarities[2] == Approx(rarities[3]));
  RenderSettings plain;
  plain.disabled = {"textures/checkerboard"};
  const Read<double> even(scene, {1, {}}, plain);
  CHECK(light(even, 2)[layout::LIGHT_TEXTURE] == -1);
  CHECK(even.shading(light(even, 2)[layout::LIGHT_REALS], 3) == Reals{4, 8, 12});
  CHECK(even.shading(even.part(2)[layout::PART_RADIANCE], 3) == Reals{4, 8, 12});
}

TEST_CASE("Vertex normals and texture coordinates are there for the programs that use them") {
  Scene scene;
  Mesh mesh = two_triangles();
  mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  mesh.uvs = {{0, 0}, {0.25, 0}, {0, 0.5}, {0.75, 1}};
  add(scene, mesh);
  RenderSettings settings;
  settings.aovs = {Aov::uv};
  const Read<double> read(scene, {8, {}}, settings);
  CHECK(read.shading(read.part(0)[layout::PART_NORMALS], 18) ==
        Reals{0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 1, 0, 0});
  CHECK(read.shading(read.part(0)[layout::PART_UVS], 12) == Reals{0, 0, 0.25, 0, 0, 0.5, 0.25, 0, 0.75, 1, 0, 0.5});

  scene.integrator.name = "emission";
  const Read<double> bare(scene, {8, {}});
  CHECK(bare.part(0)[layout::PART_NORMALS] == -1);
  CHECK(bare.part(0)[layout::PART_UVS] == -1);
}

TEST_CASE("Lights: those that the program knows, numbered as it numbers them") {
  Scene scene;
  add(scene, Sphere{});
  add(scene, ConstantLight{{1, 2, 3}});
  add(scene, PointLight{{1e9 + 0.5, 2, 3}, {4, 5, 6}});
  add(scene, DirectionalLight{{0, 0, -8}, {7, 8, 9}});
  const Read<double> read(scene, {1, {1e9, 0, 0}});
  REQUIRE(read.header(layout::HEADER_LIGHT_COUNT) == 2);
  const auto light = [&](int i) {
    return read.ints(read.header(layout::HEADER_LIGHTS) + i * layout::LIGHT_INTS, layout::LIGHT_INTS);
  };
  CHECK(light(0)[layout::LIGHT_KIND] == read.features.entry_index("lights", "point"));
  CHECK(read.shading(light(0)[layout::LIGHT_REALS], 6) == Reals{0.5, 2, 3, 4, 5, 6});
  CHECK(light(1)[layout::LIGHT_KIND] == read.features.entry_index("lights", "directional"));
  CHECK(read.shading(light(1)[layout::LIGHT_REALS], 6) == Reals{0, 0, -1, 7, 8, 9});
  CHECK(light(2)[layout::LIGHT_KIND] == read.features.entry_index("lights", "constant"));
  CHECK(read.shading(light(2)[layout::LIGHT_REALS], 3) == Reals{1, 2, 3});
  CHECK(read.header(layout::HEADER_BACKGROUND) == 2);  // Behind those that are counted: it is found, not drawn.
  CHECK(read.header(layout::HEADER_LIGHTS_TAKEN) == 2);
  CHECK(read.features.entries.at("choosers").empty());

  // Nothing but drawing finds it there.
  scene.integrator.name = "whitted";
  const Read<double> drawn(scene, {1, {}});
  CHECK(drawn.header(layout::HEADER_LIGHT_COUNT) == 3);
  CHECK(drawn.header(layout::HEADER_BACKGROUND) == 2);
  CHECK(drawn.header(layout::HEADER_LIGHTS_TAKEN) == 2);
  for (const char* name : {"path", "volpath", "bdpt", "ptracer"}) {
    INFO(name);
    scene.integrator.name = name;
    const Read<double> paths(scene, {1, {}});
    CHECK(paths.header(layout::HEADER_LIGHT_COUNT) == (kinds::integrator(name).from_lights ? 3 : 2));
    CHECK(paths.header(layout::HEADER_BACKGROUND) == 2);
    CHECK(paths.header(layout::HEADER_LIGHTS_TAKEN) == 0);
  }

  scene.integrator.name = "emission";
  const Read<double> seen(scene, {1, {}});
  REQUIRE(seen.header(layout::HEADER_LIGHT_COUNT) == 1);
  CHECK(seen.shading(seen.ints(seen.header(layout::HEADER_LIGHTS), 2)[layout::LIGHT_REALS], 3) == Reals{1, 2, 3});
}

TEST_CASE("Area lights: one a part that emits, in the frame's units, and the part knows it") {
  Scene scene;
  add(scene, PointLight{});
  add(scene, Sphere{});
  add(scene, emitting(plane_through({0, 0, 0}, {0, 0, 1}), {9, 9, 9}));
  add(scene, emitting(Rectangle{{1, 0, 0}, {2, 0, 0}, {0, 3, 0}}, {1, 2, 3}));
  Shape inward = emitting(Sphere{{0, 0, 5}, 2}, {4, 5, 6});
  inward.flip_normals = true;
  add(scene, inward);
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}};
  mesh.parts = {{0, {}}, {0, Rgb{7, 8, 9}}};
  mesh.part_of_triangle = {1, 0, 1};
  add(scene, mesh);
  const Read<double> read(scene, {1, {{1, 0, 0}, 2}});
  REQUIRE(read.header(layout::HEADER_LIGHT_COUNT) == 4);
  CHECK(read.header(layout::HEADER_LIGHTS_TAKEN) == 1);
  CHECK(read.header(layout::HEADER_GLOWS) == 1);
  CHECK(read.header(layout::HEADER_BACKGROUND) == -1);
  std::vector<int> lights;
  for (int part = 0; part < 6; ++part) lights.push_back(read.part(part)[layout::PART_LIGHT]);
  CHECK(lights == std::vector{-1, -1, 1, 2, -1, 3});
  const auto light = [&](int i) {
    return read.ints(read.header(layout::HEADER_LIGHTS) + i * layout::LIGHT_INTS, layout::LIGHT_INTS);
  };
  const auto area = [&](const std::string& name) { return read.features.entry_index("areas", name); };
  CHECK(light(1)[layout::LIGHT_AREA] == area("parallelogram"));
  CHECK(read.shading(light(1)[layout::LIGHT_REALS], 17) ==
        Reals{1, 2, 3, 1.0 / 24, 1, 0, 0, 0, 4, 0, 0, 0, 6, 0, 0, 0, 1});
  CHECK(light(1)[layout::LIGHT_FIRST_ID] == 2);
  CHECK(light(2)[layout::LIGHT_FIRST_ID] == 3);   // A sphere: shadow rays do not ask the lamp that they go to.
  CHECK(light(3)[layout::LIGHT_FIRST_ID] == -1);  // Some of the mesh's triangles, not all.
  CHECK(light(2)[layout::LIGHT_AREA] == area("sphere"));
  CHECK(read.shading(light(2)[layout::LIGHT_REALS] + layout::AREA_SIDE, 5) == Reals{-1, -2, 0, 10, 4});
  CHECK(light(3)[layout::LIGHT_AREA] == area("triangle"));
  CHECK(light(3)[layout::LIGHT_ITEMS] == 2);
  // Areas 2 and 6 in the frame: the first has a quarter of the numbers, and the second half of them begins in the
  // other.
  CHECK(read.shading(light(3)[layout::LIGHT_REALS] + layout::AREA_INVERSE, 1) == Reals{1.0 / 8});
  CHECK(read.ints(light(3)[layout::LIGHT_CHOICE], 2 * layout::CHOICE_INTS) == Ints{0x3fffffff, 0, -1, 1});
  scene.integrator.name = "path";
  CHECK(Read<double>(scene, {1, {}}).header(layout::HEADER_LIGHTS_TAKEN) == 0);
}

TEST_CASE("Numbers are rounded once, after the frame's origin is subtracted in double") {
  Scene scene;
  add(scene, Sphere{{1e9 + 0.125, 0.1, -1e9 - 0.25}, 0.7});
  const Read<float> read(scene, {1, {1e9, 0, -1e9}});
  CHECK(read.plane("sphere", 0, 0, 4) == 0.125F);
  CHECK(read.plane("sphere", 0, 1, 4) == 0.1F);
  CHECK(read.plane("sphere", 0, 2, 4) == -0.25F);
  CHECK(read.plane("sphere", 0, 3, 4) == 0.7F);
}

TEST_CASE("In the world frame what the precision holds arrives unrounded") {
  Scene scene;
  add(scene, plane_through({0.1F, -3, 16777215}, {0.3F, 5, 0}));
  const Read<float> single(scene, {1, {}});
  CHECK(single.plane("plane", 0, 0, 6) == 0.1F);
  CHECK(single.plane("plane", 0, 2, 6) == 16777215.0F);
  CHECK(single.plane("plane", 0, 4, 6) == 1.25F);
  std::get<Plane>(scene.shapes[0].geometry).point = {0.1, 1.0 / 3, 1e300};
  const Read<double> twice(scene, {1, {}});
  CHECK(twice.plane("plane", 0, 0, 6) == 0.1);
  CHECK(twice.plane("plane", 0, 1, 6) == 1.0 / 3);
  CHECK(twice.plane("plane", 0, 2, 6) == 1e300);
}

TEST_CASE("A scene without shapes is a header and its tables") {
  const Read<float> read(Scene{}, {8, {}});
  CHECK(read.packed.geometry.size() == 6);  // the bounds of nothing
  CHECK(read.header(layout::HEADER_LIGHT_COUNT) == 0);
  CHECK(read.packed.bytes() == 4 * (6 + read.packed.shading.size() + read.packed.index.size()));
}
