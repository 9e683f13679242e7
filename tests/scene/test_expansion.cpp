// SPDX-License-Identifier: MIT
// <default>, $name, -D, <include>, <alias>, and the names of Mitsuba 0.x.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "scene/scene_text.h"
#include "scene/xml/xml_upgrade.h"

using namespace strahl;
using namespace strahl::test;

namespace {

double radius(const Scene& scene, std::size_t shape = 0) {
  return std::get<Sphere>(scene.shapes.at(shape).geometry).radius;
}

const char* const sphere_of_r = "<shape type=\"sphere\"><float name=\"radius\" value=\"$r\"/></shape>";

}  // namespace

TEST_CASE("defaults, and -D before them") {
  const std::string body =
      std::string("<default name=\"r\" value=\"2\"/><default name=\"r\" value=\"3\"/>") + sphere_of_r;
  CHECK(radius(load_body(body).scene) == 2);
  CHECK(radius(load_body(body, {{{"r", "5"}}, false}).scene) == 5);
  CHECK(radius(load_body(sphere_of_r, {{{"r", "7"}}, false}).scene) == 7);
  const Scene scene = load_body(
                          "<default name=\"a\" value=\"1\"/><default name=\"b\" value=\"$a.5\"/><shape type=\"sphere\" "
                          "id=\"x-$a-$b\"><float name=\"radius\" value=\"$b\"/></shape>")
                          .scene;
  CHECK(radius(scene) == 1.5);
  CHECK(scene.shapes[0].id == "x-1-1.5");
}

TEST_CASE("undefined and unused names") {
  CHECK(
      problems(around(std::string("<default name=\"rr\" value=\"1\"/>") + sphere_of_r)) ==
      std::vector<std::string>{"2:52: error: $r is not defined (did you mean \"rr\"?); give it a <default name=\"r\"> "
                               "before this place or -D r=..."});
  CHECK(problems(around(""), {{{"rse", "1"}}, false}) ==
        std::vector<std::string>{"0:0: warning: -D rse=1: the scene does not use $rse; it has no effect"});
  CHECK(
      problems(around(""), {{{"spp", "16"}}, false}) ==
      std::vector<std::string>{"0:0: warning: -D spp=16: the scene does not use $spp; it has no effect, --spp 16 has"});
  CHECK(problems(around(""), {{{"max_depth", "3"}}, false}) ==
        std::vector<std::string>{
            "0:0: warning: -D max_depth=3: the scene does not use $max_depth; it has no effect, --max-depth 3 has"});
}

TEST_CASE("a backslash keeps a dollar") {
  const std::string balls =
      "<default name=\"r\" value=\"2\"/><shape type=\"sphere\" id=\"$r\\$r$r\"/><shape type=\"sphere\" id=\"\\$\"/>";
  const LoadedScene loaded = load_body(balls);
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.shapes.at(0).id == "2$r2");
  CHECK(loaded.scene.shapes.at(1).id == "$");
}

TEST_CASE("a chain of defaults cannot grow without bound") {
  std::string body = "<default name=\"x0\" value=\"aaaaaaaaaaaaaaaa\"/>";
  for (int i = 1; i < 60; ++i) {
    const std::string previous = "$x" + std::to_string(i - 1);
    body += "<default name=\"x" + std::to_string(i) + "\" value=\"" + previous + previous + "\"/>";
  }
  const std::vector<std::string> found = problems(around(body));
  REQUIRE(!found.empty());
  CHECK(found[0].find("longer than 65536 bytes") != std::string::npos);
}

TEST_CASE("what all texts together grow by has a limit") {
  std::string body = "<default name=\"x\" value=\"" + std::string(60000, 'a') + "\"/>";
  for (int i = 0; i < 2000; ++i) body += "<default name=\"y" + std::to_string(i) + "\" value=\"$x\"/>\n";
  const std::vector<std::string> found = problems(around(body));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0],
             Catch::Contains("error: the values of $names make the scene longer by more than 67108864 bytes"));
  CHECK(problems(around("<default name=\"x\" value=\"a\"/><shape type=\"sphere\" id=\"$x\"/>")).empty());
}

TEST_CASE("very many parameters of one object are read in no time") {
  std::string many;
  for (int i = 0; i < 200000; ++i) many += "<float name=\"p" + std::to_string(i) + "\" value=\"1\"/>";
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<std::string> found =
      problems("<scene version=\"0.6.0\"><emitter type=\"piont\">" + many + "</emitter></scene>");
  CHECK(!found.empty());
  // A quadratic one takes minutes.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}

TEST_CASE("very many undefined names and ids are told in no time") {
  std::string many;
  for (int i = 0; i < 15000; ++i) {
    const std::string number = std::to_string(i);
    many +=
        "<default name=\"default_" + number + "\" value=\"1\"/><bsdf type=\"diffuse\" id=\"material_" + number + "\"/>";
  }
  std::string lacking;
  for (int i = 0; i < 15000; ++i) lacking += "<float name=\"x\" value=\"$defualt_" + std::to_string(i) + "\"/>";
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<std::string> names = problems(around(many + lacking));
  CHECK_THAT(names.at(0), Catch::Contains("$defualt_0 is not defined (did you mean \"default_0\"?)"));
  std::string references;
  for (int i = 0; i < 15000; ++i) references += "<ref id=\"matreial_" + std::to_string(i) + "\"/>";
  const std::vector<std::string> ids = problems(around(many + "<shape type=\"sphere\">" + references + "</shape>"));
  CHECK_THAT(ids.at(0), Catch::Contains("nothing has the id \"matreial_0\" (did you mean \"material_0\"?)"));
  // A quadratic one takes minutes.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(40));
}

TEST_CASE("files are looked for in the current folder last, within --root") {
  const SceneFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  const auto load = [&](const std::string& file, const std::string& root) {
    std::filesystem::current_path(folder.path("here"));
    LoadOptions options;
    options.root = root;
    std::vector<std::string> found;
    try {
      found = shortened(load_scene(folder.path("there/scene.xml"), options).warnings);
      const Scene scene = load_scene(folder.path("there/scene.xml"), options).scene;
      CHECK(primitive_count(scene.shapes.at(0)) == (file == "b.obj" ? 2 : 1));
    } catch (const SceneError& error) {
      found = shortened(error.diagnostics());
    }
    std::filesystem::current_path(before);
    return found;
  };
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  folder.write("here/models/a.obj", triangle);
  folder.write("here/b.obj", triangle);
  folder.write("there/b.obj", triangle + "f 1 3 2\n");
  const auto scene = [&](const std::string& file) {
    folder.write("there/scene.xml",
                 around("<shape type=\"obj\"><string name=\"filename\" value=\"" + file + "\"/></shape>"));
  };
  scene("models/a.obj");
  CHECK(load("models/a.obj", "").empty());
  CHECK(load("models/a.obj", folder.path("")).empty());
  CHECK_THAT(load("models/a.obj", folder.path("there")).at(0), Catch::Contains("it lies outside of --root"));
  scene("b.obj");
  CHECK(load("b.obj", "").empty());
  scene("c.obj");
  CHECK_THAT(load("c.obj", "").at(0), Catch::Contains(folder.path("there/c.obj")));
}

TEST_CASE("includes share names and count paths from their own folder") {
  const SceneFolder folder;
  folder.write("parts/balls.xml", std::string("<scene version=\"0.6.0\"><default name=\"r\" value=\"2\"/>") +
                                      sphere_of_r + "<include filename=\"one.xml\"/></scene>");
  folder.write("parts/one.xml", "<shape type=\"sphere\"><float name=\"radius\" value=\"$r\"/></shape>");
  const std::string main =
      folder.write("scene.xml", around(std::string("<include filename=\"parts/balls.xml\"/>") + sphere_of_r));
  const LoadedScene loaded = load_scene(main);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.shapes.size() == 3);
  CHECK(radius(loaded.scene, 2) == 2);
  CHECK(loaded.scene.shapes[1].where.file == folder.path("parts/one.xml"));
  CHECK(loaded.scene.name == "scene");
}

TEST_CASE("include cycles and missing includes end in errors at the <include>") {
  const SceneFolder folder;
  folder.write("a.xml", "<scene version=\"3.0.0\">\n<include filename=\"scene.xml\"/></scene>");
  const std::string main =
      folder.write("scene.xml", around("<include filename=\"a.xml\"/>\n<include filename=\"none.xml\"/>"));
  try {
    static_cast<void>(load_scene(main));
    FAIL("the cycle went unnoticed");
  } catch (const SceneError& error) {
    const std::vector<std::string> found = shortened(error.diagnostics());
    REQUIRE(found.size() == 2);
    CHECK(found[0].rfind("3:1: error: cannot read", 0) == 0);
    CHECK(found[1].rfind("a.xml:2:1: error:", 0) == 0);
    CHECK(found[1].find("includes itself") != std::string::npos);
  }
}

TEST_CASE("files that include each other without an end") {
  const SceneFolder folder;
  const auto name = [](int i) { return "f" + std::to_string(i) + ".xml"; };
  const int count = 100;
  for (int i = 0; i < count; ++i)
    folder.write(name(i), "<scene version=\"3.0.0\"><include filename=\"" + name(i + 1) + "\"/></scene>");
  folder.write(name(count), "<scene version=\"3.0.0\"/>");
  CHECK_THROWS_WITH(load_scene(folder.path(name(0))), Catch::Contains("files include each other in turn"));
  CHECK_NOTHROW(load_scene(folder.path(name(count - 60))));
}

TEST_CASE("a name is given twice") {
  const std::vector<std::string> found =
      problems(around("<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><point name=\"center\" x=\"0\" "
                      "y=\"0\" z=\"0\"/><float name=\"radius\" value=\"2\"/></shape>"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("\"radius\" of <shape type=\"sphere\"> is given twice") != std::string::npos);
}

TEST_CASE("names of Mitsuba 0.x") {
  CHECK(snake_case("toWorld") == "to_world");
  CHECK(snake_case("cropOffsetX") == "crop_offset_x");
  CHECK(snake_case("reflectance") == "reflectance");
  CHECK(snake_case("intIOR") == "int_ior");
  const LoadedScene loaded = load_text(
      "<scene version=\"0.6.0\"><default name=\"myFov\" value=\"30\"/><sensor type=\"perspective\"><string "
      "name=\"fovAxis\" "
      "value=\"larger\"/><float name=\"fov\" value=\"$myFov\"/><transform name=\"toWorld\"><lookAt origin=\"0 0 5\" "
      "target=\"0 0 0\" up=\"0 1 0\"/></transform><sampler type=\"ldsampler\"><integer name=\"sampleCount\" "
      "value=\"9\"/>"
      "</sampler></sensor><integrator type=\"direct\"><boolean name=\"hideEmitters\" value=\"true\"/></integrator>"
      "<shape type=\"sphere\"><bsdf type=\"diffuse\"><srgb name=\"reflectance\" "
      "value=\"#ff0000\"/></bsdf></shape></scene>");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.camera.fov_axis == FovAxis::larger);
  CHECK(loaded.scene.camera.fov_degrees == 30);
  CHECK(loaded.scene.camera.world_from_camera.translation() == Vec3{0, 0, 5});
  CHECK(loaded.scene.sampler.sample_count == 9);
  CHECK(loaded.scene.integrator.hide_emitters);
  CHECK(std::get<Diffuse>(loaded.scene.materials[1].bsdf).reflectance.color == Rgb{1, 0, 0});
  CHECK(problems("<scene version=\"2.1.0\"><sensor type=\"perspective\"><float name=\"nearClip\" value=\"1\"/></sensor>"
                 "</scene>") ==
        std::vector<std::string>{
            "1:51: warning: unknown parameter \"nearClip\" of <sensor type=\"perspective\"> (did you "
            "mean \"near_clip\"?); it is ignored"});
}

TEST_CASE("versions") {
  CHECK(problems("<scene><sensor type=\"perspective\"/></scene>") ==
        std::vector<std::string>{"1:1: warning: <scene> has no version; it is read as version=\"3.0.0\""});
  CHECK(problems("<scene version=\"x\"><sensor type=\"perspective\"/></scene>").at(0).rfind("1:1: error: version", 0) ==
        0);
}

TEST_CASE("a file of one object has a version, and the name that its <include> gives it") {
  const SceneFolder folder;
  folder.write("red.xml",
               "<bsdf version=\"3.0.0\" type=\"diffuse\"><include filename=\"board.xml\" "
               "name=\"reflectance\"/></bsdf>");
  folder.write("board.xml", "<texture version=\"3.0.0\" type=\"checkerboard\" name=\"other\"/>");
  const std::string main =
      folder.write("scene.xml", around("<shape type=\"sphere\"><include filename=\"red.xml\"/></shape>"));
  const LoadedScene loaded = load_scene(main, {{}, true});
  CHECK(loaded.warnings.empty());
  const Material& material = loaded.scene.materials.at(static_cast<std::size_t>(loaded.scene.shapes.at(0).material));
  CHECK(std::get<Diffuse>(material.bsdf).reflectance.texture == 0);
}

TEST_CASE("what <default>, <include> and <path> do not know they say") {
  const SceneFolder folder;
  folder.write("ball.xml", "<shape type=\"sphere\"/>");
  const std::string main = folder.write(
      "scene.xml", around("<default name=\"a\" value=\"1\" vlaue=\"2\"/><include filename=\"ball.xml\" nmae=\"x\"/>"));
  const std::vector<std::string> found = shortened(load_scene(main).warnings);
  REQUIRE(found.size() == 2);
  CHECK(found[0] == "2:1: warning: unknown attribute \"vlaue\" of <default> (did you mean \"value\"?); it is ignored");
  CHECK(found[1] == "2:40: warning: unknown attribute \"nmae\" of <include> (did you mean \"name\"?); it is ignored");
}

TEST_CASE("0.x has diffuseReflectance where it has no reflectance") {
  const auto red = [](const std::string& inside, const std::string& type) {
    const LoadedScene loaded =
        load_text("<scene version=\"0.6.0\"><sensor type=\"perspective\"/><shape type=\"sphere\"><bsdf type=\"" + type +
                  "\">" + inside + "</bsdf></shape></scene>");
    const auto& bsdf = loaded.scene.materials.back().bsdf;
    if (const auto* rough = std::get_if<RoughDiffuse>(&bsdf)) return rough->reflectance.color.r;
    return std::get<Diffuse>(bsdf).reflectance.color.r;
  };
  const std::string given = "<rgb name=\"diffuseReflectance\" value=\"0.25 0 0\"/>";
  CHECK(red(given, "diffuse") == 0.25);
  CHECK(red(given, "roughdiffuse") == 0.25);
  CHECK(red(given + "<rgb name=\"reflectance\" value=\"0.75 0 0\"/>", "diffuse") == 0.75);
}

TEST_CASE("0.x: a boundary of media without a bsdf is nothing else") {
  const auto opacity = [](const std::string& version, const std::string& inside) {
    const LoadedScene loaded =
        load_text("<scene version=\"" + version + "\"><sensor type=\"perspective\"/>" +
                  "<medium type=\"homogeneous\" id=\"fog\"/><shape type=\"sphere\">" + inside + "</shape></scene>");
    const auto material = static_cast<std::size_t>(loaded.scene.shapes.at(0).material);
    const std::optional<Reflectance>& share = loaded.scene.materials.at(material).opacity;
    return share ? share->color.r : 1;
  };
  const std::string medium = "<medium type=\"homogeneous\" name=\"interior\"/>", bsdf = "<bsdf type=\"diffuse\"/>";
  CHECK(opacity("0.6.0", medium) == 0);
  CHECK(opacity("0.6.0", "<ref name=\"exterior\" id=\"fog\"/>") == 0);
  CHECK(opacity("0.6.0", medium + bsdf) == 1);
  CHECK(opacity("0.6.0", medium + "<emitter type=\"area\"/>") == 1);
  CHECK(opacity("0.6.0", "") == 1);
  CHECK(opacity("3.0.0", medium) == 1);
}
