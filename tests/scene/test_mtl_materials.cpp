// SPDX-License-Identifier: MIT
// What MTL's illumination models become.
#include <catch2/catch.hpp>

#include "image/image_io.h"
#include "kinds/textures.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// The scene of a triangle whose material has these lines; the part's material is the last one.
LoadedScene with_mtl(const std::string& lines) {
  const SceneFolder folder;
  write_image(Image{2, 2, {"R", "G", "B"}, std::vector<float>(12, 0.5F), {}}, folder.path("half.png"));
  folder.write("a.mtl", "newmtl a\n" + lines);
  return load_scene(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
}

template <typename Bsdf>
Bsdf bsdf_of(const LoadedScene& loaded) {
  CHECK(loaded.warnings.empty());
  return std::get<Bsdf>(loaded.scene.materials.back().bsdf);
}

bool is_close(const Rgb& a, const Rgb& b) {
  return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)}) < 1e-12;
}

}  // namespace

TEST_CASE("a highlight needs Ks, Ns and illum 2, and takes what Kd leaves") {
  const LoadedScene loaded = with_mtl("Kd 0.6 0.2 0\nKs 0.7 0.7 0.7\nNs 32\nillum 2\n");
  const auto phong = bsdf_of<Phong>(loaded);
  CHECK(is_close(phong.diffuse_reflectance.color, {0.6, 0.2, 0}));
  CHECK(is_close(phong.specular_reflectance.color, {0.4, 0.7, 0.7}));
  CHECK(phong.exponent.color == Rgb{32, 32, 32});
  CHECK(loaded.scene.materials.back().twosided);
  CHECK_FALSE(loaded.scene.materials.back().opacity);
  for (const char* lines : {"Ks 0.7\nNs 32\nillum 1\n", "Ks 0.7\n", "Ks 0\nNs 32\n", "Kd 1\nKs 0.5\nNs 9\n"})
    CHECK(bsdf_of<Diffuse>(with_mtl(lines)).reflectance.texture < 0);
}

TEST_CASE("mirrors: what is diffuse and what is mirrored add up to Kd and Ks") {
  for (const char* illum : {"illum 3\n", "illum 5\n", "illum 8\n"}) {
    const LoadedScene loaded = with_mtl("Kd 0.01 0.02 0.03\nKs 0.9 0.9 0.45\n" + std::string(illum));
    const auto blend = bsdf_of<Blend>(loaded);
    const auto at = [&](int i) { return loaded.scene.materials.at(static_cast<std::size_t>(i)).bsdf; };
    const double share = blend.weight.color.r;
    const Rgb base = std::get<Diffuse>(at(blend.first)).reflectance.color;
    const Rgb mirror = std::get<Conductor>(at(blend.second)).reflectance.color;
    CHECK(is_close({(1 - share) * base.r, (1 - share) * base.g, (1 - share) * base.b}, {0.01, 0.02, 0.03}));
    CHECK(is_close({share * mirror.r, share * mirror.g, share * mirror.b}, {0.9, 0.9, 0.45}));
    for (const Rgb& c : {base, mirror}) CHECK(std::max({c.r, c.g, c.b}) <= 1);
  }
  CHECK(bsdf_of<Conductor>(with_mtl("Kd 0 0 0\nKs 0.9 0.8 0.7\nillum 3\n")).reflectance.color == Rgb{0.9, 0.8, 0.7});
  CHECK(bsdf_of<Diffuse>(with_mtl("Kd 0.3\nillum 3\n")).reflectance.color == Rgb{0.3, 0.3, 0.3});
}

TEST_CASE("a mirror over a saturated Kd loads: each of the two reflects at most 1, and both as much less than told") {
  for (const char* map : {"", "map_Kd half.png\n"}) {
    const LoadedScene loaded = with_mtl("Kd 0.8 0.1 0.1\nKs 0.5 0.5 0.5\nillum 3\n" + std::string(map));
    INFO(map);
    const auto blend = bsdf_of<Blend>(loaded);
    const auto at = [&](int i) { return loaded.scene.materials.at(static_cast<std::size_t>(i)).bsdf; };
    const Reflectance base = std::get<Diffuse>(at(blend.first)).reflectance;
    // Ks takes what Kd leaves: 0.2 0.5 0.5; 0.8 and 0.5 are 1.3 together.
    CHECK(is_close(blend.weight.color, {0.5 / 1.3, 0.5 / 1.3, 0.5 / 1.3}));
    CHECK(is_close(base.color, {1, 0.125, 0.125}));
    CHECK(is_close(std::get<Conductor>(at(blend.second)).reflectance.color, {0.4, 1, 1}));
    REQUIRE((base.texture >= 0) == !std::string(map).empty());
    if (base.texture >= 0) CHECK(std::get<Bitmap>(loaded.scene.textures.at(0).pattern).scale == base.color);
  }
}

TEST_CASE("glass has the index Ni and Tf's hue, whatever its d") {
  for (const char* illum : {"illum 4\n", "illum 6\n", "illum 7\n", "illum 9\n"}) {
    const LoadedScene loaded = with_mtl("Kd 0.01\nKs 0.3\nTf 0.1 0.05 0.1\nNi 2.5\nd 0.2\n" + std::string(illum));
    const auto glass = bsdf_of<Dielectric>(loaded);
    CHECK(glass.int_ior == 2.5);
    CHECK(is_close(glass.transmittance.color, {1, 0.5, 1}));
    CHECK_FALSE(loaded.scene.materials.back().twosided);
    CHECK_FALSE(loaded.scene.materials.back().opacity);
  }
}

TEST_CASE("map_Bump and norm bend the normals of all that a material is") {
  for (const char* keyword : {"map_Bump", "map_bump", "bump"}) {
    const LoadedScene loaded = with_mtl("Kd 0.6\nd 0.25\n" + std::string(keyword) + " -bm 0.125 -s 2 3 half.png\n");
    const auto relief = bsdf_of<Relief>(loaded);
    CHECK(relief.kind == Relief::Kind::heights);
    CHECK(relief.scale == 0.125);
    const Material& material = loaded.scene.materials.back();
    const Material& inside = loaded.scene.materials.at(static_cast<std::size_t>(relief.nested));
    CHECK(std::get<Diffuse>(inside.bsdf).reflectance.color.r == 0.6);
    CHECK(material.twosided);
    CHECK(material.opacity);
    CHECK_FALSE(inside.opacity);
    const auto map = std::get<Bitmap>(loaded.scene.textures.at(static_cast<std::size_t>(relief.map.texture)).pattern);
    CHECK(map.curve.kind == TexelCurve::Kind::linear);
    CHECK(map.to_uv == std::array<double, 6>{2, 0, 0, 0, 3, -2});
  }
  const LoadedScene both = with_mtl("illum 3\nKs 0.4\nbump half.png\nnorm half.png\n");
  const auto relief = bsdf_of<Relief>(both);
  CHECK(relief.kind == Relief::Kind::normals);
  CHECK(std::holds_alternative<Blend>(both.scene.materials.at(static_cast<std::size_t>(relief.nested)).bsdf));
  const auto glass = bsdf_of<Relief>(with_mtl("illum 4\nbump -bm 2 half.png\n"));
  CHECK(glass.scale == 2);
  const LoadedScene absent = with_mtl("Kd 0.6\nbump none.png\n");
  REQUIRE(absent.warnings.size() == 1);
  CHECK(std::holds_alternative<Diffuse>(absent.scene.materials.back().bsdf));
}

TEST_CASE("d, Tr and map_d are masks") {
  const auto opacity = [](const std::string& lines) { return with_mtl(lines).scene.materials.back().opacity; };
  CHECK(opacity("d 0.25\n").value().color == Rgb{0.25, 0.25, 0.25});
  CHECK(opacity("d -halo 0.25\n").value().color.g == 0.25);
  CHECK(opacity("Tr 0.75\n").value().color.g == 0.25);
  CHECK(opacity("d 0.5\nTr 0.75\n").value().color.g == 0.5);
  CHECK_FALSE(opacity("d 1\nTr 0\n"));
  CHECK_FALSE(opacity("Tr 1\n"));
  const LoadedScene loaded = with_mtl("map_Kd half.png\nmap_d half.png\n");
  const Material& material = loaded.scene.materials.back();
  REQUIRE(material.opacity);
  const auto bitmap = [&](int texture) {
    return std::get<Bitmap>(loaded.scene.textures.at(static_cast<std::size_t>(texture)).pattern);
  };
  CHECK(bitmap(material.opacity->texture).curve.kind == TexelCurve::Kind::linear);
  CHECK(bitmap(std::get<Diffuse>(material.bsdf).reflectance.texture).curve.kind == TexelCurve::Kind::srgb);
}

TEST_CASE("a map that is no picture is left out, as one that is missing") {
  const SceneFolder folder;
  folder.write("wood.tif", "II*");
  folder.write("a.mtl", "newmtl a\nKd 0.25 0.5 0.75\nmap_Kd wood.tif\n");
  const LoadedScene loaded =
      load_scene(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("wood.tif") != std::string::npos);
  CHECK(std::get<Diffuse>(loaded.scene.materials.back().bsdf).reflectance.texture == -1);
}

TEST_CASE("errors of an MTL count where the shape has no material of its own") {
  const SceneFolder folder;
  folder.write("a.mtl", "newmtl a\nKd nan nan nan\n");
  folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const auto shape = [&](const std::string& inside) {
    return folder.write(
        "scene.xml", around("<shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/>" + inside + "</shape>"));
  };
  CHECK(load_scene(shape("<bsdf type=\"diffuse\"/>")).warnings.empty());
  CHECK_THROWS_AS(load_scene(shape("")), SceneError);
}

TEST_CASE("map_Kd and map_d of floats are cut at 1, a bump map is not") {
  const SceneFolder folder;
  write_image(Image{2, 2, {"R", "G", "B"}, std::vector<float>(12, 2), {}}, folder.path("bright.exr"));
  const auto load = [&](const std::string& lines) {
    folder.write("a.mtl", "newmtl a\n" + lines);
    return load_scene(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
  };
  for (const char* lines : {"Kd 1 1 1\nmap_Kd bright.exr\n", "Kd 1 1 1\nmap_d bright.exr\n"}) {
    INFO(lines);
    const LoadedScene cut = load(lines);
    REQUIRE(cut.warnings.size() == 1);
    CHECK_THAT(cut.warnings[0].message, Catch::Contains("4 of the 4 texels") && Catch::Contains("brighter than 1"));
    CHECK(kinds::brightest(cut.scene, 0) == Rgb{1, 1, 1});
    CHECK(std::get<Bitmap>(cut.scene.textures[0].pattern).mean == Rgb{1, 1, 1});
  }
  const LoadedScene heights = load("Kd 1 1 1\nbump bright.exr\n");
  CHECK(heights.warnings.empty());
  CHECK(kinds::brightest(heights.scene, 0) == Rgb{2, 2, 2});
}

/// As a shape without a file's materials is: Mitsuba's OBJ has none.
TEST_CASE("faces whose material no library defines are black where the shape shines, and open in 0.x around a medium") {
  const SceneFolder folder;
  folder.write("a.mtl", "newmtl a\nKd 0.25\n");
  folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl gone\nf 1 2 3\n");
  const auto load = [&](const char* version, const std::string& inside) {
    const std::string shape = "<shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/>" + inside + "</shape>";
    return load_scene(
        folder.write("scene.xml", "<scene version=\"" + std::string(version) + "\">" + shape + "</scene>"));
  };
  const auto of_face = [](const LoadedScene& loaded, std::size_t face) {
    const auto& mesh = std::get<Mesh>(loaded.scene.shapes.at(0).geometry);
    const MeshPart& part = mesh.parts.at(static_cast<std::size_t>(mesh.part_of_triangle.at(face)));
    return loaded.scene.materials.at(static_cast<std::size_t>(part.material));
  };
  const auto kd = [&](const LoadedScene& loaded, std::size_t face) {
    return std::get<Diffuse>(of_face(loaded, face).bsdf).reflectance.color.g;
  };
  const auto is_told = [](const LoadedScene& loaded, const std::string& fate) {
    return std::ranges::any_of(loaded.warnings, [&](const Diagnostic& one) {
      return one.message == "materials that no library defines: 1; " + fate + "; the first is \"gone\"";
    });
  };
  const std::string medium = "<medium name=\"interior\" type=\"homogeneous\"/>";
  const LoadedScene lamp = load("3.0.0", "<emitter type=\"area\"/>"), fog = load("0.6.0", medium),
                    own = load("3.0.0", medium), plain = load("3.0.0", "");
  CHECK(is_told(lamp, "they are black, as the shape shines"));
  CHECK(is_told(fog, "they let all light pass, as the shape bounds media"));
  CHECK(is_told(plain, "they become the default diffuse"));
  for (const std::size_t face : {0, 2}) {
    CHECK(kd(lamp, face) == 0);
    REQUIRE(of_face(fog, face).opacity);
    CHECK(of_face(fog, face).opacity->color == Rgb{0, 0, 0});
    CHECK(kd(own, face) == 0.5);
    CHECK(kd(plain, face) == 0.5);
  }
  for (const LoadedScene* loaded : {&lamp, &fog, &own, &plain}) CHECK(kd(*loaded, 1) == 0.25);
  CHECK_FALSE(of_face(fog, 1).opacity);
}
