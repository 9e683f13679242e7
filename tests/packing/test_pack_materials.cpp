// SPDX-License-Identifier: MIT
// Rows of materials: which textures are filtered with --texture-lod, and what scales the two parts of a phong.
#include <catch2/catch.hpp>

#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

Texture grey_bitmap(float value) {
  Texture texture;
  Bitmap bitmap;
  bitmap.texels = std::make_shared<const Texels>(texels_of_floats(4, 4, 1, std::vector<float>(16, value)));
  texture.pattern = bitmap;
  return texture;
}

/// Of a scene of one sphere, which has the last of the materials.
struct Rows {
  PackedScene<double> packed;

  Rows(const std::vector<Material>& materials, const std::vector<Texture>& textures, bool has_lod) {
    Scene scene;
    add(scene, Sphere{});
    scene.textures = textures;
    scene.materials = materials;
    scene.shapes[0].material = static_cast<int>(materials.size()) - 1;
    RenderSettings settings;
    settings.texture_lod = has_lod;
    PackOptions options{1, {}};
    options.acceleration = Acceleration::list;
    packed = pack_scene<double>(scene, features_of(scene, settings), options);
  }
  [[nodiscard]] int field(int material, int number) const {
    const int row = packed.index.at(layout::HEADER_MATERIALS) + material * layout::MATERIAL_INTS;
    return packed.index.at(static_cast<std::size_t>(row + number));
  }
};

}  // namespace

TEST_CASE("with --texture-lod colours have the rows with levels, opacities and weights those without") {
  Material colour, blend;
  colour.bsdf = Diffuse{{{}, 0}};
  colour.opacity = Reflectance{{}, 0};
  blend.bsdf = Blend{{{}, 0}, 0, 0};
  const Rows rows({colour, blend}, {grey_bitmap(0.5F)}, true);
  CHECK(rows.field(0, layout::MATERIAL_SLOTS) == ~0);
  CHECK(rows.field(0, layout::MATERIAL_OPACITY) == ~1);
  CHECK(rows.field(1, layout::MATERIAL_SLOTS) == ~1);
}

/// Mitsuba 0.6, ensureEnergyConservation: of textures the greatest values count.
TEST_CASE("a phong and a ward whose textures may be above 1 together are scaled to 0.99") {
  const auto scale = [](const auto& bsdf, int slot, float texel) {
    Material material;
    material.bsdf = bsdf;
    const Rows rows({material}, {grey_bitmap(texel)}, false);
    return rows.packed.shading.at(static_cast<std::size_t>(rows.field(0, layout::MATERIAL_SLOTS + slot)) + 2);
  };
  Phong phong;
  Ward ward;
  phong.diffuse_reflectance = ward.diffuse_reflectance = {{0.1, 0.1, 0.1}, 0};
  phong.specular_reflectance = ward.specular_reflectance = {{0.5, 0.5, 0.5}};
  CHECK(scale(phong, 3, 1) == Approx(0.99 / 1.5));
  CHECK(scale(ward, 5, 0.75F) == Approx(0.99 / 1.25));
  CHECK(scale(phong, 3, 0.5F) == 1);
  phong.specular_reflectance.texture = 0;
  CHECK(scale(phong, 3, 0.75F) == Approx(0.99 / 1.5));
}

TEST_CASE("a phong and a ward that show an attribute are scaled by the greatest value that meshes have, at most 1") {
  const auto scale = [](const auto& bsdf, int slot, double times, double value) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.attributes = {{"vertex_heat", {{0, 0, 0}, {value, 0.1, 0.1}, {0.1, 0.1, 0.1}}}};
    add(scene, mesh);
    scene.textures.emplace_back().pattern = AttributeTexture{"vertex_heat", times};
    scene.materials.resize(1);
    scene.materials[0].bsdf = bsdf;
    PackOptions options{1, {}};
    options.acceleration = Acceleration::list;
    const auto packed = pack_scene<double>(scene, features_of(scene, {}), options);
    const int row = packed.index.at(layout::HEADER_MATERIALS) + layout::MATERIAL_SLOTS + slot;
    return packed.shading.at(static_cast<std::size_t>(packed.index.at(static_cast<std::size_t>(row))) + 2);
  };
  Phong phong;
  Ward ward;
  phong.diffuse_reflectance = ward.diffuse_reflectance = {{0.1, 0.1, 0.1}, 0};
  phong.specular_reflectance = ward.specular_reflectance = {{0.5, 0.5, 0.5}};
  CHECK(scale(phong, 3, 1, 0.25) == 1);
  CHECK(scale(ward, 5, 2, 0.25) == 1);
  CHECK(scale(phong, 3, 3, 0.25) == Approx(0.99 / 1.25));
  CHECK(scale(ward, 5, 0.5, 1.5) == Approx(0.99 / 1.25));
  CHECK(scale(ward, 5, 1, 7) == Approx(0.99 / 1.5));
}
