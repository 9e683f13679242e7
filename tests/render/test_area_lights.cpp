// SPDX-License-Identifier: MIT
// Light from surfaces, and from everywhere, against closed forms: a floor below an emitter of every shape, by what is
// drawn on the emitter alone (whitted), together with what the material draws (direct), and as the first bounce of a
// path. Blocks of pixels must be off by what their own spread allows. The camera looks through the emitters, since
// they are hidden from it. 10 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <iostream>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

constexpr double rho = 0.6;
const Rgb radiance{2, 3, 5};

/// Irradiance over pi times radiance of a floor point from a polygon, all of it above the floor; positive where it
/// turns counter-clockwise as seen from the point: J. Lambert, "Photometria", 1760.
double form_factor(const Vec3& p, const std::vector<Vec3>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = normalized(corners[i] - p), b = normalized(corners[(i + 1) % corners.size()] - p);
    const Vec3 n = cross(a, b);
    if (length(n) > 0) sum += std::atan2(length(n), dot(a, b)) * normalized(n).z;
  }
  return sum / (2 * std::numbers::pi);
}

/// Of a polygon that emits on the side of its normal only.
double facing(const Vec3& p, const std::vector<Vec3>& corners) {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return dot(normal, p - corners[0]) > 0 ? std::fabs(form_factor(p, corners)) : 0;
}

Scene floor_below(const Geometry& emitter, bool is_flipped = false) {
  Scene scene = stage({floor_plane()}, diffuse({rho, rho, rho}));
  Shape shape = emitting(emitter, radiance);
  shape.flip_normals = is_flipped;
  add(scene, shape);
  scene.film.filter = {FilterKind::box, 1e-9};  // The truth is that of the pixels' middles.
  scene.integrator.hide_emitters = true;
  scene.integrator.max_depth = 2;
  scene.sampler.sample_count = 64;
  return scene;
}

/// Of blocks of 4 x 4 pixels, each by the spread of its own pixels about the truth: 1 on the mean where the picture is
/// right. And of the picture as a whole.
struct Deviation {
  double mean_square = 0, whole = 0;
};

Deviation deviation(const Image& image, const std::function<double(const Vec3&)>& expected) {
  constexpr int size = 4, blocks = stage_size / size;
  double whole = 0, whole_variance = 0;
  Deviation result;
  for (int block = 0; block < blocks * blocks; ++block) {
    double sum = 0, squares = 0;
    for (int k = 0; k < size * size; ++k) {
      const int x = block % blocks * size + k % size, y = block / blocks * size + k / size;
      const double off = static_cast<double>(image.at(x, y, 0)) / radiance.r - expected({stage_x(x), stage_y(y), 0});
      sum += off;
      squares += off * off;
    }
    constexpr double count = size * size;
    // Film units are 2^-28 of the radiance: where every sample is the same, so is what rounds.
    const double variance = (squares - sum * sum / count) / (count - 1) + std::ldexp(1.0, -54);
    result.mean_square += sum * sum / (count * variance) / (blocks * blocks);
    whole += sum;
    whole_variance += count * variance;
  }
  result.whole = whole / std::sqrt(whole_variance);
  return result;
}

Image picture(const Scene& scene) {
  static const Device device = Device::open("pocl");
  return Renderer(device, scene, generic_settings()).render().color;
}

void hold_picture(const Image& image, const std::function<double(const Vec3&)>& form) {
  const Deviation off = deviation(image, [&](const Vec3& p) { return rho * form(p); });
  CHECK(off.mean_square < 1.9);
  CHECK(off.mean_square > 0.5);
  CHECK(std::fabs(off.whole) < 4);
}

void hold(const std::string& what, Scene scene, const std::function<double(const Vec3&)>& form) {
  require_pocl();
  using Case = std::pair<const char*, SamplerKind>;
  for (const auto& [integrator, sampler] :
       {Case{"direct", SamplerKind::independent}, Case{"direct", SamplerKind::sobol},
        Case{"whitted", SamplerKind::independent}}) {
    scene.integrator.name = integrator;
    scene.sampler.kind = sampler;
    const Image image = picture(scene);
    INFO(what << " by " << integrator << (sampler == SamplerKind::sobol ? ", sobol" : ", independent"));
    hold_picture(image, form);
    if (std::string(integrator) == "whitted") continue;
    scene.integrator.name = "path";
    CHECK(same_bits(picture(scene), image));
  }
}

TEST_CASE("a disk") {
  hold("disk", floor_below(Disk{{0.2, 0, 1}, {0, 0.7, 0}, {0.7, 0, 0}}), [](const Vec3& p) {
    const double a = std::hypot(p.x - 0.2, p.y), h = 1, r = 0.7;
    const double z = 1 + (h * h + r * r) / (a * a), ratio = r / a;
    return 0.5 * (1 - (z - 2 * ratio * ratio) / std::sqrt(z * z - 4 * ratio * ratio));
  });
}

TEST_CASE("a sphere near and a small one far off") {
  for (const auto& [center, radius] : {std::pair(Vec3{0.3, -0.2, 1.2}, 1.0), std::pair(Vec3{0, 0.3, 2.5}, 0.1)})
    hold("sphere", floor_below(Sphere{center, radius}), [&](const Vec3& p) {
      const double d = length(center - p);
      return radius * radius * center.z / (d * d * d);
    });
}

TEST_CASE("a rectangle, tilted") {
  const Vec3 corner{-0.8, -0.5, 1.2}, u{0.2, 1.1, 0.1}, v{1.4, 0.1, 0.3};
  hold("rectangle", floor_below(Rectangle{corner, u, v}), [&](const Vec3& p) {
    return facing(p, {corner, corner + u, corner + u + v, corner + v});
  });
}

TEST_CASE("a triangle, and a mesh of that triangle and another one, turned inside out") {
  const Vec3 a{-1, -0.6, 1}, b{0.2, 1, 0.7}, c{1.1, -0.4, 1.4}, d{1.3, 1.2, 2};
  hold("triangle", floor_below(Triangle{a, b, c}), [&](const Vec3& p) { return facing(p, {a, b, c}); });
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}};
  hold("mesh", floor_below(mesh, true), [&](const Vec3& p) { return facing(p, {a, b, c}) + facing(p, {b, d, c}); });
}

TEST_CASE("two lights of two items each: whichever is drawn, any of its items is, and any place on it") {
  // In one plane: neither hides the other.
  const Vec3 a{-1.5, -0.6, 1}, b{-0.3, 1, 1}, c{0, -0.4, 1}, d{0.2, 1.2, 1};
  const Vec3 e{0.4, -1, 1}, f{1.7, -0.8, 1}, g{0.6, 0.1, 1}, h{1.6, 0.4, 1};
  const auto two = [](const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3) {
    Mesh mesh;
    mesh.positions = {p0, p1, p2, p3};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    return mesh;
  };
  Scene scene = floor_below(two(a, b, c, d));
  Shape second = emitting(two(e, g, f, h), radiance);
  add(scene, second);
  hold("two meshes", scene, [&](const Vec3& p) {
    return facing(p, {a, b, c}) + facing(p, {b, d, c}) + facing(p, {e, g, f}) + facing(p, {g, h, f});
  });
}

TEST_CASE("a cube and a box") {
  const auto faces = [](const Vec3& o, const std::array<Vec3, 3>& e, const Vec3& p) {
    double sum = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const Vec3 u = e.at((i + 1) % 3), v = e.at((i + 2) % 3), across = o + e.at(i);
      sum += facing(p, {o, o + v, o + u + v, o + u}) + facing(p, {across, across + u, across + u + v, across + v});
    }
    return sum;
  };
  const Cube cube{{-0.5, -0.4, 0.5}, {{{0.8, 0.3, 0}, {-0.2, 0.7, 0.1}, {0, 0.1, 0.9}}}};
  hold("cube", floor_below(cube), [&](const Vec3& p) { return faces(cube.corner, cube.edge, p); });
  hold("box", floor_below(Box{{-0.3, -0.6, 0.4}, {0.5, 0.2, 1}}), [&](const Vec3& p) {
    return faces({-0.3, -0.6, 0.4}, {{{0.8, 0, 0}, {0, 0.8, 0}, {0, 0, 0.6}}}, p);
  });
}

TEST_CASE("a cylinder") {
  const Vec3 foot{-0.7, 0.1, 0.8}, axis{1.5, 0.2, 0.4};
  const Vec3 side = normalized(cross(axis, {0, 0, 1})), up = normalized(cross(side, axis));
  hold("cylinder", floor_below(Cylinder{foot, foot + axis, 0.3, side}), [&](const Vec3& p) {
    double sum = 0;
    constexpr int strips = 300;
    const auto rim = [&](int i) {
      const double angle = 2 * std::numbers::pi * i / strips;
      return foot + 0.3 * std::cos(angle) * side + 0.3 * std::sin(angle) * up;
    };
    const double sense = dot(cross(axis, side), up);
    for (int i = 0; i < strips; ++i) {
      const Vec3 a = rim(i), b = rim(i + 1);
      sum += sense > 0 ? facing(p, {a, b, b + axis, a + axis}) : facing(p, {b, a, a + axis, b + axis});
    }
    return sum;
  });
}

// Below the tube all ways to its far inside lead through its near side; others come out of its ends.
TEST_CASE("a cylinder that shines inwards is in the way of its own light") {
  require_pocl();
  Scene scene = floor_below(Cylinder{{-0.4, 0, 1.2}, {0.4, 0, 1.2}, 0.4, {0, 0, 1}}, true);
  scene.integrator.name = "whitted";
  for (const Precision precision : asked_tiers()) {
    const Image image = color(scene, precision);
    CHECK(image.at(stage_size / 2, stage_size / 2, 0) == 0);
    CHECK(image.at(stage_size - 1, stage_size / 2, 0) > 0);
  }
}

TEST_CASE("the fast tier draws all around a cylinder and a sphere") {
  require_pocl();
  for (const Geometry& emitter :
       {Geometry{Cylinder{{-0.5, 0, 1.5}, {0.5, 0, 1.5}, 0.2, {0, 0, 1}}}, Geometry{Sphere{{0, 0, 1.5}, 0.5}}}) {
    Scene scene = floor_below(emitter);
    scene.integrator.name = "whitted";
    RenderSettings settings;  // Of its own program: no other test asks for the generic one in this tier.
    settings.precision = Precision::fast;
    const Image fast = render("pocl", scene, settings).color, robust = color(scene);
    double differing = 0, sum = 0;
    for (std::size_t i = 0; i < fast.data.size(); ++i) {
      differing += std::fabs(static_cast<double>(fast.data[i]) - static_cast<double>(robust.data[i]));
      sum += static_cast<double>(robust.data[i]);
    }
    CHECK(differing < 0.001 * sum);
  }
}

TEST_CASE("the same from everywhere") {
  Scene scene = floor_below(Rectangle{{0, 0, 9}, {1, 0, 0}, {0, 1, 0}});
  scene.shapes.pop_back();
  add(scene, ConstantLight{radiance});
  scene.integrator.name = "whitted";
  hold_picture(picture(scene), [](const Vec3&) { return 1.0; });
  // Whatever direction a diffuse material draws finds the same: without noise.
  for (const char* integrator : {"direct", "path"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    const Image image = picture(scene);
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x)
        REQUIRE(static_cast<double>(image.at(x, y, 0)) == Approx(rho * radiance.r).epsilon(1e-6));
  }
}

// The base lets all light through, to directions that the material never draws.
TEST_CASE("the same from everywhere, of a material that draws but a part of what it scatters") {
  Scene scene = floor_below(Rectangle{{0, 0, 9}, {1, 0, 0}, {0, 1, 0}});
  scene.shapes.pop_back();
  add(scene, ConstantLight{radiance});
  PrincipledThin sheet{.base_color = {{rho, rho, rho}}, .diff_trans = {{2, 2, 2}}};
  sheet.diffuse_transmittance_sampling_rate = 0;
  scene.materials[0].bsdf = sheet;
  for (const char* integrator : {"direct", "path"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    hold_picture(picture(scene), [](const Vec3&) { return 1.0; });
  }
}

}  // namespace
}  // namespace strahl::test
