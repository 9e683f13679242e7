// SPDX-License-Identifier: MIT
// Geometry of every shape in the world frame, under to_world as Mitsuba does it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Shape shape(const std::string& type, const std::string& inside, const std::string& steps = "") {
  const std::string to_world = steps.empty() ? "" : "<transform name=\"to_world\">" + steps + "</transform>";
  return load_body("<shape type=\"" + type + "\">" + inside + to_world + "</shape>").scene.shapes.at(0);
}

const char* const mirror_x = "<scale x=\"-1\"/>";
const char* const box = "<point name=\"min\" value=\"-1 -2 -3\"/><point name=\"max\" value=\"1 2 5\"/>";
const char* const square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.25\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n";

void check_close(const Vec3& a, const Vec3& b) {
  INFO(a.x << ' ' << a.y << ' ' << a.z);
  CHECK(length(a - b) < 1e-12);
}

}  // namespace

TEST_CASE("sphere") {
  const Sphere s =
      std::get<Sphere>(shape("sphere", "<point name=\"center\" value=\"1 0 0\"/><float name=\"radius\" value=\".5\"/>",
                             "<scale value=\"2\"/><rotate z=\"1\" angle=\"90\"/><translate z=\"7\"/>")
                           .geometry);
  check_close(s.center, {0, 2, 7});
  CHECK(s.radius == 1);
  check_close(s.frame[0], {0, 1, 0});
  check_close(s.frame[2], {0, 0, 1});
  check_close(std::get<Sphere>(shape("sphere", "", "<scale z=\"-1\"/>").geometry).frame[2], {0, 0, -1});
  CHECK(shape("sphere", "", "<scale z=\"-1\"/>").flip_normals);
  CHECK_FALSE(shape("sphere", "<boolean name=\"flip_normals\" value=\"true\"/>", "<scale value=\"-2\"/>").flip_normals);
  CHECK_FALSE(shape("sphere", "", "<scale value=\"2\"/>").flip_normals);
  CHECK_NOTHROW(shape("sphere", "", "<matrix value=\"0.707107 -0.707107 0 0.707107 0.707107 0 0 0 1\"/>"));
}

/// Six decimals of a rotation times 0.05, as scenes have them: entries are off by 1e-5 of the scale.
TEST_CASE("round shapes of rounded matrices stay round, with a warning that says by how much they are off") {
  const std::string rounded =
      "<transform name=\"to_world\"><matrix value=\"0.035355 0.020412 0.028868 0 -0.035355 0.020412 0.028868 0 "
      "0 -0.040825 0.028868 0 0 0 0 1\"/>";
  for (const char* type : {"sphere", "cylinder"}) {
    INFO(type);
    const LoadedScene loaded =
        load_body("<shape type=\"" + std::string(type) + "\">" + rounded + "</transform></shape>");
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].message.find("e-05, as rounded numbers do; it stays round") != std::string::npos);
  }
  const Sphere s = std::get<Sphere>(
      load_body("<shape type=\"sphere\">" + rounded + "</transform></shape>").scene.shapes.at(0).geometry);
  CHECK(s.radius == Approx(0.05).epsilon(1e-4));
  check_close(cross(s.frame[0], s.frame[1]), s.frame[2]);
  CHECK_NOTHROW(shape("sphere", "", "<scale x=\"1.0009\"/>"));
  CHECK(std::holds_alternative<Disk>(shape("disk", "", "<scale x=\"1.0009\"/>").geometry));
  CHECK(std::holds_alternative<Mesh>(shape("disk", "", "<scale x=\"1.0011\"/>").geometry));
  for (const char* type : {"sphere", "cylinder"}) CHECK_THROWS_AS(shape(type, "", "<scale x=\"1.0011\"/>"), SceneError);
}

TEST_CASE("rectangle and disk keep facing their +z when mirrored") {
  const Rectangle r = std::get<Rectangle>(shape("rectangle", "", "<translate z=\"3\"/>").geometry);
  CHECK(r.corner == Vec3{-1, -1, 3});
  CHECK(r.edge_u == Vec3{2, 0, 0});
  CHECK(r.edge_v == Vec3{0, 2, 0});
  CHECK_FALSE(shape("rectangle", "").flip_normals);
  CHECK(shape("rectangle", "", mirror_x).flip_normals);
  CHECK(shape("disk", "", mirror_x).flip_normals);
  CHECK_FALSE(shape("disk", "<boolean name=\"flip_normals\" value=\"true\"/>", mirror_x).flip_normals);
  const Disk d =
      std::get<Disk>(shape("disk", "", "<scale x=\"3\" y=\"3\" z=\"9\"/><rotate x=\"1\" angle=\"90\"/>").geometry);
  CHECK(d.axis_u == Vec3{3, 0, 0});
  check_close(d.axis_v, {0, 0, 3});
}

TEST_CASE("cube") {
  const Shape s = shape("cube", "", "<scale x=\"2\"/>");
  CHECK(std::get<Cube>(s.geometry).corner == Vec3{-2, -1, -1});
  CHECK(std::get<Cube>(s.geometry).edge[0] == Vec3{4, 0, 0});
  CHECK(primitive_count(s) == 6);
}

TEST_CASE("cylinder") {
  const Cylinder plain = std::get<Cylinder>(shape("cylinder", "").geometry);
  CHECK(plain.p0 == Vec3{0, 0, 0});
  CHECK(plain.p1 == Vec3{0, 0, 1});
  CHECK(plain.radius == 1);
  CHECK(plain.reference == Vec3{1, 0, 0});
  const Cylinder c =
      std::get<Cylinder>(shape("cylinder", "<point name=\"p1\" value=\"0 0 2\"/><float name=\"radius\" value=\".5\"/>",
                               "<scale x=\"2\" y=\"2\" z=\"3\"/><rotate x=\"1\" angle=\"-90\"/>")
                             .geometry);
  check_close(c.p1, {0, 6, 0});
  CHECK(c.radius == 1);
}

/// Each end is rounded where it is: the axis between them is not quite as long nor quite where to_world points.
TEST_CASE("a turned cylinder may be small beside its distance from the origin") {
  const std::string turn = "<rotate y=\"1\" angle=\"20\"/>";
  for (const char* far_off : {"x=\"500000\" z=\"100\"", "x=\"-3e9\" y=\"7e8\"", "x=\"4e15\" z=\"1e15\""}) {
    INFO(far_off);
    const Cylinder c = std::get<Cylinder>(shape("cylinder", "", turn + "<translate " + far_off + "/>").geometry);
    CHECK(std::abs(dot(c.reference, normalized(c.p1 - c.p0))) < 1e-15);
    CHECK(length(c.reference) == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("what Mitsuba's shapes take and no picture shows is accepted") {
  const std::string weight = "<float name=\"silhouette_sampling_weight\" value=\"0.5\"/>";
  for (const char* type : {"sphere", "rectangle", "cube", "disk", "cylinder"})
    CHECK(load_body("<shape type=\"" + std::string(type) + "\">" + weight + "</shape>").warnings.empty());
  for (const char* type : {"rectangle", "cube"})
    CHECK(load_body("<shape type=\"" + std::string(type) + "\"><boolean name=\"face_normals\" value=\"true\"/></shape>")
              .warnings.empty());
  const std::string placed = "<shape type=\"shapegroup\" id=\"g\">" + weight + "<shape type=\"sphere\"/></shape>" +
                             "<shape type=\"instance\">" + weight + "<ref id=\"g\"/></shape>";
  CHECK(load_body(placed).warnings.empty());
}

TEST_CASE("plane in its three forms") {
  const Plane a = std::get<Plane>(
      shape("plane", "<point name=\"point\" value=\"1 2 3\"/><vector name=\"normal\" value=\"0 5 0\"/>").geometry);
  CHECK(a.point == Vec3{1, 2, 3});
  CHECK(a.normal == Vec3{0, 5, 0});
  check_close(cross(a.u, a.v), {0, 1, 0});
  const Plane b = std::get<Plane>(
      shape("plane", "<vector name=\"normal\" value=\"1 2 2\"/><float name=\"d\" value=\"6\"/>").geometry);
  CHECK(dot(b.normal, b.point) == Approx(6).epsilon(1e-14));
  const Plane c = std::get<Plane>(shape("plane",
                                        "<point name=\"point\" value=\"1 1 1\"/><vector name=\"u\" value=\"2 0 0\"/>"
                                        "<vector name=\"v\" value=\"1 0 -1\"/>")
                                      .geometry);
  CHECK(c.u == Vec3{2, 0, 0});
  CHECK(c.normal == Vec3{0, 2, 0});
  const Plane t = std::get<Plane>(
      shape("plane", "<vector name=\"normal\" value=\"1 1 0\"/>", "<scale x=\"2\"/><translate y=\"1\"/>").geometry);
  check_close(t.normal, {0.5, 1, 0});
  CHECK(t.point == Vec3{0, 1, 0});
}

TEST_CASE("box and triangle") {
  const Box b = std::get<Box>(shape("box", box, "<rotate x=\"1\" angle=\"90\"/><translate y=\"10\"/>").geometry);
  CHECK(b.min == Vec3{-1, 5, -2});
  CHECK(b.max == Vec3{1, 13, 2});
  CHECK_THROWS_AS(shape("box", box, "<rotate x=\"1\" angle=\"45\"/>"), SceneError);
  const Triangle t =
      std::get<Triangle>(shape("triangle",
                               "<point name=\"p0\" value=\"0\"/><point name=\"p1\" value=\"1 0 0\"/><point "
                               "name=\"p2\" value=\"0 1 0\"/>",
                               mirror_x)
                             .geometry);
  CHECK(t.p1 == Vec3{-1, 0, 0});
}

TEST_CASE("bounds") {
  const Scene scene =
      load_body(
          "<shape type=\"disk\"><transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/></transform></shape>"
          "<shape type=\"cylinder\"/><shape type=\"plane\"/>")
          .scene;
  const std::optional<Box> b = bounds(scene);
  REQUIRE(b);
  check_close(b->min, {-1, -1, -1});
  check_close(b->max, {1, 1, 1});
  CHECK_FALSE(bounds(load_body("<shape type=\"plane\"/>").scene));
}

/// Two squares that meet at a right angle, one of them of two triangles and with twice the sides: at the shared edge
/// each counts by its angle, not by its triangles or its size.
TEST_CASE("a mesh without normals is shaded smoothly, unless it says otherwise") {
  const SceneFolder folder;
  folder.write("fold.ply",
               "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0\n0 1 0\n2 1 0\n2 0 0\n0 1 1\n0 0 1\n3 0 3 2\n3 0 2 1\n4 0 1 4 5\n");
  const std::string file = "<shape type=\"ply\"><string name=\"filename\" value=\"fold.ply\"/>";
  const std::string flat = "<boolean name=\"face_normals\" value=\"true\"/></shape>";
  const std::string mirrored = "<transform name=\"to_world\"><scale x=\"-1\"/><scale value=\"7\"/></transform></shape>";
  const Scene scene =
      load_scene(folder.write("scene.xml", around(file + "</shape>" + file + flat + file + mirrored))).scene;
  const auto mesh = [&](std::size_t i) { return std::get<Mesh>(scene.shapes.at(i).geometry); };
  const auto normal_at = [&](std::size_t i, const Vec3& position) {
    const Mesh& of = std::get<Mesh>(scene.shapes.at(i).geometry);
    const auto found = std::find(of.positions.begin(), of.positions.end(), position);
    return of.normals.at(static_cast<std::size_t>(found - of.positions.begin()));
  };
  // 90 degrees of each: at (0, 0, 0) the sum of both triangles' angles.
  const double half = std::sqrt(0.5);
  check_close(normal_at(0, {0, 0, 0}), {half, 0, half});
  check_close(normal_at(0, {0, 1, 0}), {half, 0, half});
  check_close(normal_at(0, {2, 1, 0}), {0, 0, 1});
  check_close(normal_at(0, {0, 1, 1}), {1, 0, 0});
  CHECK(mesh(1).normals.empty());
  // As the triangles turn with the map.
  check_close(normal_at(2, {0, 0, 0}), {half, 0, -half});
  const Scene bare = load_scene(folder.path("fold.ply")).scene;
  CHECK(std::get<Mesh>(bare.shapes.at(0).geometry).normals.empty());
}

/// Two triangles with normals in the file that point to +z: the second one's winding says -z.
TEST_CASE("meshes that shine, and glass with a priority, face where the vertex normals of their files point") {
  const SceneFolder folder;
  folder.write("turned.ply",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\n"
               "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n3 0 3 2\n");
  const std::string file = "<shape type=\"ply\"><string name=\"filename\" value=\"turned.ply\"/>";
  const std::string mirrored = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
  const std::string flat = "<boolean name=\"face_normals\" value=\"true\"/>", end = "<emitter type=\"area\"/></shape>";
  const std::string priority = "<integer name=\"priority\" value=\"1\"/>";
  const std::string glass = "<bsdf type=\"dielectric\"/></shape>",
                    fog = "<medium name=\"interior\" type=\"homogeneous\"/><bsdf type=\"null\"/></shape>";
  const Scene scene =
      load_scene(folder.write("scene.xml", around(file + end + file + mirrored + end + file + flat + end + file +
                                                  "</shape>" + file + mirrored + priority + glass + file + mirrored +
                                                  glass + file + priority + fog + file + flat + fog)))
          .scene;
  const auto facing = [&](std::size_t i) {
    std::vector<double> all;
    const Mesh& mesh = std::get<Mesh>(scene.shapes.at(i).geometry);
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto at = [&](int vertex) { return mesh.positions.at(static_cast<std::size_t>(vertex)); };
      all.push_back(cross(at(b) - at(a), at(c) - at(a)).z);
    }
    return all;
  };
  CHECK(facing(0) == std::vector<double>{1, 1});
  CHECK(facing(1) == std::vector<double>{1, 1});
  CHECK(facing(2) == std::vector<double>{1, -1});
  CHECK(facing(3) == std::vector<double>{1, -1});
  CHECK(facing(4) == std::vector<double>{1, 1});
  // What does not go by the vertex normals, or is nothing but a medium, stays as in Mitsuba.
  CHECK(facing(5) == std::vector<double>{-1, 1});
  CHECK(facing(6) == std::vector<double>{1, -1});
  CHECK(facing(7) == std::vector<double>{1, -1});
  for (const Shape& shape : scene.shapes) CHECK_FALSE(shape.flip_normals);
}

/// All the corners say the same of both triangles, and by their order u and v run.
TEST_CASE("where all triangles face away from their vertex normals they are turned with their corners as they are") {
  const SceneFolder folder;
  folder.write("square.obj", square_obj);
  const std::string file = "<shape type=\"obj\"><string name=\"filename\" value=\"square.obj\"/>";
  const std::string mirrored = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
  const std::string flipped = "<boolean name=\"flip_normals\" value=\"true\"/>";
  const std::string end = "<emitter type=\"area\"/></shape>";
  const Scene scene = load_scene(folder.write("scene.xml", around(file + end + file + mirrored + end + file + mirrored +
                                                                  flipped + end + file + mirrored + "</shape>")))
                          .scene;
  const std::vector<double> sides{1, -1, -1, 1};
  const std::vector<bool> are_flipped{false, true, false, false};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    INFO("shape " << i);
    const Shape& shape = scene.shapes.at(i);
    const Mesh& mesh = std::get<Mesh>(shape.geometry);
    CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
    for (const Vec3& normal : mesh.normals) check_close(normal, {0, 0, sides[i]});
    CHECK(shape.flip_normals == are_flipped[i]);
  }
}

TEST_CASE("meshes") {
  const SceneFolder folder;
  folder.write("m/square.obj", std::string("mtllib a.mtl\nusemtl red\n") + square_obj);
  folder.write("m/a.mtl", "newmtl red\nKd 0.8 0.1 0.1\nKe 1 2 3\n");
  const std::string file = "<shape type=\"obj\"><string name=\"filename\" value=\"m/square.obj\"/>";
  const std::string stretch =
      "<transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/><scale value=\"2\"/></transform>";
  const LoadedScene loaded =
      load_scene(folder.write("scene.xml", around(file + stretch + "</shape>" + file +
                                                  "<bsdf type=\"diffuse\"/><boolean name=\"face_normals\" "
                                                  "value=\"true\"/></shape>" +
                                                  file + "<emitter type=\"area\"/></shape>" + file +
                                                  "<bsdf type=\"diffuse\"/><emitter type=\"area\"/></shape>")));
  CHECK(loaded.warnings.empty());
  const auto mesh = [&](std::size_t i) { return std::get<Mesh>(loaded.scene.shapes.at(i).geometry); };
  CHECK(primitive_count(loaded.scene.shapes[0]) == 2);
  check_close(mesh(0).normals.at(0), {0, -1, 0});
  CHECK(mesh(0).uvs.at(0).y == 0.75);
  REQUIRE(mesh(0).parts.size() == 1);
  CHECK(mesh(0).parts[0].radiance == Rgb{1, 2, 3});
  const Material& red = loaded.scene.materials.at(static_cast<std::size_t>(mesh(0).parts[0].material));
  CHECK(std::get<Diffuse>(red.bsdf).reflectance.color == Rgb{.8, .1, .1});
  CHECK(mesh(1).normals.empty());
  CHECK(mesh(1).parts.empty());  // Neither the MTL's colours nor its light.
  CHECK(mesh(2).parts.at(0).radiance == Rgb{1, 1, 1});
  CHECK(mesh(3).parts.empty());
  const LoadedScene bare = load_scene(folder.path("m/square.obj"));
  CHECK(bare.scene.integrator.name == "normals");
  CHECK(bare.scene.name == "square");
  CHECK(bare.warnings.empty());
  CHECK(bare.scene.camera.world_from_camera.vector({0, 0, 1}) == Vec3{0, 0, -1});
}

TEST_CASE("an elliptic disk has the texture coordinates of a disk") {
  const LoadedScene loaded =
      load_body("<shape type=\"disk\"><transform name=\"to_world\"><scale x=\"3\"/></transform></shape>");
  const auto& mesh = std::get<Mesh>(loaded.scene.shapes.at(0).geometry);
  REQUIRE(mesh.uvs.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    CHECK(mesh.uvs[i].x == Approx(std::hypot(p.x / 3, p.y)).margin(1e-12));
    if (mesh.uvs[i].x == 0) continue;
    CHECK(std::cos(2 * std::acos(-1) * mesh.uvs[i].y) == Approx(p.x / 3 / mesh.uvs[i].x).margin(1e-12));
    CHECK(std::sin(2 * std::acos(-1) * mesh.uvs[i].y) == Approx(p.y / mesh.uvs[i].x).margin(1e-12));
  }
}

/// Along v a step of the triangle's is 1 / 256, over a length that the ring has.
TEST_CASE("on an elliptic disk with a relief v grows along the rings as it does around a disk") {
  const std::string plain = "<bsdf type=\"diffuse\"/>",
                    bumpy = "<bsdf type=\"bumpmap\"><texture type=\"checkerboard\"/>" + plain + "</bsdf>";
  for (const std::string& bsdf : {bumpy, "<bsdf type=\"twosided\">" + plain + bumpy + "</bsdf>"}) {
    CAPTURE(bsdf);
    const LoadedScene loaded =
        load_body("<shape type=\"disk\">" + bsdf + "<transform name=\"to_world\"><scale x=\"3\"/></transform></shape>");
    const auto& mesh = std::get<Mesh>(loaded.scene.shapes.at(0).geometry);
    double area = 0;
    for (const std::array<int, 3>& triangle : mesh.triangles) {
      std::array<Vec3, 3> at;
      double least = 1e9, most = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = mesh.positions.at(static_cast<std::size_t>(triangle.at(i)));
        at.at(i) = {p.x / 3, p.y, 0};
        least = std::min(least, length(at.at(i))), most = std::max(most, length(at.at(i)));
      }
      const Vec3 across = cross(at[1] - at[0], at[2] - at[0]);
      CHECK(across.z > 0);
      area += 1.5 * across.z;
      if (most < 1.0 / 60) continue;
      CHECK(least > 0.83 * most);
    }
    CHECK(area == Approx(3 * std::acos(-1)).epsilon(1e-12));
  }
}
