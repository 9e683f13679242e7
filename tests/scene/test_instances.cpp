// SPDX-License-Identifier: MIT
// Groups of shapes and the instances that place them: read, refused where they make no sense, bounded, moved.
#include <catch2/catch.hpp>
#include <limits>

#include "program/features.h"
#include "scene/model/build.h"
#include "scene/one_problem.h"
#include "scene/scene_text.h"
#include "study/transformed.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::string pair_group =
    "<shape type=\"shapegroup\" id=\"pair\">"
    "<shape type=\"sphere\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"1 0 0\"/></bsdf></shape>"
    "<shape type=\"cube\"><transform name=\"to_world\"><translate x=\"4\"/></transform></shape></shape>\n";

std::string placed(const std::string& steps, const std::string& group = "<ref id=\"pair\"/>") {
  return "<shape type=\"instance\">" + group + "<transform name=\"to_world\">" + steps + "</transform></shape>\n";
}

std::vector<std::string> problems_of(const std::string& body) { return problems(around(body)); }

Scene scene_with_instance(const Transform& transform = {}) {
  Scene scene;
  Group group;
  group.shapes.emplace_back().geometry = Sphere{};
  add_instance(scene, add(scene, group), transform);
  return scene;
}

}  // namespace

TEST_CASE("instances keep the order of the file; groups are read once and shapes count without them") {
  const Scene scene = load_body("<shape type=\"disk\"/>\n" + placed("<translate z=\"2\"/>") + pair_group +
                                placed("<scale value=\"3\"/>") + "<shape type=\"rectangle\"/>")
                          .scene;
  REQUIRE(scene.shapes.size() == 2);
  CHECK(std::holds_alternative<Disk>(scene.shapes[0].geometry));
  CHECK(std::holds_alternative<Rectangle>(scene.shapes[1].geometry));
  REQUIRE(scene.groups.size() == 1);
  CHECK(scene.groups[0].id == "pair");
  REQUIRE(scene.groups[0].shapes.size() == 2);
  CHECK(scene.groups[0].shapes[0].material == 1);
  CHECK(std::get<Cube>(scene.groups[0].shapes[1].geometry).corner == Vec3{3, -1, -1});
  REQUIRE(scene.instances.size() == 2);
  CHECK(scene.instances[0].group == 0);
  CHECK(scene.instances[0].world_from_group.translation() == Vec3{0, 0, 2});
  CHECK(scene.instances[1].world_from_group.column(1) == Vec3{0, 3, 0});
  CHECK(scene.instances[1].where.line == 5);
}

TEST_CASE("a group may stand inside its only instance, and one may be placed nowhere") {
  const Scene scene =
      load_body(pair_group + placed("", "<shape type=\"shapegroup\"><shape type=\"sphere\"/></shape>")).scene;
  REQUIRE(scene.groups.size() == 2);
  REQUIRE(scene.instances.size() == 1);
  CHECK(scene.instances[0].group == 1);
}

TEST_CASE("what makes no sense is refused at its place") {
  CHECK(problems_of(pair_group + placed("", "<ref id=\"pear\"/>")) ==
        std::vector<std::string>{"3:1: error: <shape type=\"instance\"> needs one <shape type=\"shapegroup\">, or a "
                                 "<ref> to one; it has 0",
                                 "3:24: error: nothing has the id \"pear\" (did you mean \"pair\"?)"});
  CHECK(problems_of(pair_group + placed("", "<ref id=\"pair\"/><ref id=\"pair\"/>")) ==
        std::vector<std::string>{"3:1: error: <shape type=\"instance\"> needs one <shape type=\"shapegroup\">, or a "
                                 "<ref> to one; it has 2"});
  CHECK(problems_of("<shape type=\"sphere\" id=\"ball\"/>\n" + placed("", "<ref id=\"ball\"/>")) ==
        std::vector<std::string>{"3:1: error: <shape type=\"instance\"> places a <shape type=\"shapegroup\">, not a "
                                 "<shape type=\"sphere\">"});
  CHECK(problems_of("<shape type=\"shapegroup\" id=\"none\"/>\n") ==
        std::vector<std::string>{"2:1: error: <shape type=\"shapegroup\"> holds no <shape>"});
  const std::string nested =
      "groups cannot be nested: a shapegroup holds neither shapegroups nor instances; give it "
      "the shapes themselves";
  CHECK(problems_of(pair_group + "<shape type=\"shapegroup\"><shape type=\"sphere\"/>\n" + placed("") + "</shape>") ==
        std::vector<std::string>{"4:1: error: " + nested});
  CHECK(problems_of("<shape type=\"shapegroup\"><shape type=\"sphere\"/>\n" + pair_group + "</shape>") ==
        std::vector<std::string>{"3:1: error: " + nested});
  CHECK(problems_of(pair_group + placed("<matrix value=\"1 0 0 2 0 0 0 0 1\"/>")).size() == 1);
}

TEST_CASE("emitters and planes stay outside groups") {
  CHECK(problems_of("<shape type=\"shapegroup\">\n<shape type=\"sphere\">\n<emitter type=\"area\"/></shape></shape>") ==
        std::vector<std::string>{"4:1: error: an emitter cannot be part of a shapegroup; place the shape outside"});
  CHECK(problems_of("<shape type=\"shapegroup\">\n<shape type=\"plane\"/></shape>") ==
        std::vector<std::string>{"3:1: error: an infinite plane cannot be part of a shapegroup; use a rectangle, or "
                                 "place it outside"});
  const SceneFolder folder;
  folder.write("glow.mtl", "newmtl a\nKe 1 1 1\n");
  folder.write("glow.obj", "mtllib glow.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const auto in_group = [&](const std::string& inside) {
    return load_scene(folder.write(
        "scene.xml",
        around("<shape type=\"shapegroup\"><shape type=\"obj\"><string name=\"filename\" value=\"glow.obj\"/>" +
               inside + "</shape></shape>")));
  };
  const LoadedScene dark = in_group("");
  CHECK(shortened(dark.warnings) ==
        std::vector<std::string>{"2:26: warning: the light of the file's materials (Ke) is left out, as nothing in a "
                                 "shapegroup shines; place the shape outside to have it"});
  CHECK_FALSE(std::get<Mesh>(dark.scene.groups.at(0).shapes.at(0).geometry).parts.at(0).radiance);
  CHECK(in_group("<bsdf type=\"diffuse\"/>").warnings.empty());
}

TEST_CASE("parameters that neither has are named") {
  CHECK(problems_of(pair_group + "<shape type=\"instance\"><ref id=\"pair\"/>\n<bsdf type=\"diffuse\"/></shape>") ==
        std::vector<std::string>{"4:1: warning: <shape type=\"instance\"> has no use for a <bsdf>; it is ignored"});
  CHECK(problems_of("<shape type=\"instanse\"/>").at(0).find("did you mean \"instance\"") != std::string::npos);
}

TEST_CASE("instances built by hand are validated") {
  CHECK(validate(scene_with_instance()).empty());
  Scene scene = scene_with_instance();
  scene.instances[0].group = 1;
  check_one_problem(scene, "group 1 does not exist");
  scene = scene_with_instance();
  scene.instances[0].group = -1;
  check_one_problem(scene, "group -1 does not exist");
  scene = scene_with_instance();
  scene.instances[0].world_from_group.m[1] = scene.instances[0].world_from_group.m[0];
  check_one_problem(scene, "singular");
  scene = scene_with_instance();
  scene.instances[0].world_from_group.m[0][3] = std::numeric_limits<double>::infinity();
  check_one_problem(scene, "finite");
  scene = scene_with_instance();
  scene.groups[0].shapes.clear();
  check_one_problem(scene, "no shapes");
  scene = scene_with_instance();
  scene.groups[0].shapes[0].material = 7;
  check_one_problem(scene, "material 7");
  scene = scene_with_instance();
  scene.groups[0].shapes[0].geometry = Sphere{{}, -1};
  check_one_problem(scene, "radius");
}

TEST_CASE("bounds are those of the instances, not of the groups") {
  const Scene scene = load_body(pair_group + placed("<scale value=\"2\"/><translate y=\"10\"/>") +
                                placed("<rotate z=\"1\" angle=\"90\"/>"))
                          .scene;
  const std::optional<Box> group = bounds(scene.groups.at(0));
  REQUIRE(group);
  CHECK(group->min == Vec3{-1, -1, -1});
  CHECK(group->max == Vec3{5, 1, 1});
  const std::optional<Box> box = bounds(scene);
  REQUIRE(box);
  CHECK(box->min == Vec3{-2, -1, -2});
  CHECK(box->max == Vec3{10, 12, 2});
  CHECK_FALSE(bounds(load_body(pair_group).scene));
}

TEST_CASE("a scene moved, scaled or mirrored takes its instances along") {
  Transform turned;
  turned.m = {{{0, -1, 0, 3}, {1, 0, 0, 4}, {0, 0, 1, 5}}};
  const Scene scene = scene_with_instance(turned);
  const Vec3 before = turned.point({0.25, 0.5, 0.75});
  const auto after = [](const Scene& s) { return s.instances.at(0).world_from_group.point({0.25, 0.5, 0.75}); };
  CHECK(after(scaled(scene, 8)) == 8 * before);
  CHECK(after(translated(scene, {1, 2, 3})) == before + Vec3{1, 2, 3});
  CHECK(after(mirrored(scene)) == Vec3{-before.x, before.y, before.z});
}

TEST_CASE("shapes of groups call for their effects") {
  const Scene scene = load_body(pair_group + placed("")).scene;
  const Features features = features_of(scene, {});
  CHECK(features.has("shapes", "sphere"));
  CHECK(features.has("shapes", "parallelogram"));
  CHECK_FALSE(features.has("shapes", "disk"));
}
