// SPDX-License-Identifier: MIT
// Scenes as others write them: folders of <path>, the loose values of Mitsuba 0.x, integrators around others, shapes
// that vanish, lights that are lost, and one message for many alike.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "scene/readers/foreign_plugins.h"
#include "scene/readers/metals.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const char* const triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const char* const flat_obj = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";

std::string obj(const std::string& name) {
  return "<shape type=\"obj\"><string name=\"filename\" value=\"" + name + "\"/></shape>";
}

std::vector<std::string> problems_of(const SceneFolder& folder, const std::string& body,
                                     const LoadOptions& options = {}) {
  try {
    return shortened(load_scene(folder.write("scene.xml", around(body)), options).warnings);
  } catch (const SceneError& error) {
    return shortened(error.diagnostics());
  }
}

std::string old(const std::string& body) {
  return "<scene version=\"0.6.0\">\n" + body + "\n<sensor type=\"perspective\"/></scene>\n";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("<path> puts a folder before all others, for included files too, and the last one first") {
  const SceneFolder folder;
  folder.write("a.obj", flat_obj);
  folder.write("near/a.obj", triangle_obj);
  folder.write("far/a.obj", std::string(triangle_obj) + "f 1 3 2\n");
  folder.write("far/b.obj", triangle_obj);
  folder.write("near/part.xml", "<scene version=\"3.0.0\">" + obj("b.obj") + "</scene>");
  const std::string text = around("<path value=\"far\"/><path value=\"near\"/><include filename=\"part.xml\"/>" +
                                  obj("a.obj") + obj("b.obj"));
  const LoadedScene loaded = load_scene(folder.write("scene.xml", text));
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.shapes.size() == 3);
  CHECK(primitive_count(loaded.scene.shapes[1]) == 1);
  CHECK(problems_of(folder, "<path value=\"nowhere\"/>")
            .at(0)
            .find("2:1: warning: \"" + folder.path("nowhere") + "\" is no folder") == 0);
  CHECK(contains(problems_of(folder, "<path/>").at(0), "needs the attribute value"));
}

TEST_CASE("backslashes of Windows are slashes where no file has them in its name") {
  const SceneFolder folder;
  folder.write("meshes/a.obj", triangle_obj);
  CHECK(problems_of(folder, obj("meshes\\a.obj")).empty());
  CHECK(problems_of(folder, "<path value=\".\\meshes\"/>" + obj("a.obj")).empty());
  folder.write("meshes\\a.obj", std::string(triangle_obj) + "f 1 3 2\n");
  const Scene scene = load_scene(folder.write("scene.xml", around(obj("meshes\\a.obj")))).scene;
  CHECK(primitive_count(scene.shapes.at(0)) == 2);
  CHECK(contains(problems_of(folder, obj("no\\b.obj")).at(0), "no\\b.obj"));
}

TEST_CASE("a parameter given twice: in 0.x the last counts, in 3 it is an error") {
  const std::string twice =
      "<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><float name=\"radius\" value=\"2\"/></shape>";
  const LoadedScene loaded = load_text(old(twice));
  CHECK(std::get<Sphere>(loaded.scene.shapes.at(0).geometry).radius == 2);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(contains(loaded.warnings[0].message, "\"radius\" is given again at"));
  CHECK(contains(problems(around(twice)).at(0), "given twice"));
}

TEST_CASE("True, and integers beyond 32 bits") {
  const Scene scene =
      load_text(
          "<scene version=\"3.0.0\"><integrator type=\"path\"><boolean name=\"hide_emitters\" "
          "value=\"True\"/></integrator><sensor type=\"perspective\"><sampler type=\"independent\">"
          "<integer name=\"sample_count\" value=\"99999999999999999999999\"/></sampler></sensor></scene>")
          .scene;
  CHECK(scene.integrator.hide_emitters);
  CHECK(scene.sampler.sample_count == 2147483647);
}

TEST_CASE("in 0.x a metal without a name is copper") {
  const auto eta_of = [](const std::string& text) {
    return std::get<Conductor>(load_text(text).scene.materials.at(1).bsdf).index.eta.color;
  };
  CHECK(eta_of(old("<bsdf type=\"conductor\"/>")) == metal_index("Cu")->eta.color);
  CHECK(eta_of(old("<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/></bsdf>")) == Rgb{0, 0, 0});
  CHECK(eta_of(old("<bsdf type=\"conductor\"><string name=\"material\" value=\"None\"/></bsdf>")) == Rgb{0, 0, 0});
  CHECK(std::get<Conductor>(load_body("<bsdf type=\"conductor\"/>").scene.materials.at(1).bsdf).index.eta.color ==
        Rgb{0, 0, 0});
  CHECK(contains(problems(around("<bsdf type=\"conductor\"><string name=\"material\" value=\"None\"/></bsdf>")).at(0),
                 "\"None\" is no metal"));
}

TEST_CASE("in 0.x eta and k replace those of the metal, each by itself") {
  const std::string gold = "<string name=\"material\" value=\"Au\"/>", eta = "<float name=\"eta\" value=\"2\"/>",
                    k = "<float name=\"k\" value=\"3\"/>";
  const auto index_of = [](const std::string& type, const std::string& inside) {
    const LoadedScene loaded = load_text(old("<bsdf type=\"" + type + "\">" + inside + "</bsdf>"));
    CHECK(shortened(loaded.warnings).empty());
    const auto& bsdf = loaded.scene.materials.at(1).bsdf;
    const auto* rough = std::get_if<RoughConductor>(&bsdf);
    return rough != nullptr ? rough->index : std::get<Conductor>(bsdf).index;
  };
  for (const char* type : {"conductor", "roughconductor"}) {
    CHECK(index_of(type, eta).eta.color == Rgb{2, 2, 2});
    CHECK(index_of(type, eta).k.color == metal_index("Cu")->k.color);
    CHECK(index_of(type, k).eta.color == metal_index("Cu")->eta.color);
    CHECK(index_of(type, gold + k).eta.color == metal_index("Au")->eta.color);
    CHECK(index_of(type, gold + k).k.color == Rgb{3, 3, 3});
    CHECK(index_of(type, eta + k).eta.color == Rgb{2, 2, 2});
  }
  CHECK(contains(problems(around("<bsdf type=\"conductor\">" + gold + k + "</bsdf>")).at(0),
                 "either a material or eta and k"));
}

TEST_CASE("integrators around others take the one inside; unknown ones become path") {
  const auto integrator = [](const std::string& text) { return load_body(text).scene.integrator; };
  for (const char* type : {"aov", "moment", "stokes", "multichannel", "irrcache", "motion", "mine"}) {
    INFO(type);
    const IntegratorSettings inside = integrator(
        "<integrator type=\"" + std::string(type) +
        "\"><integrator type=\"whitted\"><integer name=\"max_depth\" value=\"3\"/></integrator></integrator>");
    CHECK(inside.name == "whitted");
    CHECK(inside.max_depth == 3);
  }
  CHECK(integrator("<integrator type=\"photonmapper\"/>").name == "path");
  CHECK(integrator("<integrator type=\"mine\"><float name=\"x\" value=\"1\"/></integrator>").name == "path");
  const std::vector<std::string> stokes = problems(around("<integrator type=\"stokes\"/>"));
  REQUIRE(stokes.size() == 1);
  CHECK(contains(stokes[0], "integrator \"stokes\" is not supported yet; \"path\" takes its place"));
  CHECK_FALSE(contains(stokes[0], "did you mean"));
  const std::vector<std::string> cache =
      problems(around("<integrator type=\"irrcache\"><integrator type=\"direct\"/></integrator>"));
  REQUIRE(cache.size() == 1);
  CHECK(contains(cache[0], "integrator \"irrcache\" is not supported yet; the one inside it renders"));
}

TEST_CASE("a chain of integrators is read to a depth of 256") {
  const auto chain = [](int length) {
    std::string text = "<integrator type=\"stokes\"><ref id=\"i0\"/></integrator>";
    // Definitions within something that renders nothing.
    text += "<shape type=\"sphere\" id=\"definitions\">";
    for (int i = 0; i < length; ++i)
      text += "<integrator type=\"stokes\" id=\"i" + std::to_string(i) + "\"><ref id=\"i" + std::to_string(i + 1) +
              "\"/></integrator>\n";
    return problems(around(text + "<integrator type=\"direct\" id=\"i" + std::to_string(length) + "\"/></shape>"));
  };
  const auto is_too_deep = [](const std::vector<std::string>& lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line) { return contains(line, "nested deeper than 256"); });
  };
  CHECK_FALSE(is_too_deep(chain(255)));
  CHECK(is_too_deep(chain(256)));
  CHECK(is_too_deep(chain(2000)));
}

TEST_CASE("an area emitter that no shape refers to is told") {
  const std::string lamp = "<emitter type=\"area\" id=\"lamp\"/>";
  const std::vector<std::string> alone = problems(around(lamp + "<shape type=\"sphere\"/><emitter type=\"point\"/>"));
  REQUIRE(alone.size() == 1);
  CHECK(contains(alone[0], "2:1: warning: no <shape> refers to the area emitter \"lamp\"; it is left out"));
  CHECK(problems(around(lamp + "<shape type=\"sphere\"><ref id=\"lamp\"/></shape>")).empty());
}

TEST_CASE("integrators that contain each other are an error") {
  const std::vector<std::string> found =
      problems(around("<integrator type=\"aov\" id=\"a\"><integrator type=\"moment\"><ref id=\"a\"/></integrator>"
                      "</integrator>"));
  REQUIRE_FALSE(found.empty());
  CHECK(std::any_of(found.begin(), found.end(),
                    [](const std::string& line) { return contains(line, "contains itself"); }));
}

TEST_CASE("volpath is path where the scene has nothing that light passes straight") {
  CHECK(problems(around("<integrator type=\"volpath\"/>")).empty());
  CHECK(load_body("<integrator type=\"volpath\"/>").scene.integrator.name == "path");
  const std::string pane =
      "<integrator type=\"volpath\"/><shape type=\"rectangle\"><bsdf type=\"thindielectric\"/></shape>";
  CHECK(load_body(pane).scene.integrator.name == "volpath");
  const std::string filled = "<shape type=\"sphere\"><medium type=\"homogeneous\" name=\"interior\"/></shape>";
  for (const std::string integrator : {"", "<integrator type=\"volpathmis\"/>", "<integrator type=\"prbvolpath\"/>",
                                       "<integrator type=\"volpath_simple\"/>"})
    CHECK(load_body(integrator + filled).scene.integrator.name == "volpath");
}

TEST_CASE("a stretched disk becomes a polygon of the same area that faces the same way") {
  for (const double mirrored : {1.0, -1.0}) {
    const LoadedScene loaded = load_body("<shape type=\"disk\"><transform name=\"to_world\"><scale x=\"" +
                                         std::to_string(2 * mirrored) + "\" y=\"3\"/></transform></shape>");
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(contains(loaded.warnings[0].message, "makes an ellipse"));
    const Shape& shape = loaded.scene.shapes.at(0);
    const Mesh& mesh = std::get<Mesh>(shape.geometry);
    Vec3 area;
    for (const auto& t : mesh.triangles) {
      const auto corner = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(t[i])]; };
      area = area + 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    }
    CHECK((shape.flip_normals ? -1 : 1) * area.z == Approx(6 * std::acos(-1)).epsilon(1e-12));
  }
}

TEST_CASE("a mesh of degenerate faces is left out, and a group that has lost all its shapes, with its instances") {
  const SceneFolder folder;
  folder.write("flat.obj", flat_obj);
  const std::vector<std::string> mesh = problems_of(folder, obj("flat.obj"));
  REQUIRE(mesh.size() == 1);
  CHECK(contains(mesh[0], "2:19: warning: \"" + folder.path("flat.obj") + "\" has no triangle with an area"));
  const std::string group = "<shape type=\"shapegroup\" id=\"g\">" + obj("flat.obj") +
                            "</shape><shape type=\"instance\"><ref id=\"g\"/></shape><shape type=\"sphere\"/>";
  const LoadedScene loaded = load_scene(folder.write("scene.xml", around(group)));
  CHECK(loaded.warnings.size() == 2);
  CHECK(loaded.scene.groups.empty());
  CHECK(loaded.scene.instances.empty());
  CHECK(loaded.scene.shapes.size() == 1);
}

TEST_CASE("what Mitsuba has is not supported yet; only what nobody has is guessed at") {
  for (const char* body : {"<shape type=\"sdfgrid\"/>", "<shape type=\"sphere\"><bsdf type=\"hair\"/></shape>",
                           "<emitter type=\"volumelight\"/>", "<integrator type=\"photonmapper\"/>"}) {
    const std::string first = problems(around(body)).at(0), all = first + problems(around(body)).back();
    INFO(all);
    CHECK(contains(all, "is not supported yet"));
    CHECK_FALSE(contains(all, "did you mean"));
  }
  CHECK(contains(problems(around("<emitter type=\"piont\"/>")).back(), "did you mean \"point\"?"));
}

TEST_CASE("light tracing has two names, as in Mitsuba") {
  const SceneFolder folder;
  for (const char* name : {"ptracer", "particle"}) {
    const std::string body = "<shape type=\"sphere\"/><integrator type=\"" + std::string(name) + "\"/>";
    CHECK(load_scene(folder.write("scene.xml", around(body))).scene.integrator.name == "ptracer");
  }
}

TEST_CASE("bdpt is taken with what Mitsuba 0.x says about its techniques") {
  const SceneFolder folder;
  const std::string body =
      "<shape type=\"sphere\"/><integrator type=\"bdpt\"><boolean name=\"light_image\" value=\"false\"/>"
      "<boolean name=\"sample_direct\" value=\"false\"/></integrator>";
  const LoadedScene loaded = load_scene(folder.write("scene.xml", around(body)));
  CHECK(loaded.scene.integrator.name == "bdpt");
  CHECK(loaded.warnings.empty());
}

TEST_CASE("the document lists every type of Mitsuba") {
  std::ifstream file(STRAHL_SOURCE_DIR "/docs/scene-plugins.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const char* tag :
       {"shape", "bsdf", "texture", "emitter", "sensor", "film", "rfilter", "sampler", "integrator"}) {
    REQUIRE_FALSE(mitsuba_types(tag).empty());
    const std::size_t row = text.find("| `<" + std::string(tag) + ">`", text.find("## Every plugin"));
    REQUIRE(row != std::string::npos);
    const std::string line = text.substr(row, text.find('\n', row) - row);
    for (const std::string& type : mitsuba_types(tag)) {
      INFO(tag << " " << type);
      CHECK(contains(line, "`" + type + "`"));
    }
  }
}

TEST_CASE("a scene that has lost every light says so once") {
  const auto lost = [](const std::string& body) {
    const std::vector<std::string> found = problems(around(body));
    return std::count_if(found.begin(), found.end(),
                         [](const std::string& line) { return contains(line, "no light is left"); });
  };
  CHECK(lost("<emitter type=\"volumelight\"/><emitter type=\"volumelight\"/>") == 1);
  CHECK(lost("<shape type=\"hair\"><emitter type=\"area\"/></shape>") == 1);
  CHECK(lost("<emitter type=\"volumelight\"/><emitter type=\"point\"/>") == 0);
  CHECK(lost("<emitter type=\"volumelight\"/><shape type=\"sphere\"><emitter type=\"area\"/></shape>") == 0);
  CHECK(lost("") == 0);
}

TEST_CASE("more than three alike are one, with a count and the next two places") {
  std::string body;
  for (int i = 0; i < 100; ++i) body += "<shape type=\"hair\"/>\n";
  std::vector<std::string> found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0],
                 "2:1: warning: shape \"hair\" is not supported yet; it is left out; 99 more like it, the next at "));
  CHECK(contains(found[0], "scene.xml:3:1 and "));
  body.clear();
  for (int i = 0; i < 50; ++i) body += obj("m" + std::to_string(i) + ".obj") + "\n";
  found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0], "2:19: error: cannot read"));
  CHECK(contains(found[0], "m0.obj"));
  CHECK(contains(found[0], "49 more like it"));
  body.clear();
  for (int i = 0; i < 50; ++i)
    body += "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string name=\"filename\" value=\"t" +
            std::to_string(i) + ".png\"/></texture></bsdf>\n";
  found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0], "t0.png"));
  CHECK(contains(found[0], "49 more like it"));
  body.clear();
  for (int i = 0; i < 25; ++i)
    body += "<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" filename=\"s" + std::to_string(i) +
            ".spd\"/></bsdf>\n<include filename=\"i" + std::to_string(i) + ".xml\"/>\n";
  found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0], "2:22: error: cannot read"));
  CHECK(contains(found[0], "s0.spd"));
  CHECK(contains(found[0], "49 more like it, the next at "));
}

TEST_CASE("warnings that differ in numbers alone are alike, those that differ in names are not") {
  std::string body;
  for (int i = 0; i < 50; ++i)
    body += "<shape type=\"sphere\"><transform name=\"to_world\"><rotate x=\"1.5\" y=\"0.3\" angle=\"" +
            std::to_string(7 * (i - 25)) + ".5\"/></transform></shape>\n";
  std::vector<std::string> found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0], "the axis of <rotate> has length"));
  CHECK(contains(found[0], "49 more like it"));
  body.clear();
  for (int i = 0; i < 5; ++i)
    body += "<shape type=\"sphere\"><float name=\"p" + std::to_string(i) + "\" value=\"1\"/></shape>\n";
  CHECK(problems(around(body)).size() == 5);
}

TEST_CASE("errors of a mesh name the place that asks for it; MTL is told of only where it is used") {
  const SceneFolder folder;
  folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  CHECK(contains(problems_of(folder, obj("bad.obj")).at(0), "scene.xml:2:19)"));
  folder.write("a.obj", std::string("mtllib none.mtl\nusemtl x\n") + triangle_obj);
  const std::vector<std::string> used = problems_of(folder, obj("a.obj"));
  CHECK(used.size() == 2);
  CHECK(problems_of(folder,
                    "<shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/><bsdf type=\"diffuse\"/>"
                    "</shape>")
            .empty());
}

TEST_CASE("films of 0.x") {
  const LoadedScene loaded = load_text(
      "<scene version=\"0.6.0\"><sensor type=\"perspective\"><film type=\"ldrfilm\"><integer name=\"width\" "
      "value=\"32\"/><float name=\"gamma\" value=\"-1\"/><boolean name=\"banner\" value=\"false\"/><string "
      "name=\"fileFormat\" value=\"png\"/></film></sensor></scene>");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.film.width == 32);
}
