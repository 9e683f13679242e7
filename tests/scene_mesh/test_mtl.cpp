// SPDX-License-Identifier: MIT
// Materials of OBJ files: usemtl, mtllib in all its spellings, the values that are read.
#include <fmt/format.h>

#include "scene/meshes/material_warnings.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::TempFolder;
using test::text_of;

const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_CASE("triangles know their material; materials come in the order of use, each once") {
  const TempFolder folder;
  folder.write("m.mtl",
               "newmtl lamp\n\tKd 0.1 0.2 0.3\n Ke 5 6 7\nnewmtl grey\nKd 0.25\nKe 0 0 0\nKa 1 1 1\nmap_Ks x\n\n"
               "newmtl two words\nKd 1 0 0\nnewmtl lamp\nKd 0.9 0.9 0.9\n");
  const MeshFile file = read_mesh(folder.write("a.obj", "usemtl grey\nmtllib m.mtl\n" + obj_square +
                                                            "f 1 2 3\nusemtl  lamp \nf 1 2 3 4\nusemtl grey\nf 1 3 4\n"
                                                            "usemtl two words\nf 1 2 3\nusemtl unused\n"));
  REQUIRE(file.materials.size() == 3);
  CHECK(file.mesh.part_of_triangle == std::vector<int>{0, 1, 1, 0, 2});
  CHECK(file.materials[0].name == "grey");
  CHECK(file.materials[0].reflectance == Rgb{0.25, 0.25, 0.25});
  CHECK_FALSE(file.materials[0].radiance);
  CHECK(file.materials[1].reflectance == Rgb{0.1, 0.2, 0.3});
  CHECK(file.materials[1].radiance == Rgb{5, 6, 7});
  CHECK(file.materials[2].name == "two words");
  CHECK(file.materials[2].reflectance == Rgb{1, 0, 0});
  CHECK(file.warnings.empty());
}

TEST_CASE("values of highlights, mirrors and glass") {
  const TempFolder folder;
  folder.write("m.mtl", "newmtl a\nKs 0.1 0.2 0.3\nNs 96\nNi 1.33\nTf 0.5\nillum 7\nd 0.25\nmap_d -clamp on a.png\n");
  const MeshFile file = read_mesh(folder.write("a.obj", "mtllib m.mtl\n" + obj_square + "usemtl a\nf 1 2 3\n"));
  const MeshMaterial& a = file.materials.at(0);
  CHECK(a.specular == Rgb{0.1, 0.2, 0.3});
  CHECK(a.exponent == 96);
  CHECK(a.index == 1.33);
  CHECK(a.filter == Rgb{0.5, 0.5, 0.5});
  CHECK(a.illumination == 7);
  CHECK(a.opacity == 0.25);
  REQUIRE(a.opacity_map);
  CHECK(a.opacity_map->is_clamped);
  folder.write("m.mtl", "newmtl a\nNi\nNs -4\nillum many\nd 3\n");
  CHECK(text_of(material_warnings(read_mesh(folder.path() + "/a.obj"))) ==
        "m.mtl:2:1: warning: Ni: \"\" is not a number; the line is ignored\n"
        "m.mtl:3:1: warning: Ns -4 is outside [0, inf] and is clamped\n"
        "m.mtl:4:1: warning: illum: \"many\" is not a number; the line is ignored\n"
        "m.mtl:5:1: warning: d 3 is outside [0, 1] and is clamped\n");
}

TEST_CASE("faces before the first usemtl get a default material without a name") {
  const TempFolder folder;
  folder.write("m.mtl", "newmtl a\nKd 1 1 1\n");
  const MeshFile file =
      read_mesh(folder.write("a.obj", "mtllib m.mtl\n" + obj_square + "f 1 2 3\nusemtl a\nf 1 3 4\n"));
  CHECK(file.mesh.part_of_triangle == std::vector<int>{1, 0});
  REQUIRE(file.materials.size() == 2);
  CHECK(file.materials[1].name.empty());
  CHECK(file.materials[1].reflectance == Rgb{0.5, 0.5, 0.5});
}

TEST_CASE("several libraries in one line, names with blanks, folders with backslashes") {
  const TempFolder folder;
  folder.write("one.mtl", "newmtl a\nKd 0.1\n");
  folder.write("my second file.mtl", "newmtl b\nKd 0.2\n");
  folder.write("sub/third.mtl", "newmtl c\r\nKd 0.3\r\n");
  const std::string faces = obj_square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n";
  for (const char* line :
       {"mtllib one.mtl my second file.mtl sub/third.mtl", "mtllib my\\ second\\ file.mtl one.mtl .\\sub\\third.mtl",
        "mtllib one.mtl \\\n my second file.mtl\nmtllib sub/third.mtl  "}) {
    const MeshFile file = read_mesh(folder.write("a.obj", std::string(line) + "\n" + faces));
    CHECK(text_of(file.warnings).empty());
    REQUIRE(file.materials.size() == 3);
    CHECK(file.materials[0].reflectance.g == 0.1);
    CHECK(file.materials[1].reflectance.g == 0.2);
    CHECK(file.materials[2].reflectance.g == 0.3);
  }
}

TEST_CASE("a missing library and unknown materials are warnings") {
  const TempFolder folder;
  const MeshFile file =
      read_mesh(folder.write("a.obj", "mtllib gone.mtl also gone.mtl\n" + obj_square +
                                          "usemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl x\nf 1 2 3\n"));
  CHECK(text_of(material_warnings(file)) ==
        "a.obj:1:8: warning: material library \"gone.mtl\" cannot be opened\n"
        "a.obj:1:8: warning: material library \"also\" cannot be opened\n"
        "a.obj:6:1: warning: materials that no library defines: 2; they become the default diffuse; the first is "
        "\"x\"\n");
  REQUIRE(file.materials.size() == 2);
  CHECK(file.materials[1].reflectance == Rgb{0.5, 0.5, 0.5});
  // Beside materials that are given in place of some of them, or of all.
  CHECK(text_of(material_warnings(
            file, [](const std::string& name) { return name == "x"; }, "they shine")) ==
        "a.obj:1:8: warning: material library \"gone.mtl\" cannot be opened\n"
        "a.obj:1:8: warning: material library \"also\" cannot be opened\n"
        "a.obj:8:1: warning: materials that no library defines: 1; they shine; the first is \"y\"\n");
  CHECK(material_warnings(file, [](const std::string&) { return true; }).empty());
}

TEST_CASE("of very many missing libraries a few are named: lines are counted from the top") {
  const TempFolder folder;
  std::string text = obj_square;
  for (int i = 0; i < 300000; ++i) text += fmt::format("mtllib {}.mtl\n", i);
  const MeshFile file = read_mesh(folder.write("a.obj", text + "f 1 2 3\n"));
  const std::vector<Diagnostic> warnings = material_warnings(file);
  REQUIRE(warnings.size() == 9);
  CHECK(text_of(warnings).find("\"7.mtl\"") != std::string::npos);
  CHECK(text_of(warnings).find("from here on") != std::string::npos);
}

TEST_CASE("what an MTL file gets wrong") {
  const TempFolder folder;
  const std::string obj = folder.write("a.obj", "mtllib m.mtl\n" + obj_square + "usemtl a\nf 1 2 3\n");
  const auto read = [&](const std::string& text) {
    folder.write("m.mtl", text);
    const MeshFile file = read_mesh(obj);
    return std::pair(file.materials.at(0), text_of(material_warnings(file)));
  };
  SECTION("other colour spaces") {
    const auto [material, warnings] = read("newmtl a\nKd xyz 1 1 1\nKe spectral x.rfl\n");
    CHECK(material.reflectance == Rgb{0.5, 0.5, 0.5});
    CHECK(warnings ==
          "m.mtl:2:4: warning: Kd xyz is not supported; give red, green and blue\n"
          "m.mtl:3:4: warning: Ke spectral is not supported; give red, green and blue\n");
  }
  SECTION("textures") {
    const auto [material, warnings] =
        read("newmtl a\nKd 0.1 0.2 0.3\nmap_Kd -s 2 3 -o 0.5 -clamp on -bm 1 dir\\a b.png\n");
    CHECK(material.reflectance == Rgb{0.1, 0.2, 0.3});
    REQUIRE(material.reflectance_map);
    CHECK(material.reflectance_map->file == folder.path() + "/dir/a b.png");
    CHECK(material.reflectance_map->scale == Vec2{2, 3});
    CHECK(material.reflectance_map->offset == Vec2{0.5, 0});
    CHECK(material.reflectance_map->is_clamped);
    CHECK(material.reflectance_map->where.line == 3);
    CHECK(warnings.empty());
  }
  SECTION("a texture alone is not darkened, and one without a file is ignored") {
    const auto [material, warnings] = read("newmtl a\nmap_Kd a.png\nmap_Kd -s 2\n");
    CHECK(material.reflectance == Rgb{1, 1, 1});
    CHECK(material.reflectance_map->file == folder.path() + "/a.png");
    CHECK(warnings == "m.mtl:3:1: warning: map_Kd names no file; the line is ignored\n");
  }
  SECTION("values out of range") {
    const auto [material, warnings] = read("newmtl a\nKd 2 -1 0.5\nKe 9 -1 0\n");
    CHECK(material.reflectance == Rgb{1, 0, 0.5});
    CHECK(material.radiance == Rgb{9, 0, 0});
    CHECK(warnings ==
          "m.mtl:2:1: warning: Kd 2 is outside [0, 1] and is clamped\n"
          "m.mtl:2:1: warning: Kd -1 is outside [0, 1] and is clamped\n"
          "m.mtl:3:1: warning: Ke -1 is outside [0, inf] and is clamped\n");
  }
  SECTION("what is out of range the same way in a line is told once") {
    const auto [material, warnings] = read("newmtl a\nKd 2\nKs 3 0.5 3\n");
    CHECK(material.reflectance == Rgb{1, 1, 1});
    CHECK(material.specular == Rgb{1, 0.5, 1});
    CHECK(warnings ==
          "m.mtl:2:1: warning: Kd 2 is outside [0, 1] and is clamped\n"
          "m.mtl:3:1: warning: Ks 3 is outside [0, 1] and is clamped\n");
  }
  SECTION("lines that cannot be read") {
    const auto [material, warnings] = read("Kd 1 1 1\nnewmtl a\nKd 1 1\nKd a b c\nKd\n");
    CHECK(material.reflectance == Rgb{0.5, 0.5, 0.5});
    CHECK(warnings ==
          "m.mtl:1:1: warning: Kd before the first newmtl belongs to no material and is ignored\n"
          "m.mtl:3:1: warning: Kd takes 3 numbers (or 1 for grey), not 2; the line is ignored\n"
          "m.mtl:4:4: warning: Kd: \"a\" is not a number; the line is ignored\n"
          "m.mtl:5:1: warning: Kd takes 3 numbers (or 1 for grey), not 0; the line is ignored\n");
  }
  SECTION("numbers that are not finite") {
    folder.write("m.mtl", "newmtl a\nKd 1 nan 1\n");
    CHECK(text_of(material_warnings(read_mesh(obj))) == "m.mtl:2:6: error: Kd: \"nan\" is not finite\n");
  }
}

TEST_CASE("an mtllib line of very many words is read in one pass") {
  const TempFolder folder;
  std::string libraries = "mtllib";
  for (int i = 0; i < 1000000; ++i) libraries += " a\\";
  libraries += " a";
  CHECK(read_mesh(folder.write("a.obj", libraries + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).mesh.triangles.size() ==
        1);
}

}  // namespace
}  // namespace strahl
