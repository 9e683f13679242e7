// SPDX-License-Identifier: MIT
// Generated scenes as files: strahl reads its own back exactly; other programs' hold what they should. 1 s.
#include <catch2/catch.hpp>
#include <filesystem>

#include "bench/scene_files.h"
#include "scene/loader.h"
#include "study/generated/scenes.h"

namespace strahl::test {
namespace {

using namespace strahl::bench;

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "strahl-test-scene-files";
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++n;
  return n;
}

/// Reading numbers the vertices anew.
std::vector<Vec3> corners(const Mesh& mesh) {
  std::vector<Vec3> all;
  for (const auto& triangle : mesh.triangles)
    for (const int i : triangle) all.push_back(mesh.positions[static_cast<std::size_t>(i)]);
  return all;
}

TEST_CASE("what is written is read back") {
  const Folder folder;
  for (const std::string name : {"sphereflake-1", "terrain-200", "lattice-2", "ten"}) {
    INFO(name);
    const Scene scene = generated_scene(name);
    const std::string path = (folder.path / (name + ".xml")).string();
    write_scene(scene, path);
    const LoadedScene loaded = load_scene(path, {{}, true, {}});
    CHECK(loaded.warnings.empty());
    REQUIRE(loaded.scene.shapes.size() == scene.shapes.size());
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
      const Geometry &ours = scene.shapes[i].geometry, &read = loaded.scene.shapes[i].geometry;
      REQUIRE(ours.index() == read.index());
      if (const auto* sphere = std::get_if<Sphere>(&ours)) {
        CHECK(std::get<Sphere>(read).center == sphere->center);
        CHECK(std::get<Sphere>(read).radius == sphere->radius);
      } else if (const auto* box = std::get_if<Box>(&ours)) {
        CHECK(std::get<Box>(read).min == box->min);
        CHECK(std::get<Box>(read).max == box->max);
      } else if (const auto* mesh = std::get_if<Mesh>(&ours)) {
        CHECK((corners(std::get<Mesh>(read)) == corners(*mesh)));
      } else if (const auto* square = std::get_if<Rectangle>(&ours)) {
        CHECK(std::get<Rectangle>(read).corner == square->corner);
        CHECK(std::get<Rectangle>(read).edge_u == square->edge_u);
      } else {
        CHECK(std::get<Plane>(read).normal == std::get<Plane>(ours).normal);
      }
    }
    CHECK(loaded.scene.film.width == 1024);
    CHECK(std::get<PointLight>(loaded.scene.lights.at(0).emitter).position ==
          std::get<PointLight>(scene.lights.at(0).emitter).position);
    CHECK(length(loaded.scene.camera.world_from_camera.column(2) - scene.camera.world_from_camera.column(2)) < 0x1p-48);
  }
}

TEST_CASE("spheres in a file of their own are the same spheres") {
  const Folder folder;
  const Scene scene = sphereflake(2);
  const std::string path = (folder.path / "cloud.xml").string();
  write_scene_with_cloud(scene, path);
  const LoadedScene loaded = load_scene(path, {{}, true, {}});
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.shapes.size() == 2);
  CHECK(loaded.scene.shapes[1].material == loaded.scene.shapes[0].material);
  const auto& cloud = std::get<SphereCloud>(loaded.scene.shapes[1].geometry);
  REQUIRE(cloud.spheres.size() + 1 == scene.shapes.size());
  for (std::size_t i = 1; i < scene.shapes.size(); ++i) {
    const auto& ours = std::get<Sphere>(scene.shapes[i].geometry);
    CHECK(cloud.spheres[i - 1].center == ours.center);
    CHECK(cloud.spheres[i - 1].radius == ours.radius);
    CHECK(cloud.frame == ours.frame);
  }
}

TEST_CASE("other programs get as many shapes") {
  const Scene flake = sphereflake(2), mountains = terrain(200);
  CHECK(count(povray_text(flake), "sphere{<") == 91);
  CHECK(count(povray_text(flake), "triangle{<") == 2);
  CHECK(count(tachyon_text(flake), "SPHERE CENTER") == 91);
  CHECK(count(povray_text(mountains), "face_indices{200,") == 1);
  CHECK(count(tachyon_text(mountains), "TRI V0") == 200);
}

TEST_CASE("what no writer knows is refused") {
  Scene scene = ten_spheres();
  CHECK_THROWS_WITH(write_scene(scene, "scene.blend"), Catch::Contains(".pov"));
  scene.shapes[0].geometry = Disk{};
  CHECK_THROWS_AS(povray_text(scene), Error);
  CHECK_THROWS_AS(tachyon_text(scene), Error);
  CHECK_THROWS_AS(xml_text(scene, ""), Error);
  scene.camera.projection = Projection::orthographic;
  CHECK_THROWS_WITH(xml_text(scene, ""), Catch::Contains("perspective"));
}

}  // namespace
}  // namespace strahl::test
