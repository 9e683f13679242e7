// SPDX-License-Identifier: MIT
// A scene's integrator aov: layers of an EXR under the scene's names, through checkpoints and parts too; nothing of
// them in other files.
#include <algorithm>
#include <catch2/catch.hpp>

#include "cli/program.h"
#include "cli/same_picture.h"
#include "image/image_io.h"

using namespace strahl_test;
using strahl::Image;

namespace {

/// A glowing sphere, a body without light behind it, `aovs` of their picture; none where it is empty.
std::string scene_with_aovs(const std::string& aovs, const std::string& inside = "emission") {
  const std::string integrator = "<integrator type=\"" + inside + "\"/>";
  const std::string around =
      "<integrator type=\"aov\"><string name=\"aovs\" value=\"" + aovs + "\"/>" + integrator + "</integrator>";
  return "<scene version=\"3.0.0\">\n" + (aovs.empty() ? integrator : around) + R"(
    <sensor type="perspective"><float name="fov" value="40"/>
      <transform name="to_world"><lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform>
      <film type="hdrfilm"><integer name="width" value="32"/><integer name="height" value="24"/></film>
      <sampler type="independent"><integer name="sample_count" value="8"/></sampler></sensor>
    <shape type="sphere"><emitter type="area"><rgb name="radiance" value="4, 2, 1"/></emitter></shape>
    <shape type="sphere"><point name="center" value="2, 1, -3"/>
      <bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.4, 0.6"/></bsdf></shape>
    </scene>)";
}

const std::string every_type =
    "dd.y:depth, nn:sh_normal, p:position, t:uv, al:albedo, gn:geo_normal, pi:prim_index, si:shape_index";

Outcome succeed_on_pocl(const Folder& folder, std::vector<std::string> arguments) {
  if (arguments.front() != "merge") arguments.insert(arguments.end(), {"-d", "pocl", "--brief", "--no-progress"});
  Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return outcome;
}

std::vector<float> values_of(const Image& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  INFO(name);
  REQUIRE(found != image.channels.end());
  std::vector<float> values;
  for (auto at = static_cast<std::size_t>(found - image.channels.begin()); at < image.data.size();
       at += image.channels.size())
    values.push_back(image.data[at]);
  return values;
}

}  // namespace

TEST_CASE("an EXR has the scene's AOVs under its names, with the values of --aov's, and the picture stays as it is") {
  const Folder folder;
  folder.file("scene.xml", scene_with_aovs(every_type));
  folder.file("plain.xml", scene_with_aovs(""));
  CHECK_FALSE(contains(succeed_on_pocl(folder, {"scene.xml", "-o", "own.exr"}).err, "AOVs"));
  const Image own = strahl::read_image(folder.path("own.exr"));
  CHECK(own.channels == std::vector<std::string>{"R",    "G",    "B",    "al.R", "al.G", "al.B", "dd.y.T",
                                                 "gn.X", "gn.Y", "gn.Z", "nn.X", "nn.Y", "nn.Z", "p.X",
                                                 "p.Y",  "p.Z",  "pi.I", "si.I", "t.U",  "t.V"});
  succeed_on_pocl(folder, {"plain.xml", "-o", "plain.exr"});
  const Image plain = strahl::read_image(folder.path("plain.exr"));
  CHECK(plain.channels.size() == 3);
  for (const char* name : {"R", "G", "B"}) CHECK(values_of(own, name) == values_of(plain, name));

  succeed_on_pocl(folder, {"scene.xml", "-o", "both.exr", "--aov",
                           "depth,normal,geo_normal,position,uv,albedo,primitive_id,shape_id"});
  const Image both = strahl::read_image(folder.path("both.exr"));
  CHECK(both.channels.size() == 37);
  for (const auto& [theirs, ours] : std::vector<std::pair<std::string, std::string>>{{"dd.y.T", "depth.Z"},
                                                                                     {"nn.X", "normal.X"},
                                                                                     {"nn.Z", "normal.Z"},
                                                                                     {"gn.Y", "geo_normal.Y"},
                                                                                     {"p.Y", "position.Y"},
                                                                                     {"t.U", "uv.U"},
                                                                                     {"t.V", "uv.V"},
                                                                                     {"al.R", "albedo.R"},
                                                                                     {"al.B", "albedo.B"},
                                                                                     {"pi.I", "primitive_id.I"},
                                                                                     {"si.I", "shape_id.I"}}) {
    INFO(theirs);
    CHECK(values_of(own, theirs) == values_of(both, ours));
    CHECK(values_of(both, theirs) == values_of(both, ours));
  }
  const std::vector<float> shapes = values_of(own, "si.I");
  for (const float id : {-1.0F, 0.0F, 1.0F}) CHECK(std::count(shapes.begin(), shapes.end(), id) > 0);
}

TEST_CASE("shapes of groups have numbers of their own, behind the scene's") {
  const Folder folder;
  std::string scene = scene_with_aovs("si:shape_index");
  const std::string end = "</scene>";
  const auto ball = [](const std::string& center) {
    return "<shape type=\"sphere\"><point name=\"center\" value=\"" + center +
           "\"/><float name=\"radius\" value=\".5\"/></shape>";
  };
  scene.replace(scene.rfind(end), end.size(),
                "<shape type=\"shapegroup\" id=\"a\">" + ball("-1.5, .6, 0") + ball("-1.5, -.6, 0") +
                    "</shape><shape type=\"shapegroup\" id=\"b\">" + ball("1.5, -.6, 0") +
                    "</shape><shape type=\"instance\"><ref id=\"b\"/></shape>"
                    "<shape type=\"instance\"><ref id=\"a\"/></shape></scene>");
  folder.file("scene.xml", scene);
  for (const bool is_generic : {false, true}) {
    std::vector<std::string> arguments{"scene.xml", "-o", "own.exr"};
    if (is_generic) arguments.emplace_back("--generic");
    succeed_on_pocl(folder, arguments);
    const std::vector<float> shapes = values_of(strahl::read_image(folder.path("own.exr")), "si.I");
    // Each ball of a group stands beside the two others.
    for (const float id : {-1.0F, 0.0F, 1.0F, 2.0F, 3.0F, 4.0F})
      CHECK(std::count(shapes.begin(), shapes.end(), id) > 0);
  }
}

TEST_CASE("a part behind sample 0 has no layers of first samples, which is said; merge has them of the other part") {
  const Folder folder;
  folder.file("scene.xml", scene_with_aovs("dd.y:depth"));
  const std::vector<std::string> options = {"scene.xml", "--aov", "shape_id,uv"};
  const auto part = [&](const std::string& samples, const std::string& name) {
    std::vector<std::string> all = options;
    all.insert(all.end(), {"--samples", samples, "--checkpoint", name + ".ckpt", "-o", name + ".exr"});
    return succeed_on_pocl(folder, all).err;
  };
  CHECK_FALSE(contains(part("0:3", "a"), "without"));
  CHECK(strahl::read_image(folder.path("a.exr")).channels.size() == 7);
  CHECK(
      contains(part("3:8", "b"),
               "strahl: warning: --samples 3:8: the picture is without uv, shape_id, dd.y, of sample 0 alone; `strahl "
               "merge` takes them from the part that has it"));
  CHECK(strahl::read_image(folder.path("b.exr")).channels == std::vector<std::string>{"R", "G", "B"});
  succeed_on_pocl(folder, {"merge", "b.ckpt", "a.ckpt", "-o", "sum.exr"});
  succeed_on_pocl(folder, {"scene.xml", "--aov", "shape_id,uv", "-o", "one.exr"});
  require_same_picture(folder, "one.exr", "sum.exr");
}

TEST_CASE("other files are without them, which is said once; they are not computed for them") {
  const Folder folder;
  folder.file("scene.xml", scene_with_aovs("dd.y:depth, nn:sh_normal"));
  for (const std::string name : {"out.png", "out.pfm"}) {
    const std::string said = succeed_on_pocl(folder, {"scene.xml", "-o", name, "--stats", "stats.json"}).err;
    CHECK(contains(said, name + ": without the scene's AOVs (dd.y, nn), which an .exr holds; --aov depth,normal writes "
                                "them as pictures"));
    CHECK(said.find("AOVs") == said.rfind("AOVs"));
    CHECK_FALSE(contains(read_text(folder.path("stats.json")), "\"AOV\""));
  }
  CHECK(folder.files() == std::vector<std::string>{"out.pfm", "out.png", "scene.xml", "stats.json"});
  succeed_on_pocl(folder, {"scene.xml", "-o", "out.exr", "--stats", "stats.json"});
  CHECK(contains(read_text(folder.path("stats.json")), "\"AOV\""));
  CHECK_FALSE(contains(succeed_on_pocl(folder, {"scene.xml", "-o", "out.png", "-q"}).err, "AOVs"));
  CHECK_FALSE(contains(succeed_on_pocl(folder, {"scene.xml", "--pixel", "16,12"}).err, "AOVs"));
}

TEST_CASE("parts and checkpoints keep the names, whatever file was written beside them") {
  const Folder folder;
  folder.file("scene.xml", scene_with_aovs("dd.y:depth, si:shape_index"));
  succeed_on_pocl(folder, {"scene.xml", "-o", "one.exr", "--aov", "uv"});
  succeed_on_pocl(folder, {"scene.xml", "--aov", "uv", "--samples", "0:3", "--checkpoint", "a.ckpt"});
  succeed_on_pocl(folder, {"scene.xml", "--aov", "uv", "--samples", "3:8", "--checkpoint", "b.ckpt"});
  succeed_on_pocl(folder, {"merge", "b.ckpt", "a.ckpt", "-o", "sum.exr"});
  require_same_picture(folder, "one.exr", "sum.exr");
  CHECK(strahl::read_image(folder.path("sum.exr")).channels ==
        std::vector<std::string>{"R", "G", "B", "dd.y.T", "si.I", "uv.U", "uv.V"});
  CHECK(contains(succeed_on_pocl(folder, {"merge", "b.ckpt", "a.ckpt", "-o", "sum.png"}).err,
                 "sum.png: without the scene's AOVs (dd.y, si)"));

  CHECK(contains(succeed_on_pocl(folder, {"scene.xml", "-o", "x.png", "--checkpoint", "c.ckpt"}).err,
                 "without the scene's"));
  succeed_on_pocl(folder, {"scene.xml", "-o", "again.exr", "--resume", "c.ckpt"});
  CHECK(values_of(strahl::read_image(folder.path("again.exr")), "dd.y.T") ==
        values_of(strahl::read_image(folder.path("one.exr")), "dd.y.T"));
  CHECK(folder.files() == std::vector<std::string>{"a.ckpt", "again.exr", "b.ckpt", "c.ckpt", "one.exr", "scene.xml",
                                                   "sum.exr", "sum.png", "sum.uv.png", "x.png"});
}

TEST_CASE("integrators that begin on lights leave them out, with a warning; one name is not two values") {
  const Folder folder;
  folder.file("scene.xml", scene_with_aovs("normal:position, n:sh_normal"));
  const auto says = [&](const std::vector<std::string>& more, int code) {
    std::vector<std::string> arguments{"scene.xml", "-o", "x.exr", "-d", "no-such-device"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.code == code);
    return outcome.err;
  };
  for (const char* name : {"ptracer", "bdpt"})
    CHECK(contains(says({"--integrator", name}, 4), "scene.xml:2:24: warning: the AOVs are left out: integrator " +
                                                        std::string(name) + " begins its paths on lights"));
  CHECK_FALSE(contains(says({}, 4), "warning"));
  CHECK(contains(says({"--aov", "normal"}, 2), "--aov normal and the scene's AOV \"normal\" (scene.xml:2:24) have"));
  says({"--aov", "position"}, 4);
  says({"--aov", "normal", "-o", "x.png"}, 4);
  // The same value under the same name is one layer.
  folder.file("scene.xml", scene_with_aovs("normal:sh_normal"));
  succeed_on_pocl(folder, {"scene.xml", "-o", "x.exr", "--aov", "normal"});
  CHECK(strahl::read_image(folder.path("x.exr")).channels.size() == 6);
}
