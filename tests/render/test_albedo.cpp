// SPDX-License-Identifier: MIT
// --aov albedo: the documented colour of each material (docs/scene-materials.md, "Albedo"), with its texture, seen
// through blends, masks, sides and reliefs; black where nothing is hit; whatever the integrator, and in every tier.
#include <catch2/catch.hpp>
#include <cmath>

#include "kinds/materials.h"
#include "render/stage.h"

namespace strahl::test {
namespace {

struct Look {
  Material material;
  Rgb albedo;
};

template <typename Bsdf>
Material of(const Bsdf& bsdf) {
  Material material;
  material.bsdf = bsdf;
  return material;
}

double metal_at_normal(double eta, double k) {
  return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}

/// Materials inside others stand before them: their albedo is asked for as well. Texture 0: colours a and b.
std::vector<Look> looks(const Rgb& a, const Rgb& b) {
  const Rgb red{0.75, 0.5, 0.25}, blue{0.125, 0.25, 0.5};
  const MetalIndex index{{{0.2, 1.5, 3}}, {{4, 0.5, 2}}};
  const Rgb metal{metal_at_normal(0.2, 4), metal_at_normal(1.5, 0.5), metal_at_normal(3, 2)};
  const Rgb tinted{red.r * metal.r, red.g * metal.g, red.b * metal.b};
  std::vector<Look> all = {{of(Diffuse{{red}}), red},
                           {of(Diffuse{{blue, 0}}), a},
                           {of(Conductor{{red}}), red},
                           {of(Conductor{{red}, index}), tinted},
                           {of(RoughConductor{{red}, index}), tinted},
                           {of(Dielectric{}), {1, 1, 1}},
                           {of(ThinDielectric{}), {1, 1, 1}},
                           {of(RoughDielectric{}), {1, 1, 1}},
                           {of(Plastic{.diffuse_reflectance = {red}}), red},
                           {of(RoughPlastic{{.diffuse_reflectance = {red}}}), red},
                           {of(Principled{.base_color = {red}}), red},
                           {of(PrincipledThin{.base_color = {red}}), red},
                           {of(Phong{{red}}), red},
                           {of(Ward{.diffuse_reflectance = {red}}), red},
                           {of(RoughDiffuse{{red}}), red},
                           {of(DiffTrans{{red}}), red}};
  Material veil = of(Diffuse{{red}});
  veil.opacity = Reflectance{{0.25, 0.25, 0.25}};
  all.push_back({veil, {0.25 * red.r, 0.25 * red.g, 0.25 * red.b}});
  all.push_back({of(Blend{{{0, 0, 0}}, 0, 3}), red});
  all.push_back({of(Blend{{{1, 1, 1}}, 0, 3}), tinted});
  all.push_back({of(Relief{.map = {{0.7, 0.5, 0.9}}, .nested = 1}), a});
  Material glow = of(Diffuse{{b}});
  all.push_back({glow, b});
  return all;
}

/// Squares of half a unit, row by row.
Scene scene_of(const std::vector<Look>& all, const Rgb& a, const Rgb& b) {
  Scene scene = stage({}, {});
  scene.materials.clear();
  scene.textures = {{"", Checkerboard{a, b, {0.25, 0, 0, 0, 0.25, 0}}, {}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    scene.materials.push_back(all[i].material);
    Shape& shape = scene.shapes.emplace_back();
    shape.geometry = Rectangle{
        {-2 + 0.5 * static_cast<double>(i % 8), 1.5 - 0.5 * static_cast<double>(i / 8), 0}, {0.5, 0, 0}, {0, 0.5, 0}};
    shape.material = static_cast<int>(i);
  }
  scene.shapes.back().radiance = Rgb{3, 3, 3};
  return scene;
}

TEST_CASE("each material has the albedo that the docs say") {
  const Rgb a{0.5, 0.75, 1}, b{0.25, 0, 0.125};
  const std::vector<Look> all = looks(a, b);
  for (const char* integrator : {"path", "depth"})
    for (const Precision precision : asked_tiers()) {
      Scene scene = scene_of(all, a, b);
      scene.integrator.name = integrator;
      RenderSettings settings;
      settings.precision = precision;
      settings.generic = precision != Precision::robust;  // What the layer calls for is asked in one tier.
      settings.aovs = {Aov::albedo, Aov::shape_id};
      const Image image = render("pocl", scene, settings).aov;
      REQUIRE(image.channels == std::vector<std::string>{"albedo.R", "albedo.G", "albedo.B", "shape_id.I"});
      for (int y = 0; y < stage_size; ++y)
        for (int x = 0; x < stage_size; ++x) {
          const float* pixel = &image.data[image.index(x, y, 0)];
          const int shape = static_cast<int>(pixel[3]);
          INFO(integrator << ", " << precision_name(precision) << ", shape " << shape);
          const Rgb expected = shape < 0 ? Rgb{} : all[static_cast<std::size_t>(shape)].albedo;
          CHECK(pixel[0] == Approx(expected.r).epsilon(1e-6));
          CHECK(pixel[1] == Approx(expected.g).epsilon(1e-6));
          CHECK(pixel[2] == Approx(expected.b).epsilon(1e-6));
        }
    }
}

/// Whose triangles face +z, and whose vertex normals do not.
TEST_CASE("the side that is seen is the one that the shading normals say, whatever the integrator") {
  const Rgb red{0.75, 0.5, 0.25}, blue{0.125, 0.25, 0.5};
  Mesh mesh;
  mesh.positions = {{-3, -3, 0}, {3, -3, 0}, {0, 6, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals.assign(3, {0, 0, -1});
  Material front = of(Diffuse{{red}});
  front.twosided = true;
  front.back = 1;
  for (const char* integrator : {"path", "depth", "emission"}) {
    INFO(integrator);
    Scene scene = stage({mesh}, front);
    scene.materials.push_back(of(Diffuse{{blue}}));
    scene.integrator.name = integrator;
    RenderSettings settings;
    settings.aovs = {Aov::albedo};
    const Image image = render("pocl", scene, settings).aov;
    const float* pixel = &image.data[image.index(stage_size / 2, stage_size / 2, 0)];
    CHECK(pixel[0] == Approx(blue.r));
    CHECK(pixel[2] == Approx(blue.b));
  }
}

/// Every kind of material that the kernels have is asked for above.
TEST_CASE("no material is without an albedo") {
  std::set<std::string> kinds;
  for (const Look& look : looks({}, {})) kinds.insert(material_facts(look.material).kind);
  const std::set<std::string> known = {
#define MATERIAL(name, reals, lobes) #name,
#include "../../cl/materials/materials.def"
#undef MATERIAL
  };
  for (const std::string& kind : known) {
    INFO(kind);
    CHECK(kinds.contains(kind));
  }
}

}  // namespace
}  // namespace strahl::test
