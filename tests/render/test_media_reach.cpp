// SPDX-License-Identifier: MIT
// Rays in homogeneous media end where the path scatters (cl/media/reach_lanes.h), and no lights are drawn where a
// medium says so. What emits is looked at as far as anything is met, so the same scenes with the faintest glow are the
// oracle. 20 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "image/texels.h"
#include "program/features.h"
#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Material glass() {
  Material glass;
  glass.bsdf = Dielectric{1.5, 1};
  return glass;
}

/// A material that asks for all that textures know of a place: the squares are narrower than what samples are filtered
/// to.
int bumpy_board(Scene& scene) {
  Bitmap ramp;
  ramp.texels = std::make_shared<const Texels>(texels_of_floats(2, 1, 1, {0, 0.15F}));
  scene.textures = {{"", Checkerboard{{0.9, 0.7, 0.5}, {0.2, 0.3, 0.4}, {300, 0, 0, 0, 300, 0}}, {}},
                    {"", ramp, {}, true}};
  Diffuse board;
  board.reflectance.texture = 0;
  Relief relief;
  relief.kind = Relief::Kind::heights;
  relief.map.texture = 1;
  relief.nested = add(scene, board);
  return add(scene, relief);
}

/// A body full of a medium, over a floor, with a ball and a lamp in it, and another body across its side.
Scene body_with_things(const Material& surface, double density) {
  Scene scene = stage({block({-1.2, -1, -1}, {1, 1.1, 1})}, surface);
  scene.media = {medium({density, 1.5 * density, 2 * density}, {0.9, 0.8, 0.7}),
                 medium({2 * density, 2 * density, 2 * density}, {0.6, 0.9, 0.9})};
  scene.shapes.front().media = MediumBoundary{0, -1};
  scene.integrator.name = "volpath";
  scene.integrator.max_depth = 12;
  scene.lights = {light(ConstantLight{{0.5, 0.6, 0.7}})};
  const int grey = add(scene, Diffuse{{{0.5, 0.5, 0.5}}}), clear = static_cast<int>(scene.materials.size());
  scene.materials.push_back(boundary());
  RoughConductor brushed;
  brushed.microfacets.alpha_u.color = {0.1, 0.1, 0.1};
  brushed.microfacets.alpha_v.color = {0.4, 0.4, 0.4};
  add(scene, Sphere{{0.4, 0.3, 0.2}, 0.4}, add(scene, brushed));
  add(scene, Rectangle{{-2, -2, -1.5}, {4, 0, 0}, {0, 4, 0}}, bumpy_board(scene));
  add(scene, Rectangle{{-0.7, -0.6, 0.5}, {0.3, 0, 0}, {0, 0.3, 0}}, grey);
  scene.shapes.back().radiance = Rgb{3, 2, 1};
  add(scene, Sphere{{-1.1, 0.2, 0}, 0.5}, clear);
  scene.shapes.back().media = MediumBoundary{1, 0};
  return scene;
}

double largest_difference(const Image& a, const Image& b) {
  REQUIRE(a.data.size() == b.data.size());
  double most = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    if (a.data[i] == b.data[i]) continue;
    const double off = std::fabs(static_cast<double>(a.data[i]) - static_cast<double>(b.data[i]));
    most = std::isnan(off) ? std::numeric_limits<double>::infinity() : std::max(most, off);
  }
  return most;
}

void check_unchanged_by_reach(Scene scene) {
  Scene seen_whole = scene;
  for (Medium& medium : seen_whole.media) medium.emission = Rgb{1e-30, 1e-30, 1e-30};
  for (Scene* each : {&scene, &seen_whole}) {
    each->sampler.kind = SamplerKind::independent;
    each->sampler.sample_count = 32;
  }
  // Sums of weighted samples round ties, which the glow decides.
  const RenderResult cut = stage_picture(scene, Precision::robust, without_sharing);
  const RenderResult whole = stage_picture(seen_whole, Precision::robust, without_sharing);
  CHECK(mean_of(cut.color).g > 1e-3);
  CHECK(largest_difference(cut.color, whole.color) < 1e-20);
  CHECK(largest_difference(cut.aov, whole.aov) == 0);
}

TEST_CASE("where rays end with their paths' ways the picture is the same") {
  require_pocl();
  for (const double density : {0.05, 1.0, 30.0}) {
    INFO(density);
    check_unchanged_by_reach(body_with_things(boundary(), density));
    check_unchanged_by_reach(body_with_things(glass(), density));
  }
}

TEST_CASE("so it is around the camera, and where bodies have priorities") {
  require_pocl();
  Scene scene = body_with_things(boundary(), 0.1);
  scene.camera.medium = 0;
  scene.shapes.front().media = MediumBoundary{1, 0};
  check_unchanged_by_reach(scene);
  scene.camera.near_clip = 2.5;
  check_unchanged_by_reach(scene);
  Scene ranked = body_with_things(glass(), 2);
  ranked.shapes.front().priority = 1;
  ranked.shapes.back().priority = 2;
  ranked.shapes.back().media = MediumBoundary{1, -1};
  check_unchanged_by_reach(ranked);
}

TEST_CASE("paths that leave a medium see what is behind it") {
  require_pocl();
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, medium({1, 2, 3}, {1, 1, 1}), 0);
  add(scene, Box{{-9, -9, -9}, {9, 9, 9}}, add(scene, Diffuse{{{0, 0, 0}}}));
  scene.shapes.back().flip_normals = true;
  scene.shapes.back().radiance = Rgb{1, 1, 1};
  const Rgb mean = mean_of(drawn(scene, 64));
  CHECK(mean.r == Approx(1).margin(4e-3));
  CHECK(mean.b == Approx(1).margin(6e-3));
}

TEST_CASE("a medium in which no lights are drawn looks as if they were") {
  require_pocl();
  for (const Material& surface : {boundary(), glass()}) {
    Scene scene = body_with_things(surface, 1);
    const Rgb drawn_lights = mean_of(drawn(scene, 1024));
    for (Medium& medium : scene.media) medium.samples_emitters = false;
    const Rgb found_lights = mean_of(drawn(scene, 1024));
    CHECK(found_lights.r == Approx(drawn_lights.r).epsilon(6e-3));
    CHECK(found_lights.b == Approx(drawn_lights.b).epsilon(6e-3));
    // Of one of the two alone, in lanes that scatter in either.
    scene.media.front().samples_emitters = true;
    CHECK(mean_of(drawn(scene, 1024)).g == Approx(drawn_lights.g).epsilon(6e-3));
  }
}

TEST_CASE("lights that are only drawn do not reach what scatters in such a medium") {
  require_pocl();
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, medium({2, 2, 2}, {0.9, 0.9, 0.9}));
  scene.lights = {light(PointLight{{0, 0, 3}, {1, 1, 1}})};
  CHECK(mean_of(drawn(scene, 16)).g > 1e-3);
  CHECK_FALSE(features_of(scene, {}).flag("UNLIT_MEDIA"));
  scene.media.front().samples_emitters = false;
  CHECK(mean_of(drawn(scene, 16)).g == 0);
  CHECK(features_of(scene, {}).flag("UNLIT_MEDIA"));
}

TEST_CASE("such media by programs of their own, in lanes and without the effect", "[slow]") {
  require_pocl();
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, medium({2, 2, 2}, {0.9, 0.9, 0.9}));
  scene.lights = {light(PointLight{{0, 0, 3}, {1, 1, 1}})};
  scene.media.front().samples_emitters = false;
  check_in_lanes(scene, true);
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  scene.media.front().albedo = Rgb{1, 1, 1};
  CHECK(mean_of(render("pocl", scene, {}).color).g == Approx(1).margin(0.1));
  check_in_lanes(scene, true);
  RenderSettings without;
  without.disabled = {"UNLIT_MEDIA"};
  scene.lights = {light(PointLight{{0, 0, 3}, {1, 1, 1}})};
  CHECK(mean_of(render("pocl", scene, without).color).g > 1e-3);
}

}  // namespace
}  // namespace strahl::test
