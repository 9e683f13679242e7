// SPDX-License-Identifier: MIT
// A picture that will be empty is told before it is rendered; one that will not is not.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "render/aov.h"
#include "render/limitations.h"

using namespace strahl;

namespace {

Scene scene_of(const std::string& integrator) {
  Scene scene;
  scene.integrator.name = integrator;
  scene.shapes.emplace_back().geometry = Sphere{};
  return scene;
}

/// What is said of an empty picture, or nothing.
std::string emptiness(const Scene& scene) {
  for (const Diagnostic& warning : limitations(scene))
    if (warning.message.find("emits light") != std::string::npos ||
        warning.message.find("no shape") != std::string::npos)
      return warning.message;
  return {};
}

const char* const lit_integrators[] = {"direct", "whitted", "path", "emission"};

}  // namespace

TEST_CASE("a scene without emitters is black where light is needed") {
  for (const char* integrator : lit_integrators)
    CHECK(emptiness(scene_of(integrator)).find(integrator) != std::string::npos);
  for (const char* integrator : {"normals", "depth", "ao"}) CHECK(emptiness(scene_of(integrator)).empty());
}

TEST_CASE("whatever emits ends the warning") {
  for (const char* integrator : lit_integrators) {
    const bool is_lit = std::string(integrator) != "emission";
    INFO(integrator);
    Scene lamp = scene_of(integrator), sky = lamp, point = lamp, sun = lamp, mesh = lamp;
    lamp.shapes.front().radiance = Rgb{0, 0, 1};
    CHECK(emptiness(lamp).empty());
    sky.lights.push_back({"", ConstantLight{}, {}});
    CHECK(emptiness(sky).empty());
    point.lights.push_back({"", PointLight{}, {}});
    CHECK(emptiness(point).empty() == is_lit);  // No ray meets a point.
    sun.lights.push_back({"", DirectionalLight{}, {}});
    CHECK(emptiness(sun).empty() == is_lit);
    Mesh glowing;
    glowing.parts.push_back({0, Rgb{1, 1, 1}});
    mesh.shapes.front().geometry = glowing;
    CHECK(emptiness(mesh).empty());
  }
}

TEST_CASE("a medium that emits ends the warning where the integrator goes through media") {
  Scene scene = scene_of("volpath");
  scene.media.emplace_back();
  CHECK_FALSE(emptiness(scene).empty());
  scene.media.back().emission = Rgb{0, 1, 0};
  CHECK(emptiness(scene).empty());
  scene.integrator.name = "path";
  CHECK_FALSE(emptiness(scene).empty());
  scene.integrator.name = "volpath";
  scene.media.back().sigma_t = Rgb{1, 0, 1};  // Where nothing is absorbed nothing is emitted.
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("a scene without shapes is empty unless the camera sees a sky or stands in fog") {
  Scene nothing, sky, lamp;
  nothing.integrator.name = "volpath";
  sky = lamp = nothing;
  sky.lights.push_back({"", ConstantLight{}, {}});
  lamp.lights.push_back({"", PointLight{}, {}});
  CHECK_THAT(emptiness(nothing), Catch::Contains("no shape"));
  CHECK_THAT(emptiness(lamp), Catch::Contains("no shape"));
  for (const char* integrator : {"path", "volpath", "direct", "whitted", "emission", "ptracer", "bdpt"}) {
    sky.integrator.name = integrator;
    CHECK(emptiness(sky).empty());
  }
  sky.integrator.name = "normals";
  CHECK_THAT(emptiness(sky), Catch::Contains("no shape"));
  Scene behind = sky;  // Nothing of it comes through fog without an end that only absorbs.
  behind.integrator.name = "volpath";
  behind.media.emplace_back();
  behind.media.back().albedo = Rgb{0, 0, 0};
  behind.camera.medium = 0;
  CHECK_THAT(emptiness(behind), Catch::Contains("no shape"));
  sky.integrator.name = "path";
  sky.integrator.hide_emitters = true;
  CHECK_THAT(emptiness(sky), Catch::Contains("no shape"));
  for (Scene* scene : {&nothing, &lamp}) {
    scene->media.emplace_back();
    scene->camera.medium = 0;
  }
  CHECK(emptiness(lamp).empty());
  CHECK_THAT(emptiness(nothing), Catch::Contains("emits light"));
  lamp.media.back().albedo = Rgb{0, 0, 0};
  CHECK_THAT(emptiness(lamp), Catch::Contains("no shape"));
  lamp.media.back().emission = Rgb{1, 0, 0};
  CHECK(emptiness(lamp).empty());
  lamp.integrator.name = "path";
  CHECK_THAT(emptiness(lamp), Catch::Contains("no shape"));
}

TEST_CASE("a lamp that no ray hits and that is never drawn is named") {
  const auto is_named = [](const char* integrator, double weight) {
    Scene scene = scene_of(integrator);
    scene.lights.push_back({"", PointLight{}, {}, weight});
    const std::vector<Diagnostic> all = limitations(scene);
    return std::any_of(all.begin(), all.end(), [](const Diagnostic& one) {
      return one.message.find("its sampling_weight is 0") != std::string::npos;
    });
  };
  for (const char* integrator : {"path", "volpath", "ptracer", "bdpt"}) {
    CHECK(is_named(integrator, 0));
    CHECK_FALSE(is_named(integrator, 0.5));
  }
  for (const char* integrator : {"direct", "whitted"}) CHECK_FALSE(is_named(integrator, 0));
  // Of shapes: rays find an area emitter, but not a beam; light paths alone find neither.
  const auto names_shape = [](const char* integrator, bool is_beam) {
    Scene scene = scene_of(integrator);
    Shape& shape = scene.shapes.front();
    (is_beam ? shape.exitance : shape.radiance) = Rgb{1, 1, 1};
    shape.sampling_weight = 0;
    for (const Diagnostic& one : limitations(scene))
      if (one.message.find("its sampling_weight is 0") != std::string::npos) return true;
    return false;
  };
  CHECK(names_shape("ptracer", false));
  CHECK(names_shape("ptracer", true));
  CHECK(names_shape("bdpt", true));
  CHECK_FALSE(names_shape("bdpt", false));
  CHECK_FALSE(names_shape("path", false));
}

TEST_CASE("an emitter that whitted never draws is seen and does not light") {
  const auto warning = [](const char* integrator, double weight, const auto& put) {
    Scene scene = scene_of(integrator);
    put(scene, weight);
    for (const Diagnostic& one : limitations(scene))
      if (one.message.find("its sampling_weight is 0") != std::string::npos) return one.message;
    return std::string();
  };
  const auto area = [](Scene& scene, double weight) {
    scene.shapes.front().radiance = Rgb{1, 1, 1};
    scene.shapes.front().sampling_weight = weight;
  };
  const auto sky = [](Scene& scene, double weight) { scene.lights.push_back({"", ConstantLight{}, {}, weight}); };
  const auto black = [](Scene& scene, double weight) {
    scene.lights.push_back({"", ConstantLight{{0, 0, 0}}, {}, weight});
  };
  const auto lost = [&](const char* integrator, double weight) {
    return std::array{warning(integrator, weight, area), warning(integrator, weight, sky)};
  };
  for (const std::string& said : lost("whitted", 0)) CHECK_THAT(said, Catch::Contains("is seen but does not light"));
  for (const std::string& said : lost("whitted", 0.5)) CHECK(said.empty());
  for (const std::string& said : lost("direct", 0)) CHECK(said.empty());
  for (const std::string& said : lost("path", 0)) CHECK(said.empty());
  CHECK(warning("whitted", 0, black).empty());
}

TEST_CASE("direct names materials of shapes that it shows as nothing but emitters' images, and whitted as the way") {
  Material mirror, plastic, glass, blend;
  mirror.bsdf = Conductor{};
  plastic.bsdf = Plastic{};
  glass.bsdf = Dielectric{};
  const auto named = [](Scene scene, int max_depth, const char* integrator) {
    scene.integrator.name = integrator;
    scene.integrator.max_depth = max_depth;
    std::vector<int> lines;
    for (const Diagnostic& one : limitations(scene))
      if (one.message.find("this material shows emitters alone") != std::string::npos) lines.push_back(one.where.line);
    return lines;
  };
  Scene scene = scene_of("direct");
  scene.lights.push_back({"", PointLight{}, {}});
  scene.materials = {Material{}, mirror, plastic, glass, mirror};
  Blend half;
  half.first = 1;
  half.second = 0;
  blend.bsdf = half;
  scene.materials.push_back(blend);
  half.second = 3;
  blend.bsdf = half;
  scene.materials.push_back(blend);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) scene.materials[i].where.line = static_cast<int>(i);
  CHECK(named(scene, -1, "direct").empty());
  for (const int material : {0, 1, 2, 5, 6}) {
    scene.shapes.emplace_back().geometry = Sphere{};
    scene.shapes.back().material = material;
  }
  Mesh mesh;
  mesh.parts.push_back({3, {}});
  scene.shapes.emplace_back().geometry = mesh;
  CHECK(named(scene, -1, "direct") == std::vector<int>{1, 3, 6});
  CHECK(named(scene, 3, "direct") == std::vector<int>{1, 3, 6});
  CHECK(named(scene, 2, "direct").empty());
  CHECK(named(scene, -1, "whitted").empty());
  // In a group, and behind another surface.
  Scene placed = scene_of("direct");
  placed.materials = {Material{}, mirror};
  placed.materials[0].back = 1;
  placed.materials[1].where.line = 1;
  CHECK(named(placed, -1, "direct") == std::vector<int>{1});
  placed.materials[0].back = -1;
  placed.groups.emplace_back().shapes.emplace_back().material = 1;
  CHECK(named(placed, -1, "direct") == std::vector<int>{1});
}

TEST_CASE("who draws a gaussian where the filter has negative parts is named") {
  const auto drawer = [](const char* integrator, FilterKind filter, SamplerKind sampler,
                         const std::set<std::string>& disabled) {
    Scene scene = scene_of(integrator);
    scene.film.filter = {filter};
    scene.sampler.kind = sampler;
    const std::string before = "the pixel filter has negative parts, from which ", after = " cannot draw; a gaussian";
    for (const Diagnostic& one : limitations(scene, disabled))
      if (one.message.starts_with(before))
        return one.message.substr(before.size(), one.message.find(after) - before.size());
    return std::string();
  };
  constexpr SamplerKind sobol = SamplerKind::sobol;
  for (const FilterKind filter : {FilterKind::mitchell, FilterKind::catmullrom, FilterKind::lanczos}) {
    CHECK(drawer("path", filter, sobol, {"SHARED_SAMPLES"}) == "a program without SHARED_SAMPLES");
    CHECK(drawer("ptracer", filter, sobol, {}) == "integrator ptracer");
    CHECK(drawer("bdpt", filter, sobol, {}) == "integrator bdpt");
    CHECK(drawer("path", filter, sobol, {}).empty());
    CHECK(drawer("path", filter, sobol, {"SHARED_SAMPLES", "PIXEL_FILTER"}).empty());
    CHECK(drawer("path", filter, SamplerKind::centre, {"SHARED_SAMPLES"}).empty());
  }
  CHECK(drawer("path", FilterKind::gaussian, sobol, {"SHARED_SAMPLES"}).empty());
  CHECK(drawer("ptracer", FilterKind::tent, sobol, {}).empty());
}

TEST_CASE("beams are named where the integrator cannot find them") {
  const auto beams = [](Scene scene, const char* integrator) {
    scene.integrator.name = integrator;
    int count = 0;
    for (const Diagnostic& warning : limitations(scene))
      count += warning.message.find("light is left out: each of its places shines") != std::string::npos ? 1 : 0;
    return count;
  };
  Scene scene = scene_of("path");
  scene.shapes.front().exitance = Rgb{1, 1, 1};
  scene.lights.push_back({"", CollimatedLight{}, {}});
  for (const char* integrator : {"path", "direct", "whitted", "volpath"}) {
    INFO(integrator);
    CHECK(beams(scene, integrator) == 2);
  }
  for (const char* integrator : {"ptracer", "bdpt", "normals"}) CHECK(beams(scene, integrator) == 0);
  for (const char* integrator : {"path", "ptracer"}) {
    scene.integrator.name = integrator;
    CHECK(emptiness(scene).empty());
  }
  scene.lights.clear();
  scene.shapes.front().exitance = Rgb{0, 0, 0};
  CHECK(beams(scene, "path") == 0);
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("an emitter of radiance 0 emits nothing") {
  Scene scene = scene_of("path");
  scene.shapes.front().radiance = Rgb{0, 0, 0};
  scene.lights.push_back({"", PointLight{{}, {0, 0, 0}}, {}});
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("a scene without shapes, with and without instances") {
  Scene scene = scene_of("normals");
  scene.shapes.clear();
  CHECK(emptiness(scene).find("no shape") != std::string::npos);
  scene.groups.emplace_back().shapes.emplace_back();
  CHECK_FALSE(emptiness(scene).empty());  // A group that nobody places.
  scene.instances.emplace_back();
  CHECK(emptiness(scene).empty());
}

TEST_CASE("a shape too far off for single precision is named, with the remedy") {
  Scene scene = scene_of("path");
  scene.shapes.emplace_back().geometry = Sphere{{0, 0, 3e22}, 1e22};
  CHECK_FALSE(too_wide_for_single(scene));
  scene.shapes.back().geometry = Sphere{{0, 0, 3e28}, 1e28};
  scene.shapes.back().where = {"far.xml", 7, 3};
  const std::optional<Diagnostic> warning = too_wide_for_single(scene);
  REQUIRE(warning);
  CHECK(warning->text().find("far.xml:7:3: warning: this shape reaches to 4e+28") != std::string::npos);
  CHECK(warning->message.find("--precision double") != std::string::npos);
}

TEST_CASE("a body too dense for single precision is named, placed by an instance, too") {
  for (const bool is_placed : {false, true}) {
    Scene scene = scene_of("volpath");
    Medium marble;
    marble.sigma_t = Rgb{10, 2600, 10};
    scene.media = {marble};
    Shape ball;
    ball.geometry = Sphere{{0, 0, 0}, 0.3, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    ball.media = MediumBoundary{0, -1};
    Transform place;
    const auto warning_at = [&](double distance) {
      place.m = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 4 - distance}}};
      scene.shapes.clear(), scene.groups.clear(), scene.instances.clear();
      if (is_placed) {
        scene.groups.emplace_back().shapes = {ball};
        scene.instances.emplace_back().world_from_group = place;
      } else {
        scene.shapes = {ball};
        std::get<Sphere>(scene.shapes.front().geometry).center = place.point({0, 0, 0});
      }
      return too_dense_for_single(scene, {0, 0, 4});
    };
    CHECK_FALSE(warning_at(100));
    const std::optional<Diagnostic> warning = warning_at(1000);
    REQUIRE(warning);
    CHECK(warning->message.find("light goes 0.00038 on average") != std::string::npos);
    CHECK(warning->message.find("--precision double") != std::string::npos);
    scene.integrator.name = "path";
    CHECK_FALSE(warning_at(1000));
  }
  // Fog that ends far behind what is seen.
  Scene fog = scene_of("volpath");
  fog.media.emplace_back().sigma_t = Rgb{0.5, 0.5, 0.5};
  fog.shapes.emplace_back().geometry = Sphere{{0, 0, 0}, 1e6, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  fog.shapes.back().media = MediumBoundary{0, -1};
  CHECK_FALSE(too_dense_for_single(fog, {0, 0, 4}));
}

TEST_CASE("ids that floats do not tell apart are told") {
  constexpr std::int64_t exact = (std::int64_t{1} << 24) + 1;  // From 0.
  const AovList both{Aov::shape_id, Aov::primitive_id};
  CHECK(rounded_ids({exact, exact}, both).empty());
  CHECK(rounded_ids({exact + 1, exact}, both) == std::set{Aov::shape_id});
  CHECK(rounded_ids({exact, exact + 1}, both) == std::set{Aov::primitive_id});
  CHECK(rounded_ids({exact + 1, exact + 1}, {Aov::depth}).empty());
  AovList named;
  named.add(NamedAov{"id", Aov::primitive_id});
  CHECK(rounded_ids({1, exact + 1}, named) == std::set{Aov::primitive_id});

  Scene scene = scene_of("path");
  Mesh mesh;
  mesh.triangles.resize(7);
  scene.groups.emplace_back().shapes.emplace_back().geometry = mesh;
  CHECK(id_counts(scene).shapes == 2);
  CHECK(id_counts(scene).primitives == 7);
}
