// SPDX-License-Identifier: MIT
// What calls for each effect, what does not, and the place that `strahl explain` then names.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "kinds/entries.h"
#include "kinds/lights.h"
#include "program/each_kind.h"
#include "program/features.h"

using namespace strahl;
using namespace strahl::test;

namespace {
SourceLocation line(int number) { return {"scene.xml", number, 3}; }

/// A scene of one shape whose elements stand in lines of their own.
Scene scene_of(Geometry geometry, const std::string& integrator = "direct") {
  Scene scene;
  scene.integrator.name = integrator;
  scene.integrator.where = line(2);
  scene.sampler.where = line(4);
  Shape shape;
  shape.geometry = std::move(geometry);
  shape.where = line(10);
  shape.radiance_where = line(11);
  scene.shapes.push_back(shape);
  return scene;
}

FeatureReport report(const Features& features, const std::string& name) {
  const auto found = std::find_if(features.report.begin(), features.report.end(),
                                  [&](const FeatureReport& row) { return row.name == name; });
  REQUIRE(found != features.report.end());
  return *found;
}

void check_on(const Scene& scene, const RenderSettings& settings, const std::string& name, int at_line,
              const std::string& why) {
  INFO(name);
  const FeatureReport row = report(features_of(scene, settings), name);
  CHECK(row.on);
  CHECK(row.why == why);
  CHECK(row.where.line == at_line);
  CHECK(row.where.file == (at_line > 0 ? "scene.xml" : ""));
}

void check_off(const Scene& scene, const RenderSettings& settings, const std::string& name) {
  INFO(name << " under " << scene.integrator.name);
  const FeatureReport row = report(features_of(scene, settings), name);
  CHECK_FALSE(row.on);
  CHECK(row.where.line == 0);
}

RenderSettings with_aovs(const std::set<Aov>& aovs) {
  RenderSettings settings;
  settings.aovs = aovs;
  return settings;
}

}  // namespace

TEST_CASE("A shape calls for its own kind and no other") {
  for (const std::string& kind : list_entries("shapes")) {
    INFO(kind);
    REQUIRE(geometries().contains(kind));
    for (const Geometry& geometry : geometries().at(kind)) {
      const Scene scene = scene_of(geometry);
      check_on(scene, {}, "shapes/" + kind, 10, "a shape made of " + kind + " primitives");
      for (const std::string& other : list_entries("shapes"))
        if (other != kind) check_off(scene, {}, "shapes/" + other);
    }
  }
}

TEST_CASE("The first element that calls for an effect is the one reported") {
  Scene scene = scene_of(Sphere{});
  scene.shapes.push_back(scene.shapes[0]);
  scene.shapes[1].where = line(20);
  check_on(scene, {}, "shapes/sphere", 10, "a shape made of sphere primitives");
}

TEST_CASE("Materials count where something reflects; a material without a place is its shape's") {
  Scene scene = scene_of(Sphere{});
  check_on(scene, {}, "materials/diffuse", 10, "material of type diffuse");
  scene.materials[0].where = line(7);
  check_on(scene, {}, "materials/diffuse", 7, "material of type diffuse");
  for (const char* integrator : {"emission", "depth", "normals"}) {
    scene.integrator.name = integrator;
    check_off(scene, {}, "materials/diffuse");
  }
}

TEST_CASE("Mirrors and textures count where a shape has them") {
  Scene scene = scene_of(Sphere{}, "whitted");
  scene.textures.push_back({"", Checkerboard{}, line(6)});
  scene.materials.push_back({"", Conductor{}, false, line(7)});
  scene.materials.push_back({"", Diffuse{{{}, 0}}, false, line(8)});
  for (const char* effect : {"materials/conductor", "textures/checkerboard"}) check_off(scene, {}, effect);
  scene.shapes[0].material = 1;
  check_on(scene, {}, "materials/conductor", 7, "material of type conductor");
  check_off(scene, {}, "textures/checkerboard");
  scene.shapes[0].material = 2;
  const std::string why = "a reflectance from a texture of type checkerboard";
  check_on(scene, {}, "textures/checkerboard", 6, why);
  check_off(scene, {}, "MESH_UVS");

  Mesh mesh = small_mesh();
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  scene.shapes[0].geometry = mesh;
  check_on(scene, {}, "MESH_UVS", 10, "a mesh with texture coordinates, for its textures");
  scene.integrator.name = "normals";
  for (const char* effect : {"materials/diffuse", "textures/checkerboard", "MESH_UVS"}) check_off(scene, {}, effect);
}

TEST_CASE("BRANCHES and PRIORITY: glass, under whitted or by a shape's priority; it has two sides by itself") {
  Scene scene = scene_of(Sphere{}, "path");
  scene.materials.push_back({"glass", Dielectric{}, true, line(7)});
  scene.shapes[0].material = 1;
  for (const char* effect : {"BRANCHES", "PRIORITY", "TWOSIDED"}) check_off(scene, {}, effect);
  check_on(scene, {}, "materials/dielectric", 7, "material of type dielectric");
  scene.shapes[0].priority = 0;
  check_on(scene, {}, "PRIORITY", 10, "a shape with a priority");
  scene.integrator.name = "whitted";
  check_on(scene, {}, "BRANCHES", 7, "a material that reflects and transmits");
  scene.materials[1].bsdf = Conductor{};
  check_off(scene, {}, "BRANCHES");
  scene.integrator.name = "normals";
  check_off(scene, {}, "PRIORITY");
}

TEST_CASE("TWOSIDED: a twosided material that a shape or a part of a mesh uses") {
  Scene scene = scene_of(Sphere{});
  scene.materials.push_back({"sheet", Diffuse{}, true, line(7)});
  check_off(scene, {}, "TWOSIDED");
  scene.shapes[0].material = 1;
  check_on(scene, {}, "TWOSIDED", 7, "a twosided material");
  scene.integrator.name = "emission";
  check_off(scene, {}, "TWOSIDED");

  Mesh mesh = small_mesh();
  mesh.parts = {{1, {}}};
  mesh.part_of_triangle = {0};
  scene.shapes[0] = scene_of(mesh).shapes[0];
  scene.integrator.name = "direct";
  check_on(scene, {}, "TWOSIDED", 7, "a twosided material");
  std::get<Mesh>(scene.shapes[0].geometry).parts[0].material = 0;
  scene.shapes[0].material = 1;  // the parts' materials stand in its place
  check_off(scene, {}, "TWOSIDED");
}

TEST_CASE("EMISSION: an emitter that the integrator shows") {
  Scene scene = scene_of(Sphere{});
  check_off(scene, {}, "EMISSION");
  scene.shapes[0].radiance = Rgb{1, 1, 1};
  check_on(scene, {}, "EMISSION", 11, "an area emitter");
  scene.integrator.name = "emission";
  check_on(scene, {}, "EMISSION", 11, "an area emitter");
  for (const char* integrator : {"depth", "normals"}) {
    scene.integrator.name = integrator;
    check_off(scene, {}, "EMISSION");
  }
  Mesh mesh = small_mesh();
  mesh.parts = {{0, Rgb{1, 2, 3}}};
  mesh.part_of_triangle = {0};
  check_on(scene_of(mesh), {}, "EMISSION", 10, "a mesh material that emits");
}

TEST_CASE("SMOOTH_NORMALS: vertex normals where a picture shows them") {
  Mesh mesh = small_mesh();
  check_off(scene_of(mesh), {}, "SMOOTH_NORMALS");
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  const std::string why = "a mesh with vertex normals";
  check_on(scene_of(mesh, "direct"), {}, "SMOOTH_NORMALS", 10, why);
  check_on(scene_of(mesh, "normals"), {}, "SMOOTH_NORMALS", 10, why);
  check_off(scene_of(mesh, "emission"), {}, "SMOOTH_NORMALS");
  check_off(scene_of(mesh, "depth"), with_aovs({Aov::depth, Aov::uv}), "SMOOTH_NORMALS");
  check_on(scene_of(mesh, "depth"), with_aovs({Aov::normal}), "SMOOTH_NORMALS", 10, why);
}

TEST_CASE("MESH_UVS: texture coordinates that --aov uv asks for") {
  Mesh mesh = small_mesh();
  check_off(scene_of(mesh), with_aovs({Aov::uv}), "MESH_UVS");
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  check_off(scene_of(mesh), with_aovs({Aov::normal}), "MESH_UVS");
  check_on(scene_of(mesh), with_aovs({Aov::uv}), "MESH_UVS", 10, "a mesh with texture coordinates, for --aov uv");
}

TEST_CASE("Lights count where the integrator sees them") {
  const auto emitters = every_emitter();
  // And those of shapes, area and directionalarea.
  REQUIRE(emitters.size() + 2 == list_entries("lights").size());
  for (const auto& emitter : emitters) {
    const Light light{"", emitter, line(15)};
    const std::string kind = light_kind(light);
    if (kinds::light(light).is_beam) continue;  // test_beams.cpp
    Scene scene = scene_of(Sphere{});
    check_off(scene, {}, "lights/" + kind);
    scene.lights.push_back(light);
    const std::string why = "an emitter of type " + kind;
    check_on(scene, {}, "lights/" + kind, 15, why);
    scene.integrator.name = "emission";
    if (kinds::light(light).is_background)
      check_on(scene, {}, "lights/" + kind, 15, why);
    else
      check_off(scene, {}, "lights/" + kind);
    for (const char* integrator : {"depth", "normals"}) {
      scene.integrator.name = integrator;
      check_off(scene, {}, "lights/" + kind);
    }
  }
}

TEST_CASE("An area emitter is a light where something is lit, drawn from by its own shape") {
  for (const auto& [kind, shapes] : geometries()) {
    for (const Geometry& geometry : shapes) {
      Scene scene = scene_of(geometry, "path");
      check_off(scene, {}, "lights/area");
      scene.shapes[0].radiance = Rgb{1, 1, 1};
      const std::string area = area_kind(geometry);
      if (area.empty()) {
        check_off(scene, {}, "lights/area");
        continue;
      }
      check_on(scene, {}, "lights/area", 11, "an area emitter");
      check_on(scene, {}, "areas/" + area, 11, "an area emitter on a " + kind);
      for (const std::string& other : list_entries("areas"))
        if (other != area) check_off(scene, {}, "areas/" + other);
      scene.integrator.name = "emission";
      check_off(scene, {}, "lights/area");
      check_off(scene, {}, "areas/" + area);
    }
  }
}

TEST_CASE("A sampler is there where samples draw numbers, one of them") {
  const std::string why = "numbers that samples draw";
  Scene scene = scene_of(Sphere{});
  scene.sampler.kind = SamplerKind::independent;
  check_on(scene, {}, "samplers/independent", 4, why);
  check_off(scene, {}, "samplers/sobol");
  scene.sampler.kind = SamplerKind::sobol;
  check_on(scene, {}, "samplers/sobol", 4, why);
  check_off(scene, {}, "samplers/independent");
  scene.sampler.kind = SamplerKind::centre;
  check_off(scene, {}, "samplers/sobol");
  scene.integrator.name = "path";
  check_on(scene, {}, "samplers/sobol", 4, why);
  scene.integrator.name = "direct";
  scene.shapes[0].radiance = Rgb{1, 1, 1};
  check_on(scene, {}, "samplers/sobol", 4, why);
}

TEST_CASE("OPENNESS: ambient occlusion, which knows neither materials nor lights") {
  Scene scene = scene_of(Sphere{});
  scene.shapes[0].radiance = Rgb{1, 1, 1};
  scene.lights.push_back({"", ConstantLight{}, line(15)});
  check_off(scene, {}, "OPENNESS");
  scene.integrator.name = "ao";
  check_on(scene, {}, "OPENNESS", 2, "integrator ao");
  check_on(scene, {}, "samplers/sobol", 4, "numbers that samples draw");
  for (const char* effect : {"EMISSION", "lights/constant", "lights/area", "materials/diffuse"})
    check_off(scene, {}, effect);
}

TEST_CASE("One integrator at a time") {
  for (const std::string& integrator : list_entries("integrators")) {
    const Scene scene = scene_of(Sphere{}, integrator);
    check_on(scene, {}, "integrators/" + integrator, 2, "integrator " + integrator);
    for (const std::string& other : list_entries("integrators"))
      if (other != integrator) check_off(scene, {}, "integrators/" + other);
  }
}

TEST_CASE("PIXEL_FILTER: unless every sample is asked to be in its pixel's middle, and whatever their number") {
  const std::string why = "samples anywhere but at the pixels' centres";
  Scene scene = scene_of(Sphere{});
  scene.sampler.where = line(4);
  for (const int spp : {1, 9}) {
    scene.sampler.sample_count = spp;
    check_on(scene, {}, "PIXEL_FILTER", 4, why);
  }
  scene.sampler.kind = SamplerKind::independent;
  check_on(scene, {}, "PIXEL_FILTER", 4, why);
  scene.sampler.kind = SamplerKind::centre;
  check_off(scene, {}, "PIXEL_FILTER");
}

TEST_CASE("HIDE_EMITTERS: where there is an emitter that the integrator would show") {
  Scene scene = scene_of(Sphere{});
  scene.integrator.hide_emitters = true;
  check_off(scene, {}, "HIDE_EMITTERS");
  scene.shapes[0].radiance = Rgb{1, 1, 1};
  check_on(scene, {}, "HIDE_EMITTERS", 2, "the integrator's hide_emitters");
  scene.integrator.name = "emission";
  check_on(scene, {}, "HIDE_EMITTERS", 2, "the integrator's hide_emitters");
  scene.integrator.name = "normals";
  check_off(scene, {}, "HIDE_EMITTERS");
  scene.integrator.name = "direct";
  scene.integrator.hide_emitters = false;
  check_off(scene, {}, "HIDE_EMITTERS");
  Scene sky = scene_of(Sphere{});
  sky.integrator.hide_emitters = true;
  sky.lights.push_back({{}, ConstantLight{{1, 1, 1}}, {}});
  check_on(sky, {}, "HIDE_EMITTERS", 2, "the integrator's hide_emitters");
}

TEST_CASE("AOV and COUNT_RAYS are called for by options") {
  const Scene scene = scene_of(Sphere{});
  check_off(scene, {}, "AOV");
  check_on(scene, with_aovs({Aov::shape_id}), "AOV", 0, "--aov");
  RenderSettings counting;
  check_off(scene, counting, "COUNT_RAYS");
  counting.count_rays = true;
  check_on(scene, counting, "COUNT_RAYS", 0, "--stats-detail");
}

TEST_CASE("LOOP_LIMIT: on devices that end long loops") {
  const Scene scene = scene_of(Sphere{});
  RenderSettings settings;
  check_off(scene, settings, "LOOP_LIMIT");
  settings.loop_turns = 65534;
  check_on(scene, settings, "LOOP_LIMIT", 0, "a device that ends long loops");
}

TEST_CASE("ERROR_SUMS: wherever the error is to be estimated") {
  const Scene scene = scene_of(Sphere{});
  check_on(scene, {}, "ERROR_SUMS", 0, "the estimate of the picture's error");
  RenderSettings settings;
  settings.estimate_error = false;
  check_off(scene, settings, "ERROR_SUMS");
}

TEST_CASE("The report lists every entry and every flag, lists first, each in its file's order") {
  const Features features = features_of(scene_of(Sphere{}), {});
  std::vector<std::string> expected, reported;
  std::map<std::string, std::string> purposes;
  for (const std::string& list : list_folders())
    for (const std::string& entry : list_entries(list)) expected.push_back(list + "/" + entry);
  for (const auto& [flag, purpose] : list_features()) {
    expected.push_back(flag);
    purposes[flag] = purpose;
  }
  for (const FeatureReport& row : features.report) {
    reported.push_back(row.name);
    if (!row.on && purposes.contains(row.name)) CHECK(row.why == purposes[row.name]);
    const auto slash = row.name.find('/');
    const bool on = slash == std::string::npos ? features.flag(row.name)
                                               : features.has(row.name.substr(0, slash), row.name.substr(slash + 1));
    CHECK(on == row.on);
  }
  CHECK(reported == expected);
  CHECK_THROWS_AS(features.flag("NO_SUCH_FLAG"), std::logic_error);
}

TEST_CASE("Entries are numbered among the active ones, as the program's enumerators are") {
  Scene scene = scene_of(Disk{});
  scene.shapes.push_back(scene_of(Plane{}).shapes[0]);
  const Features features = features_of(scene, {});
  CHECK(features.entry_index("shapes", "plane") == 0);
  CHECK(features.entry_index("shapes", "disk") == 1);
  CHECK(features.entry_index("shapes", "sphere") == -1);
  CHECK_THROWS_AS(features.entry_index("shapes", "torus"), std::logic_error);
}

TEST_CASE("--generic is why, but for what the scene calls for") {
  const Scene scene = scene_of(Sphere{});
  RenderSettings settings;
  settings.generic = true;
  check_on(scene, settings, "shapes/disk", 0, "--generic");
  check_on(scene, settings, "shapes/sphere", 10, "a shape made of sphere primitives");
  settings.count_rays = true;
  check_on(scene, settings, "COUNT_RAYS", 0, "--stats-detail");
}

TEST_CASE("instances are called for where a group stands, not where there is a group") {
  Scene scene = scene_of(Sphere{});
  scene.groups.emplace_back().shapes = scene.shapes;
  check_off(scene, {}, "INSTANCES");
  scene.instances.emplace_back().where = line(12);
  check_on(scene, {}, "INSTANCES", 12, "an instance of a group");
}
