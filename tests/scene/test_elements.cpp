// SPDX-License-Identifier: MIT
// Every element of the scene language gives what docs/scene-format.md says, defaults included.
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/scene_text.h"
#include "scene/xml/parse_value.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Scene sensor(const std::string& inside, const std::string& type = "perspective") {
  return load_text("<scene version=\"3.0.0\"><sensor type=\"" + type + "\">" + inside + "</sensor></scene>").scene;
}

Rgb reflectance(const std::string& property) {
  return std::get<Diffuse>(load_body("<bsdf type=\"diffuse\">" + property + "</bsdf>").scene.materials.at(1).bsdf)
      .reflectance.color;
}

}  // namespace

TEST_CASE("defaults of an empty scene") {
  const LoadedScene loaded = load_text("<scene version=\"3.0.0\"/>");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("no <sensor>") != std::string::npos);
  CHECK(loaded.scene.film.width == 768);
  CHECK(loaded.scene.film.height == 576);
  CHECK(loaded.scene.film.filter.kind == FilterKind::gaussian);
  CHECK(loaded.scene.integrator.name == "emission");  // Of "auto": nothing reflects.
  CHECK(loaded.scene.integrator.max_depth == -1);
  CHECK(loaded.scene.materials.size() == 1);
  CHECK_FALSE(loaded.scene.materials[0].twosided);
}

TEST_CASE("fields of view") {
  const Camera normal = sensor("").camera;
  CHECK(normal.fov_axis == FovAxis::diagonal);
  CHECK(normal.fov_degrees ==
        Approx(2 * std::atan(std::sqrt(36. * 36 + 24 * 24) / 100) * 180 / std::acos(-1)).epsilon(1e-14));
  CHECK(sensor("<string name=\"focal_length\" value=\"25mm\"/>").camera.fov_degrees > 80);
  const std::pair<const char*, FovAxis> axes[] = {
      {"x", FovAxis::x},           {"y", FovAxis::y}, {"diagonal", FovAxis::diagonal}, {"smaller", FovAxis::smaller},
      {"larger", FovAxis::larger}, {"Y", FovAxis::y}, {"Smaller", FovAxis::smaller}};
  for (const auto& [name, axis] : axes) {
    const Camera camera =
        sensor(std::string("<float name=\"fov\" value=\"33\"/><string name=\"fov_axis\" value=\"") + name + "\"/>")
            .camera;
    CHECK(camera.fov_axis == axis);
    CHECK(camera.fov_degrees == 33);
  }
  CHECK(sensor("<float name=\"fov\" value=\"33\"/>").camera.fov_axis == FovAxis::x);
}

TEST_CASE("sensors") {
  const Camera camera = sensor(
                            "<float name=\"principal_point_offset_x\" value=\".1\"/><float name=\"near_clip\" "
                            "value=\"2\"/><integer name=\"far_clip\" value=\"3\"/><float name=\"focus_distance\" "
                            "value=\"9\"/>")
                            .camera;
  CHECK(camera.principal_point_offset_x == .1);
  CHECK(camera.near_clip == 2);
  CHECK(camera.far_clip == 3);
  CHECK(sensor("").camera.near_clip == 0);
  CHECK(std::isinf(sensor("").camera.far_clip));
  CHECK(sensor("", "orthographic").camera.projection == Projection::orthographic);
}

TEST_CASE("a thin lens has a radius and a plane of focus") {
  const auto lens = [](const std::string& inside) { return sensor(inside, "thinlens").camera; };
  const std::string radius = "<float name=\"aperture_radius\" value=\"0.2\"/>";
  CHECK(lens(radius + "<float name=\"focus_distance\" value=\"3\"/>").focus_distance == 3);
  CHECK(lens(radius).aperture_radius == 0.2);
  CHECK(lens(radius).focus_distance == 1e4);
  CHECK(lens(radius + "<float name=\"far_clip\" value=\"50\"/>").focus_distance == 50);
  CHECK(sensor("").camera.aperture_radius == 0);
  for (const std::string& fault : {std::string(), std::string("<float name=\"aperture_radius\" value=\"-1\"/>"),
                                   radius + "<float name=\"focus_distance\" value=\"0\"/>"})
    CHECK_THROWS_AS(lens(fault), SceneError);
}

TEST_CASE("film, filter, sampler") {
  const Film film =
      sensor(
          "<film type=\"hdrfilm\"><integer name=\"width\" value=\"100\"/><integer name=\"height\" value=\"50\"/>"
          "<integer name=\"crop_offset_x\" value=\"10\"/><integer name=\"crop_width\" value=\"20\"/>"
          "<string name=\"pixel_format\" value=\"rgb\"/><rfilter type=\"tent\"><float name=\"radius\" "
          "value=\"2\"/></rfilter></film>")
          .film;
  CHECK(film.window() == Window{10, 0, 30, 50});
  CHECK(film.filter.kind == FilterKind::tent);
  CHECK(film.filter.radius == 2);
  CHECK(
      sensor("<film type=\"hdrfilm\"><rfilter type=\"gaussian\"><float name=\"stddev\" value=\".7\"/></rfilter></film>")
          .film.filter.stddev == .7);
  const auto filter = [](const std::string& text) {
    return sensor("<film type=\"hdrfilm\"><rfilter " + text + "</rfilter></film>").film.filter;
  };
  const Filter mitchell = filter("type=\"mitchell\"><float name=\"B\" value=\"0.1\"/>");
  CHECK(mitchell.kind == FilterKind::mitchell);
  CHECK(mitchell.b == 0.1);
  CHECK(mitchell.c == Approx(1.0 / 3));
  CHECK(filter("type=\"CatmullRom\">").kind == FilterKind::catmullrom);
  CHECK(filter("type=\"lanczos\"><integer name=\"lobes\" value=\"2\"/>").radius == 2);
  CHECK_THROWS_AS(filter("type=\"lanczos\"><integer name=\"lobes\" value=\"5\"/>"), SceneError);
  CHECK_THROWS_AS(filter("type=\"mitchell\"><float name=\"C\" value=\"4.5\"/>"), SceneError);
  const SamplerSettings sampler =
      sensor(
          "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"8\"/><integer "
          "name=\"seed\" value=\"3\"/></sampler>")
          .sampler;
  CHECK(sampler.kind == SamplerKind::independent);
  CHECK(sampler.sample_count == 8);
  CHECK(sampler.seed == 3);
  for (const char* type : {"stratified", "multijitter", "orthogonal", "ldsampler"})
    CHECK_FALSE(sensor(std::string("<sampler type=\"") + type + "\"/>").sampler.kind.has_value());
}

TEST_CASE("colours") {
  CHECK(reflectance("<rgb name=\"reflectance\" value=\"0.1, 0.2, 0.3\"/>") == Rgb{.1, .2, .3});
  CHECK(reflectance("<rgb name=\"reflectance\" value=\".25\"/>") == Rgb{.25, .25, .25});
  CHECK(reflectance("<rgb name=\"reflectance\" value=\"#00ff80\"/>") == Rgb{0, 1, linear_from_srgb(128 / 255.)});
  CHECK(reflectance("<spectrum name=\"reflectance\" value=\"0.75\"/>") == Rgb{.75, .75, .75});
  CHECK(reflectance("<float name=\"reflectance\" value=\"0.75\"/>") == Rgb{.75, .75, .75});
  CHECK(reflectance("") == Rgb{.5, .5, .5});
  CHECK(linear_from_srgb(128 / 255.) == Approx(0.21586).epsilon(1e-4));
}

TEST_CASE("materials are shared by reference, in any order") {
  const Scene scene =
      load_body(
          "<shape type=\"sphere\"><ref id=\"b\" name=\"bsdf\"/></shape><shape type=\"disk\"><ref id=\"t\"/>"
          "</shape><bsdf type=\"diffuse\" id=\"b\"/><bsdf type=\"twosided\" id=\"t\"><ref id=\"b\"/></bsdf>"
          "<shape type=\"cube\"/><alias id=\"b\" as=\"c\"/><shape type=\"cube\"><ref id=\"c\"/></shape>")
          .scene;
  REQUIRE(scene.materials.size() == 3);
  CHECK(scene.shapes[0].material == 1);
  CHECK(scene.shapes[1].material == 2);
  CHECK(scene.shapes[2].material == 0);
  CHECK(scene.shapes[3].material == 1);
  CHECK(scene.materials[2].twosided);
  CHECK_FALSE(scene.materials[1].twosided);
}

TEST_CASE("lights") {
  const Scene scene =
      load_body(
          "<emitter type=\"point\"><transform name=\"to_world\"><translate x=\"1\" y=\"2\" z=\"3\"/>"
          "</transform><rgb name=\"intensity\" value=\"4\"/></emitter><emitter type=\"directional\">"
          "<transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/></transform></emitter><emitter "
          "type=\"constant\"><rgb name=\"radiance\" value=\"1 2 3\"/></emitter>\n<shape type=\"sphere\">"
          "<emitter type=\"area\"><rgb name=\"radiance\" value=\"5\"/></emitter></shape>")
          .scene;
  REQUIRE(scene.lights.size() == 3);
  CHECK(std::get<PointLight>(scene.lights[0].emitter).position == Vec3{1, 2, 3});
  CHECK(std::get<PointLight>(scene.lights[0].emitter).intensity == Rgb{4, 4, 4});
  CHECK(std::get<DirectionalLight>(scene.lights[1].emitter).direction == Vec3{1, 0, 0});
  CHECK(std::get<DirectionalLight>(scene.lights[1].emitter).irradiance == Rgb{1, 1, 1});
  CHECK(std::get<ConstantLight>(scene.lights[2].emitter).radiance == Rgb{1, 2, 3});
  CHECK(scene.shapes[0].radiance == Rgb{5, 5, 5});
  // As in Mitsuba: what emits and has no bsdf reflects nothing.
  const Material& black = scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material));
  CHECK(std::get<Diffuse>(black.bsdf).reflectance.color == Rgb{0, 0, 0});
  CHECK(scene.shapes[0].radiance_where.line == 3);
  CHECK(scene.shapes[0].radiance_where.column == 22);
}

TEST_CASE(
    "a scale of to_world makes a directional light brighter, the length of its direction does not, as in Mitsuba") {
  const auto light = [](const std::string& inside) {
    const LoadedScene loaded = load_body("<emitter type=\"directional\">" + inside + "</emitter>");
    CHECK(shortened(loaded.warnings).empty());
    return std::get<DirectionalLight>(loaded.scene.lights.at(0).emitter);
  };
  const auto placed = [&](const std::string& steps) {
    return light("<rgb name=\"irradiance\" value=\"1 2 3\"/><transform name=\"to_world\">" + steps + "</transform>");
  };
  // Mitsuba 3.9.1: a grey rectangle is 0.31831, 0.15915 and 0.07958 bright where it is 0.15915 without a scale.
  CHECK(placed("<scale value=\"2\"/><rotate y=\"1\" angle=\"90\"/>").irradiance == Rgb{2, 4, 6});
  CHECK(placed("<scale x=\"2\" y=\"3\"/>").irradiance == Rgb{1, 2, 3});
  CHECK(placed("<scale x=\"3\" z=\"-0.5\"/>").irradiance == Rgb{0.5, 1, 1.5});
  CHECK(light("<vector name=\"direction\" value=\"0, 0, 2\"/>").irradiance == Rgb{1, 1, 1});
}

TEST_CASE("beams") {
  const Scene scene = load_body(
                          "<emitter type=\"collimated\"><transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/>"
                          "<translate x=\"1\" y=\"2\" z=\"3\"/></transform><rgb name=\"power\" value=\"4\"/></emitter>"
                          "<emitter type=\"collimated\"/><shape type=\"disk\"><emitter type=\"directionalarea\">"
                          "<rgb name=\"radiance\" value=\"5\"/></emitter></shape>")
                          .scene;
  REQUIRE(scene.lights.size() == 2);
  const auto& beam = std::get<CollimatedLight>(scene.lights[0].emitter);
  CHECK(beam.position == Vec3{1, 2, 3});
  CHECK(beam.direction == Vec3{1, 0, 0});
  CHECK(beam.power == Rgb{4, 4, 4});
  const auto& plain = std::get<CollimatedLight>(scene.lights[1].emitter);
  CHECK(plain.position == Vec3{0, 0, 0});
  CHECK(plain.direction == Vec3{0, 0, 1});
  CHECK(plain.power == Rgb{1, 1, 1});
  CHECK(scene.shapes[0].exitance == Rgb{5, 5, 5});
  CHECK_FALSE(scene.shapes[0].radiance);
  const Material& black = scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material));
  CHECK(std::get<Diffuse>(black.bsdf).reflectance.color == Rgb{0, 0, 0});
}

TEST_CASE("a spot has a cone") {
  const LoadedScene loaded = load_body(
      "<emitter type=\"spot\"/><emitter type=\"spot\"><transform name=\"to_world\"><lookat origin=\"1, 2, 3\" "
      "target=\"1, 2, 0\" up=\"0, 1, 0\"/></transform><rgb name=\"intensity\" value=\"4\"/><float "
      "name=\"cutoff_angle\" value=\"40\"/><float name=\"beam_width\" value=\"40\"/></emitter>");
  CHECK(loaded.warnings.empty());
  const auto plain = std::get<SpotLight>(loaded.scene.lights.at(0).emitter);
  CHECK(plain.cutoff_degrees == 20);
  CHECK(plain.beam_degrees == 15);
  CHECK(plain.axis == Vec3{0, 0, 1});
  const auto lamp = std::get<SpotLight>(loaded.scene.lights.at(1).emitter);
  CHECK(lamp.position == Vec3{1, 2, 3});
  CHECK(lamp.axis == Vec3{0, 0, -1});
  CHECK(lamp.intensity == Rgb{4, 4, 4});
  CHECK(lamp.beam_degrees == 40);
  for (const char* fault : {"<float name=\"cutoff_angle\" value=\"0\"/>", "<float name=\"beam_width\" value=\"21\"/>"})
    CHECK(problems(around("<emitter type=\"spot\">" + std::string(fault) + "</emitter>")).at(0).find("2:1: error:") ==
          0);
}

TEST_CASE("to_world of a spot and a projector may scale, as in Mitsuba") {
  const auto light = [](const std::string& type, const std::string& steps) {
    return load_body("<emitter type=\"" + type + "\"><transform name=\"to_world\">" + steps + "</transform></emitter>");
  };
  const auto emitter = [&](const std::string& type, const std::string& steps) {
    const LoadedScene loaded = light(type, steps);
    CHECK(shortened(loaded.warnings).empty());
    return loaded.scene.lights.at(0).emitter;
  };
  for (const char* same : {"<scale value=\"3\"/><rotate x=\"1\" angle=\"50\"/>", "<scale x=\"-1\"/>"}) {
    CHECK(std::get<SpotLight>(emitter("spot", same)).cutoff_degrees == 20);
    CHECK(std::get<SpotLight>(emitter("spot", same)).intensity == Rgb{1, 1, 1});
  }
  // By 45 degrees, as files write it.
  const std::string turn = "<matrix value=\"0.7071 0 0.7071 0 1 0 -0.7071 0 0.7071\"/>";
  CHECK(std::get<SpotLight>(emitter("spot", turn)).cutoff_degrees == 20);
  const auto turned = std::get<ProjectorLight>(emitter("projector", turn));
  CHECK(length(turned.axes[2] - Vec3{std::sqrt(0.5), 0, std::sqrt(0.5)}) < 1e-15);
  const std::string shear = "<matrix value=\"1 0 0 0 1 0.5 0 0 1\"/>";
  for (const std::string& distorting : {std::string("<scale x=\"2\"/>"), std::string("<scale z=\"2\"/>"), shear}) {
    INFO(distorting);
    const LoadedScene loaded = light("spot", distorting);
    REQUIRE(loaded.warnings.size() == 1);
    CHECK_THAT(loaded.warnings[0].message, Catch::Contains("the cone stays round"));
  }
  for (const bool is_mirrored : {false, true}) {
    const std::string steps =
        "<transform name=\"to_world\">" + shear + (is_mirrored ? "<scale x=\"-1\"/>" : "") + "</transform>";
    const auto sheared = std::get<SpotLight>(
        load_body("<emitter type=\"spot\"><texture type=\"checkerboard\" name=\"texture\"/>" + steps + "</emitter>")
            .scene.lights.at(0)
            .emitter);
    const Vec3 axis = normalized(sheared.axis);
    CHECK(length(sheared.x - Vec3{is_mirrored ? -1.0 : 1.0, 0, 0}) < 1e-15);
    CHECK(length(sheared.y - normalized(Vec3{0, 1, -0.5})) < 1e-15);
    CHECK(std::abs(dot(sheared.y, axis)) < 1e-15);
  }
  // Mitsuba 3.9.1: the middle is 1, 2, 1 and 2 times as bright, and the picture 1, 1, 2 and 1/2 times as wide.
  const auto plain = std::get<ProjectorLight>(emitter("projector", "<scale x=\"-1\"/>"));
  const auto large = std::get<ProjectorLight>(emitter("projector", "<scale value=\"2\"/>"));
  const auto wide = std::get<ProjectorLight>(emitter("projector", "<scale x=\"2\"/>"));
  const auto narrow = std::get<ProjectorLight>(emitter("projector", "<scale z=\"2\"/><rotate y=\"1\" angle=\"9\"/>"));
  CHECK(plain.irradiance == Rgb{1, 1, 1});
  CHECK(large.irradiance == Rgb{2, 2, 2});
  CHECK(large.tan_x == Approx(plain.tan_x).epsilon(1e-14));
  CHECK(wide.irradiance == Rgb{1, 1, 1});
  CHECK(wide.tan_x == Approx(2 * plain.tan_x).epsilon(1e-14));
  CHECK(wide.tan_y == Approx(plain.tan_y).epsilon(1e-14));
  CHECK(narrow.irradiance.g == Approx(2).epsilon(1e-14));
  CHECK(narrow.tan_x == Approx(plain.tan_x / 2).epsilon(1e-14));
  CHECK(narrow.tan_y == Approx(plain.tan_y / 2).epsilon(1e-14));
  CHECK_THAT(
      problems(around("<emitter type=\"projector\"><transform name=\"to_world\">" + shear + "</transform></emitter>"))
          .at(0),
      Catch::Contains("must keep right angles"));
}

TEST_CASE("a scene without sensor is framed along -z") {
  const Scene scene = load_text(
                          "<scene version=\"3.0.0\"><shape type=\"box\"><point name=\"min\" value=\"1 2 3\"/><point "
                          "name=\"max\" value=\"5 4 9\"/></shape></scene>")
                          .scene;
  const Transform& t = scene.camera.world_from_camera;
  CHECK(t.vector({0, 0, 1}) == Vec3{0, 0, -1});
  CHECK(t.vector({1, 0, 0}) == Vec3{-1, 0, 0});
  CHECK(t.translation().x == 3);
  CHECK(t.translation().y == 3);
  const double tangent = std::tan(scene.camera.fov_degrees / 2 * std::acos(-1) / 180);
  CHECK((t.translation().z - 9) * tangent > 2);
  CHECK((t.translation().z - 9) * tangent < 2.2);
  CHECK(scene.camera.fov_axis == FovAxis::smaller);
}

TEST_CASE("a conductor is an ideal mirror") {
  const Material plain = load_body("<bsdf type=\"conductor\"/>").scene.materials.at(1);
  CHECK(std::get<Conductor>(plain.bsdf).reflectance.color == Rgb{1, 1, 1});
  CHECK_FALSE(plain.twosided);
  const LoadedScene gold = load_body(
      "<bsdf type=\"twosided\"><bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/>"
      "<rgb name=\"specular_reflectance\" value=\"1, .8, .3\"/></bsdf></bsdf>");
  CHECK(gold.warnings.empty());
  CHECK(std::get<Conductor>(gold.scene.materials.at(1).bsdf).reflectance.color == Rgb{1, .8, .3});
  CHECK(gold.scene.materials.at(1).twosided);
}

TEST_CASE("a dielectric has indices by number or name, and shares of what it reflects and transmits") {
  const auto glass = [](const std::string& inside) {
    const LoadedScene loaded = load_body("<bsdf type=\"dielectric\">" + inside + "</bsdf>");
    CHECK(loaded.warnings.empty());
    return std::get<Dielectric>(loaded.scene.materials.at(1).bsdf);
  };
  CHECK(glass("").int_ior == 1.5046);
  CHECK(glass("").ext_ior == 1.000277);
  CHECK(glass("").reflectance.color == Rgb{1, 1, 1});
  CHECK(glass("").transmittance.color == Rgb{1, 1, 1});
  const Dielectric named = glass(
      "<string name=\"int_ior\" value=\"Diamond\"/><float name=\"ext_ior\" value=\"1.25\"/>"
      "<rgb name=\"specular_transmittance\" value=\"1, .5, .25\"/>"
      "<texture type=\"checkerboard\" name=\"specular_reflectance\"/>");
  CHECK(named.int_ior == 2.419);
  CHECK(named.ext_ior == 1.25);
  CHECK(named.transmittance.color == Rgb{1, .5, .25});
  CHECK(named.reflectance.texture == 0);
}

TEST_CASE("glass may have a priority") {
  const Scene scene = load_body(
                          "<shape type=\"sphere\"><integer name=\"priority\" value=\"-3\"/><bsdf "
                          "type=\"dielectric\"/></shape><shape type=\"sphere\"/>")
                          .scene;
  CHECK(scene.shapes.at(0).priority == -3);
  CHECK_FALSE(scene.shapes.at(1).priority);
}

TEST_CASE("what bounds media and lets light through as it came may have a priority") {
  for (const char* bsdf : {"<bsdf type=\"null\"/>", "<bsdf type=\"thindielectric\"/>",
                           "<bsdf type=\"mask\"><bsdf type=\"diffuse\"/></bsdf>"}) {
    INFO(bsdf);
    const std::string body = std::string("<shape type=\"sphere\"><integer name=\"priority\" value=\"1\"/>") + bsdf;
    CHECK(load_body(body + "<medium type=\"homogeneous\" name=\"interior\"/></shape>").warnings.empty());
    CHECK(load_body(body + "</shape>").warnings.size() == 1);
  }
}

TEST_CASE("indices of refraction that cannot be are errors with their place, and names are guessed") {
  const auto problem = [](const std::string& inside) {
    const std::vector<std::string> found = problems(around("<bsdf type=\"dielectric\">" + inside + "</bsdf>"));
    REQUIRE(found.size() == 1);
    return found[0];
  };
  CHECK(problem("<string name=\"int_ior\" value=\"diamnd\"/>") ==
        "2:25: error: \"int_ior\" is \"diamnd\", which is no medium that strahl knows (did you mean \"diamond\"?); a "
        "number > 0 will do");
  CHECK(problem("<string name=\"int_ior\" value=\"1.5\"/>") ==
        "2:25: error: \"int_ior\" is \"1.5\", which is no medium that strahl knows; a number is written <float "
        "name=\"int_ior\" value=\"1.5\"/>");
  CHECK(problem("<float name=\"int_ior\" value=\"1e7\"/>").find("from 1e-6 to 1e6") != std::string::npos);
  CHECK(problem("<float name=\"ext_ior\" value=\"0\"/>").find("greater than 0") != std::string::npos);
  CHECK(problem("<float name=\"int_ior\" value=\"-1.5\"/>").find("greater than 0") != std::string::npos);
}

TEST_CASE("a checkerboard in place of a reflectance, nested or by reference, read once") {
  const LoadedScene loaded = load_body(
      "<texture type=\"checkerboard\" id=\"board\"><rgb name=\"color0\" value=\"1, .5, .25\"/><transform "
      "name=\"to_uv\"><scale x=\"2\" y=\"4\"/><rotate z=\"1\" angle=\"90\"/><translate x=\".5\" y=\"-3\" "
      "z=\"9\"/></transform></texture>"
      "<bsdf type=\"diffuse\"><ref id=\"board\" name=\"reflectance\"/></bsdf>"
      "<bsdf type=\"conductor\"><ref id=\"board\" name=\"specular_reflectance\"/></bsdf>"
      "<bsdf type=\"diffuse\"><texture type=\"checkerboard\" name=\"reflectance\"/></bsdf>");
  CHECK(loaded.warnings.empty());
  const Scene& scene = loaded.scene;
  REQUIRE(scene.textures.size() == 2);
  CHECK(std::get<Diffuse>(scene.materials.at(1).bsdf).reflectance.texture == 0);
  CHECK(std::get<Conductor>(scene.materials.at(2).bsdf).reflectance.texture == 0);
  CHECK(std::get<Diffuse>(scene.materials.at(3).bsdf).reflectance.texture == 1);
  const auto& board = std::get<Checkerboard>(scene.textures[0].pattern);
  CHECK(board.color0 == Rgb{1, .5, .25});
  CHECK(board.color1 == Rgb{.2, .2, .2});
  CHECK(board.to_uv == std::array<double, 6>{0, -4, .5, 2, 0, -3});
  CHECK(std::get<Checkerboard>(scene.textures[1].pattern).color0 == Rgb{.4, .4, .4});
}
