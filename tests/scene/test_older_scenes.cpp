// SPDX-License-Identifier: MIT
// Files of Mitsuba 0.x: what means something else there than in Mitsuba 3.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/scene_text.h"
#include "scene_mesh/serialized_bytes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

std::string old(const std::string& body) {
  return "<scene version=\"0.6.0\">\n" + body + "\n<sensor type=\"perspective\"/></scene>\n";
}

Scene loaded(const std::string& body) {
  const LoadedScene loaded = load_text(old(body));
  CHECK(shortened(loaded.warnings).empty());
  return loaded.scene;
}

}  // namespace

TEST_CASE("0.x: references and objects of one name are a list") {
  const std::string two = "<bsdf type=\"diffuse\" id=\"a\"/><bsdf type=\"conductor\" id=\"b\"/>";
  const Scene blend = loaded(two +
                             "<bsdf type=\"blendbsdf\"><ref name=\"bsdf\" id=\"a\"/><ref name=\"bsdf\" id=\"b\"/>"
                             "</bsdf>");
  const auto& halves = std::get<Blend>(blend.materials.at(3).bsdf);
  CHECK(std::holds_alternative<Diffuse>(blend.materials.at(static_cast<std::size_t>(halves.first)).bsdf));
  CHECK(std::holds_alternative<Conductor>(blend.materials.at(static_cast<std::size_t>(halves.second)).bsdf));
  const Scene sides = loaded(
      "<bsdf type=\"twosided\"><bsdf type=\"diffuse\" name=\"side\"/><bsdf type=\"diffuse\" name=\"side\">"
      "<rgb name=\"reflectance\" value=\"1\"/></bsdf></bsdf>");
  CHECK(sides.materials.back().back >= 0);
  const std::string balls = "<shape type=\"sphere\" id=\"s\"/><shape type=\"cube\" id=\"c\"/>";
  const Scene group = loaded(balls +
                             "<shape type=\"shapegroup\" id=\"g\"><ref name=\"x\" id=\"s\"/><ref name=\"x\" "
                             "id=\"c\"/></shape><shape type=\"instance\"><ref id=\"g\"/></shape>");
  CHECK(group.groups.at(0).shapes.size() == 2);
}

TEST_CASE("0.x: of what a shape or a parameter has once the last counts") {
  const std::string two = "<bsdf type=\"diffuse\" id=\"a\"/><bsdf type=\"conductor\" id=\"b\"/>";
  const Scene sphere =
      load_text(old(two + "<shape type=\"sphere\"><ref name=\"bsdf\" id=\"a\"/><ref name=\"bsdf\" id=\"b\"/>"
                          "</shape>"))
          .scene;
  const int shown = sphere.shapes.back().material;
  CHECK(std::holds_alternative<Conductor>(sphere.materials.at(static_cast<std::size_t>(shown)).bsdf));
  const Scene colour =
      load_text(old("<texture type=\"checkerboard\" id=\"t\"/><bsdf type=\"diffuse\"><ref name=\"reflectance\" "
                    "id=\"t\"/><rgb name=\"reflectance\" value=\"0.25\"/></bsdf>"))
          .scene;
  CHECK(std::get<Diffuse>(colour.materials.at(1).bsdf).reflectance.color == Rgb{0.25, 0.25, 0.25});
  CHECK(std::get<Diffuse>(colour.materials.at(1).bsdf).reflectance.texture < 0);
  // In the scene itself there may be several.
  const Scene balls = loaded(
      "<bsdf type=\"diffuse\" id=\"a\" name=\"mat\"/><bsdf type=\"conductor\" id=\"b\" name=\"mat\"/>"
      "<shape type=\"sphere\" name=\"ball\"><ref id=\"a\"/></shape><shape type=\"cube\" name=\"ball\"/>");
  CHECK(balls.shapes.size() == 2);
}

TEST_CASE("0.x: of several bsdfs of a shape the last counts, and the others are named; a second emitter is an error") {
  const std::string conductor = "<bsdf type=\"conductor\" id=\"b\"/>";
  for (const char* last : {"<bsdf type=\"conductor\"/>", "<bsdf type=\"conductor\" name=\"x\"/>", "<ref id=\"b\"/>"}) {
    INFO(last);
    const std::string shape =
        conductor + "\n<shape type=\"sphere\"><bsdf type=\"diffuse\" name=\"x\"/>" + last + "</shape>";
    const LoadedScene found = load_text(old(shape));
    const int shown = found.scene.shapes.back().material;
    CHECK(std::holds_alternative<Conductor>(found.scene.materials.at(static_cast<std::size_t>(shown)).bsdf));
    REQUIRE(found.warnings.size() == 1);
    CHECK(shortened(found.warnings)[0].find(
              "3:22: warning: <shape type=\"sphere\"> has more than one <bsdf>; the last counts, at ") == 0);
    CHECK(problems(around(shape)).at(0).find(": error: ") != std::string::npos);
  }
  // References are where they stand, not where they lead.
  const LoadedScene referring = load_text(
      old(conductor +
          "\n<bsdf type=\"diffuse\" id=\"a\"/>\n<shape type=\"sphere\"><ref id=\"a\"/><ref id=\"b\"/></shape>"));
  REQUIRE(referring.warnings.size() == 1);
  CHECK(shortened(referring.warnings)[0].find("4:22: warning: ") == 0);
  CHECK(shortened(referring.warnings)[0].find(":4:35") != std::string::npos);
  const std::string lamp = "<emitter type=\"area\"/>";
  CHECK(problems(old("<shape type=\"sphere\">" + lamp + lamp + "</shape>")).at(0).find("more than one <emitter>") !=
        std::string::npos);
  CHECK(loaded(conductor + "<shape type=\"sphere\"><ref id=\"b\"/></shape>").shapes.size() == 1);
}

TEST_CASE("0.x: of two textures of one name the last counts, and the other is named") {
  const LoadedScene found = load_text(
      old("<texture type=\"checkerboard\" id=\"t\"/><texture type=\"checkerboard\" id=\"u\"><rgb name=\"color0\" "
          "value=\"1\"/></texture><bsdf type=\"diffuse\"><ref name=\"reflectance\" id=\"t\"/><ref name=\"reflectance\" "
          "id=\"u\"/></bsdf>"));
  const int shown = std::get<Diffuse>(found.scene.materials.at(1).bsdf).reflectance.texture;
  CHECK(std::get<Checkerboard>(found.scene.textures.at(static_cast<std::size_t>(shown)).pattern).color0 ==
        Rgb{1, 1, 1});
  REQUIRE(found.warnings.size() == 1);
  CHECK_THAT(found.warnings[0].message, Catch::Contains("has no use for \"t\", a <texture>"));
}

TEST_CASE("0.x: types in capitals are read by the same rules") {
  const auto eta = [](const std::string& type) {
    return std::get<Conductor>(loaded("<bsdf type=\"" + type + "\"/>").materials.at(1).bsdf).index.eta.color;
  };
  CHECK(eta("Conductor") == eta("conductor"));
  CHECK_FALSE(eta("Conductor") == Rgb{0, 0, 0});
  const Scene sky =
      loaded("<emitter type=\"SunSky\"><vector name=\"sunDirection\" x=\"0\" y=\"1\" z=\"0.5\"/></emitter>");
  CHECK(std::get<EnvironmentLight>(sky.lights.at(1).emitter).axes[1] == Vec3{0, 1, 0});
  const Scene grey = loaded("<bsdf type=\"Diffuse\"><rgb name=\"diffuseReflectance\" value=\"0.25\"/></bsdf>");
  CHECK(std::get<Diffuse>(grey.materials.at(1).bsdf).reflectance.color == Rgb{0.25, 0.25, 0.25});
}

TEST_CASE("0.x: a normalmap takes the texture inside it, whatever its name") {
  const std::string board = "<texture type=\"checkerboard\" id=\"t\"", inside = "<bsdf type=\"diffuse\"/></bsdf>";
  for (const std::string& given :
       {"<bsdf type=\"normalmap\">" + board + "/>", "<bsdf type=\"NormalMap\">" + board + " name=\"normals\"/>",
        "<bsdf type=\"normalmap\">" + board + " name=\"normalmap\"/>",
        board + "/><bsdf type=\"normalmap\"><ref id=\"t\"/>"}) {
    INFO(given);
    const Scene scene = loaded(given + inside);
    CHECK(std::get<Relief>(scene.materials.back().bsdf).map.texture == 0);
  }
  const auto fault = [&](const std::string& text) { return problems(text).at(0); };
  CHECK_THAT(fault(old("<bsdf type=\"normalmap\">" + inside)), Catch::Contains("needs one <texture> inside"));
  CHECK_THAT(fault(around("<bsdf type=\"normalmap\">" + board + "/>" + inside)), Catch::Contains("needs a normalmap"));
}

TEST_CASE("0.x: ambient occlusion looks half as far as the scene's sphere is wide, or as far as rayLength says") {
  const auto ao = [](const std::string& inside) {
    return load_text(
        old("<shape type=\"cube\"/><shape type=\"sphere\"><point name=\"center\" x=\"9\" y=\"0\" "
            "z=\"0\"/></shape><integrator type=\"ao\">" +
            inside + "</integrator>"));
  };
  const auto length = [](const std::string& value) { return "<float name=\"rayLength\" value=\"" + value + "\"/>"; };
  const double half = std::hypot(5.5, 1, 1) / 2;
  CHECK(ao("").scene.integrator.max_distance == Approx(half).epsilon(1e-12));
  CHECK(ao(length("-1")).scene.integrator.max_distance == Approx(half).epsilon(1e-12));
  CHECK(ao(length("0.75")).scene.integrator.max_distance == 0.75);
  CHECK(ao("<float name=\"maxDistance\" value=\"3\"/>").scene.integrator.max_distance == 3);
  REQUIRE(ao("").warnings.size() == 1);
  CHECK_THAT(ao("").warnings[0].message, Catch::Contains("black where nothing is hit, which is white in Mitsuba 0.x"));
  const LoadedScene own = load_body("<shape type=\"cube\"/><integrator type=\"ao\"/>");
  CHECK(own.warnings.empty());
  CHECK(std::isinf(own.scene.integrator.max_distance));
}

TEST_CASE("0.x: a bsdf by the name of an OBJ's material covers its faces") {
  const SceneFolder folder;
  folder.write("a.obj",
               "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nf 1 2 3\nusemtl GreenGlass\nf 1 2 4\n"
               "usemtl red\nf 1 2 5\n");
  folder.write("a.mtl", "newmtl red\nKd 0.5 0 0\nKe 1 1 1\nnewmtl GreenGlass\nKd 0 0.5 0\nKe 1 1 1\n");
  const auto load = [&](const std::string& inside) {
    return load_scene(folder.write("scene.xml", old("<bsdf type=\"conductor\" id=\"m\"/><shape type=\"obj\"><string "
                                                    "name=\"filename\" value=\"a.obj\"/>" +
                                                    inside + "</shape>")));
  };
  const auto of_face = [](const Scene& scene, std::size_t face) {
    const auto& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
    const std::size_t part = static_cast<std::size_t>(mesh.part_of_triangle.at(face));
    return scene.materials.at(static_cast<std::size_t>(mesh.parts.at(part).material)).bsdf;
  };
  const auto kd = [](const auto& bsdf) { return std::get<Diffuse>(bsdf).reflectance.color; };
  const std::string glass = "<bsdf type=\"dielectric\" name=\"GreenGlass\"/>";
  const LoadedScene one = load(glass);
  CHECK(shortened(one.warnings).empty());
  CHECK(kd(of_face(one.scene, 0)) == Rgb{0.5, 0.5, 0.5});
  CHECK(std::holds_alternative<Dielectric>(of_face(one.scene, 1)));
  CHECK(kd(of_face(one.scene, 2)) == Rgb{0.5, 0, 0});
  const auto& parts = std::get<Mesh>(one.scene.shapes.at(0).geometry).parts;
  CHECK(std::count_if(parts.begin(), parts.end(), [](const MeshPart& part) { return part.radiance.has_value(); }) == 1);
  const Scene both = load(glass + "<ref name=\"red\" id=\"m\"/>").scene;
  CHECK(std::holds_alternative<Dielectric>(of_face(both, 1)));
  CHECK(std::holds_alternative<Conductor>(of_face(both, 2)));
  const Scene plain = load(glass + "<boolean name=\"loadMaterials\" value=\"false\"/>").scene;
  CHECK(std::holds_alternative<Dielectric>(of_face(plain, 1)));
  CHECK(kd(of_face(plain, 2)) == Rgb{0.5, 0.5, 0.5});
  const Scene bare = load("<boolean name=\"loadMaterials\" value=\"false\"/>").scene;
  CHECK(std::get<Mesh>(bare.shapes.at(0).geometry).parts.empty());
  const Scene only = load("<ref name=\"bsdf\" id=\"m\"/>").scene;  // No material's name, so it is the shape's.
  CHECK(std::get<Mesh>(only.shapes.at(0).geometry).parts.empty());
  CHECK(only.shapes[0].material == 1);
  const LoadedScene wrong = load("<bsdf type=\"dielectric\" name=\"greenglass\"/>" + glass);
  REQUIRE(wrong.warnings.size() == 1);
  CHECK_THAT(wrong.warnings[0].message, Catch::Contains("no face of the file has the material \"greenglass\""));
  // Without its library: what has a bsdf by name lacks nothing.
  std::filesystem::remove(folder.path("a.mtl"));
  CHECK(shortened(load(glass + "<ref name=\"red\" id=\"m\"/>").warnings).empty());
  const LoadedScene lacking = load(glass);
  REQUIRE(lacking.warnings.size() == 2);
  CHECK_THAT(lacking.warnings[1].message,
             Catch::Contains("defines: 1; they become the default diffuse; the first is \"red\""));
}

TEST_CASE("0.x: a serialized file may say that it is shaded flat, which Mitsuba 3 ignores and face_normals overrules") {
  const SceneFolder folder;
  SerializedMesh mesh;
  const auto has_normals = [&](bool is_old, const std::string& inside) {
    folder.write("a.serialized", serialized_file({mesh}));
    const std::string shape =
        "<shape type=\"serialized\"><string name=\"filename\" value=\"a.serialized\"/>" + inside + "</shape>";
    const LoadedScene scene = load_scene(folder.write("scene.xml", is_old ? old(shape) : around(shape)));
    CHECK(shortened(scene.warnings).empty());
    return !std::get<Mesh>(scene.scene.shapes.at(0).geometry).normals.empty();
  };
  for (const bool has_own : {false, true}) {
    mesh.flags = has_own ? 0x1011 : 0x1010;
    if (has_own) mesh.numbers.insert(mesh.numbers.end(), {0, 0, 1, 0, 0, 1, 0, 0, 1});
    CHECK_FALSE(has_normals(true, ""));
    CHECK(has_normals(true, "<boolean name=\"faceNormals\" value=\"false\"/>"));
    CHECK(has_normals(false, ""));
    CHECK(has_normals(false, "<boolean name=\"face_normals\" value=\"false\"/>"));
    CHECK_FALSE(has_normals(false, "<boolean name=\"face_normals\" value=\"true\"/>"));
  }
}

TEST_CASE("0.x: a mixture is a chain of blends; what its weights lack of 1 is black, what is beyond is scaled") {
  const auto mixture = [](const std::string& weights, int bsdfs) {
    std::string text =
        "<scene version=\"0.6.0\"><bsdf type=\"mixturebsdf\"><string name=\"weights\" value=\"" + weights + "\"/>";
    for (int i = 1; i <= bsdfs; ++i)
      text += "<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" value=\"0." + std::to_string(i) + "\"/></bsdf>";
    return load_text(text + "</bsdf><sensor type=\"perspective\"/></scene>");
  };
  // The light that surfaces reflect: the sum of weights times reflectances.
  const auto reflected = [](const LoadedScene& loaded) {
    CHECK(loaded.warnings.empty());
    const auto of = [&](const auto& self, const Material& material) -> double {
      if (const auto* diffuse = std::get_if<Diffuse>(&material.bsdf)) return diffuse->reflectance.color.g;
      const Blend& blend = std::get<Blend>(material.bsdf);
      const double weight = blend.weight.color.g;
      const auto at = [&](int i) { return self(self, loaded.scene.materials.at(static_cast<std::size_t>(i))); };
      return (1 - weight) * at(blend.first) + weight * at(blend.second);
    };
    return of(of, loaded.scene.materials.back());
  };
  CHECK(reflected(mixture("0.7, 0.3", 2)) == Approx(.7 * .1 + .3 * .2));
  CHECK(reflected(mixture("0.5 0 0.25", 3)) == Approx(.5 * .1 + .25 * .3));
  CHECK(reflected(mixture("1, 2, 1", 3)) == Approx(.25 * .1 + .5 * .2 + .25 * .3));
  CHECK(mixture(".7 .2 .1", 3).scene.materials.size() == mixture(".5 .25 .25", 3).scene.materials.size());
  CHECK(reflected(mixture("0", 1)) == 0);
  CHECK(reflected(mixture("1", 1)) == Approx(.1));
  for (const char* faulty : {"0.5", "0.5, -1", "0.5, x", ""}) {
    INFO(faulty);
    CHECK_THROWS_WITH(mixture(faulty, 2), Catch::Contains("needs 1 to 64 <bsdf> and in \"weights\" a number for each"));
  }
}

TEST_CASE("0.x: hexadecimal digits of an <rgb> are linear, of an <srgb> encoded") {
  const auto seen = [](const std::string& version, const std::string& tag) {
    const Scene scene =
        load_text("<scene version=\"" + version + "\"><sensor type=\"perspective\"/><bsdf type=\"diffuse\"><" + tag +
                  " name=\"reflectance\" value=\" #80ff00\"/></bsdf></scene>")
            .scene;
    return std::get<Diffuse>(scene.materials.at(1).bsdf).reflectance.color;
  };
  CHECK(seen("0.6.0", "rgb") == Rgb{128.0 / 255, 1, 0});
  const double decoded = std::pow((128.0 / 255 + 0.055) / 1.055, 2.4);
  for (const char* version : {"0.6.0", "3.0.0"}) {
    CHECK(seen(version, "srgb").r == Approx(decoded));
    CHECK(seen(version, "srgb").g == 1);
  }
  CHECK(seen("2.1.0", "rgb").r == Approx(decoded));
}

TEST_CASE("0.x: rules that go by a type know it where it is a $name, or has parameters in another file") {
  const auto with = [](const std::string& type, const std::string& body) {
    return "<default name=\"t\" value=\"" + type + "\"/>" + body;
  };
  const auto eta = [](const Scene& scene) { return std::get<Conductor>(scene.materials.at(1).bsdf).index.eta.color; };
  const Rgb copper = eta(loaded("<bsdf type=\"conductor\"/>"));
  CHECK(eta(loaded(with("conductor", "<bsdf type=\"$t\"/>"))) == copper);
  const LoadedScene ao = load_text(old(with("ao", "<shape type=\"cube\"/><integrator type=\"$t\"/>")));
  CHECK(std::isfinite(ao.scene.integrator.max_distance));
  const Scene sky = loaded(
      with("sunsky", "<emitter type=\"$t\"><vector name=\"sunDirection\" x=\"0\" y=\"1\" z=\"0.5\"/></emitter>"));
  CHECK(std::get<EnvironmentLight>(sky.lights.at(1).emitter).axes[1] == Vec3{0, 1, 0});

  const Rgb gold = eta(loaded("<bsdf type=\"conductor\"><string name=\"material\" value=\"Au\"/></bsdf>"));
  const SceneFolder folder;
  folder.write("gold.xml", "<scene version=\"0.6.0\"><string name=\"material\" value=\"Au\"/></scene>");
  const auto load = [&](const std::string& text) { return load_scene(folder.write("scene.xml", text)); };
  CHECK(eta(load(old("<bsdf type=\"conductor\"><include filename=\"gold.xml\"/></bsdf>")).scene) == gold);
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl GreenGlass\nf 1 2 3\n");
  const Scene obj = load(old(with("obj",
                                  "<shape type=\"$t\"><string name=\"filename\" value=\"a.obj\"/><bsdf "
                                  "type=\"dielectric\" name=\"GreenGlass\"/></shape>")))
                        .scene;
  CHECK_FALSE(std::get<Mesh>(obj.shapes.at(0).geometry).parts.empty());
  // The shape around an <include> is that of what it includes.
  const std::string glass = "<bsdf type=\"dielectric\" name=\"GreenGlass\"/>";
  const auto scene_of = [](const std::string& inside) { return "<scene version=\"0.6.0\">" + inside + "</scene>"; };
  folder.write("bare.xml", glass);
  for (const std::string& included : {glass, scene_of(glass), scene_of("<include filename=\"bare.xml\"/>")}) {
    CAPTURE(included);
    folder.write("glass.xml", included);
    const LoadedScene found = load(old(
        "<shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/><include filename=\"glass.xml\"/></shape>"));
    CHECK(shortened(found.warnings).empty());
    CHECK_FALSE(std::get<Mesh>(found.scene.shapes.at(0).geometry).parts.empty());
  }
}

TEST_CASE("a file of one object without a version has that of the file that includes it, others their own") {
  const SceneFolder folder;
  folder.write("bare.xml", "<bsdf type=\"conductor\"/>");
  folder.write("of_3.xml", "<bsdf version=\"3.0.0\" type=\"conductor\"/>");
  folder.write("of_0.xml", "<bsdf version=\"0.6.0\" type=\"conductor\"/>");
  folder.write("map.xml", "<texture type=\"checkerboard\"/>");
  const auto is_copper = [&](const std::string& version, const std::string& file) {
    const std::string text =
        "<scene version=\"" + version + "\"><sensor type=\"perspective\"/><include filename=\"" + file + "\"/></scene>";
    const LoadedScene found = load_scene(folder.write("scene.xml", text), {{}, true});
    return std::get<Conductor>(found.scene.materials.at(1).bsdf).index.eta.color != Rgb{0, 0, 0};
  };
  CHECK(is_copper("0.6.0", "bare.xml"));
  CHECK_FALSE(is_copper("3.0.0", "bare.xml"));
  CHECK_FALSE(is_copper("0.6.0", "of_3.xml"));
  CHECK(is_copper("3.0.0", "of_0.xml"));
  // The name is the includer's, too.
  const std::string plastic =
      old("<bsdf type=\"plastic\"><include filename=\"map.xml\" name=\"diffuseReflectance\"/></bsdf>");
  const LoadedScene named = load_scene(folder.write("scene.xml", plastic), {{}, true});
  CHECK(std::get<Plastic>(named.scene.materials.at(1).bsdf).diffuse_reflectance.texture == 0);
}

TEST_CASE("0.x: what the rules write is no parameter of a file, nor unknown where nobody asks for it") {
  const std::string group =
      "<medium type=\"homogeneous\" id=\"fog\"/><shape type=\"shapegroup\" id=\"g\"><shape type=\"sphere\"/></shape>"
      "<shape type=\"instance\"><ref id=\"g\"/><ref name=\"interior\" id=\"fog\"/></shape>";
  for (const std::string& problem : problems(old(group))) {
    CAPTURE(problem);
    CHECK(problem.find("is_open") == std::string::npos);
  }
  const std::vector<std::string> own =
      problems(around("<emitter type=\"sunsky\"><boolean name=\"is_y_up\" value=\"true\"/></emitter>"));
  REQUIRE(own.size() == 1);
  CHECK_THAT(own[0], Catch::Contains("warning: unknown parameter \"is_y_up\""));
  CHECK_THAT(problems(around("<0.x name=\"is_y_up\"/>")).at(0), Catch::Contains("malformed XML"));
}
