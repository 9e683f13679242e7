// SPDX-License-Identifier: MIT
// Pictures that must be the same to the bit without anybody knowing which: the scene in other units of length,
// elsewhere, in a mirror, in another order. Rays go through the pixels' centres. STRAHL_ALL_SCALES: every power of two
// of 2^-40 ... 2^40 instead of some.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "render/pictures.h"
#include "study/transformed.h"

namespace strahl::test {
namespace {

/// Coordinates that a shift of 2^20 does not round: multiples of 2^-20.
Vec3 snapped(const Vec3& v) {
  const auto snap = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
  return {snap(v.x), snap(v.y), snap(v.z)};
}

/// 48 x 35 pixels: no ray runs along the diagonal, where walls of a room may meet: ties have no mirror image.
Scene centred(const std::string& name) {
  Scene scene = small_scene(scene_folder / name, 48, 35, 1);
  scene.sampler.kind = SamplerKind::centre;
  const Scene given = scene;
  scene = with_places(scene, snapped, snapped);
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    Geometry& geometry = scene.shapes[i].geometry;
    if (auto* c = std::get_if<Cylinder>(&geometry)) c->reference = orthonormal_basis(normalized(c->p1 - c->p0))[0];
    if (auto* d = std::get_if<Disk>(&geometry)) {  // The axes must stay perpendicular.
      d->axis_u = std::get<Disk>(given.shapes[i].geometry).axis_u;
      d->axis_v = std::get<Disk>(given.shapes[i].geometry).axis_v;
    }
  }
  return scene;
}

const std::vector<std::string>& scenes() {
  static const std::vector<std::string> names = {"lecture/lit.xml", "shapes/cube.xml", "mesh/torus-and-icosphere.xml",
                                                 "shapes/cylinder.xml"};
  return names;
}

Image picture(const Device& device, const Scene& scene, Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  settings.generic = precision != Precision::fast;  // Which no other test has built.
  return Renderer(device, scene, settings).render().color;
}

void hold_same_bits(const Image& image, const Image& expected) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < expected.data.size(); ++i)
    if (image.data[i] != expected.data[i] && ++differing < 4)
      UNSCOPED_INFO("value " << i << ": " << image.data[i] << " where " << expected.data[i] << " should be");
  CHECK(differing == 0);
  CHECK(same_bits(image, expected));
}

/// Holds `changed` of every scene, in every tier asked for, to `expected` of the picture as it was.
template <typename Change, typename Expect>
void hold(const std::vector<Precision>& tiers, const Change& changed, const Expect& expected) {
  require_pocl();
  const Device device = Device::open("pocl", {true});
  for (const std::string& name : scenes())
    for (const Precision precision : tiers) {
      INFO(name << ", " << precision_name(precision));
      const Scene scene = centred(name);
      const Image before = picture(device, scene, precision);
      CHECK(lit_pixels(before) > 48 * 35 / 8);
      for (const Scene& other : changed(scene)) hold_same_bits(picture(device, other, precision), expected(before));
    }
}

Image as_it_was(const Image& image) { return image; }

Image flipped(const Image& image) {
  Image other = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        other.data[static_cast<std::size_t>((y * image.width + x) * 3 + c)] = image.at(image.width - 1 - x, y, c);
  return other;
}

}  // namespace

TEST_CASE("another unit of length") {
  std::vector<int> exponents = {-40, -17, 1, 40};
  if (std::getenv("STRAHL_ALL_SCALES") != nullptr) {
    exponents.clear();
    for (int k = -40; k <= 40; ++k) exponents.push_back(k);
  }
  const auto changed = [&](const Scene& scene) {
    std::vector<Scene> others;
    for (const int k : exponents) others.push_back(scaled(scene, std::ldexp(1.0, k)));
    return others;
  };
  hold(asked_tiers(), changed, as_it_was);
}

TEST_CASE("elsewhere") {
  const auto changed = [](const Scene& scene) {
    return std::vector{translated(scene, {3, -5, 7}), translated(scene, {1048576, -777777, 0.5})};
  };
  hold(asked_tiers(), changed, as_it_was);
}

TEST_CASE("in a mirror") {
  hold(
      asked_tiers(), [](const Scene& scene) { return std::vector{mirrored(scene)}; }, flipped);
}

TEST_CASE("in another order") {
  std::vector<Precision> tiers = asked_tiers();
  std::erase(tiers, Precision::stable);
  hold(
      tiers, [](const Scene& scene) { return std::vector{reordered(scene)}; }, as_it_was);
}

TEST_CASE("fast is what the others are not") {
  require_pocl();
  const Device device = Device::open("pocl");
  const Scene scene = centred("lecture/lit.xml"), far = translated(scene, {1048576, -777777, 0.5});
  CHECK_FALSE(same_bits(picture(device, scene, Precision::fast), picture(device, far, Precision::fast)));
}

}  // namespace strahl::test
