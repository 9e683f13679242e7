// SPDX-License-Identifier: MIT
// Glass in closed form, in path and whitted: plates at every angle, a sphere as a lens, a camera within glass about the
// critical angle, furnaces, indices that are the same; and whitted against a recursive walk in double precision. 20 s.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "render/limitations.h"
#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Material glass(double int_ior, double ext_ior = 1, const Rgb& transmittance = {1, 1, 1}) {
  Material material;
  material.bsdf = Dielectric{int_ior, ext_ior, {{1, 1, 1}}, {transmittance}};
  return material;
}

/// Fresnel's reflectance by both angles.
double reflected(double cosine, double eta) {
  const double t2 = 1 - (1 - cosine * cosine) / (eta * eta);
  if (t2 < 0) return 1;
  const double t = std::sqrt(t2), s = (cosine - eta * t) / (cosine + eta * t),
               p = (eta * cosine - t) / (eta * cosine + t);
  return 0.5 * (s * s + p * p);
}

Scene with_integrator(Scene scene, const char* name) {
  scene.integrator.name = name;
  return scene;
}

int black(Scene& scene) { return add(scene, Diffuse{{{0, 0, 0}}}); }

/// Black, and glows on its upper side.
void add_lamp(Scene& scene, const Geometry& geometry, const Rgb& radiance) {
  Shape lamp = emitting(geometry, radiance);
  lamp.material = black(scene);
  add(scene, lamp);
}

double at_middle(const Image& image, std::size_t channel = 0) {
  return static_cast<double>(image.at(stage_size / 2, stage_size / 2, static_cast<int>(channel)));
}

/// A plate that the stage's rays meet at that angle.
Cube plate(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec3 u{100 * c, 0, 100 * s}, v{0, 100, 0}, w{-0.2 * s, 0, 0.2 * c};
  return {-0.5 * (u + v + w), {u, v, w}};
}

/// Not where a steep plate reflects to.
Rectangle lamp_below() { return {{-20, -20, -290}, {40, 0, 0}, {0, 40, 0}}; }

TEST_CASE("a plate lets through what remains after all reflections between its faces") {
  require_pocl();
  for (const double degrees : {0.0, 30.0, 56.309932474020215, 75.0}) {
    const double angle = degrees * std::numbers::pi / 180, r = reflected(std::cos(angle), 1.5);
    for (const double t : {1.0, 0.8}) {
      INFO(degrees << " degrees, transmittance " << t);
      Scene scene = stage({plate(angle)}, glass(1.5, 1, {t, t, t}));
      add_lamp(scene, lamp_below(), {1, 1, 1});
      const double through = t * t * (1 - r) * (1 - r) / (1 - r * r);
      for (const Precision precision : asked_tiers())
        CHECK(at_middle(color(with_integrator(scene, "whitted"), precision)) == Approx(through).epsilon(2e-5));
      scene.sampler.sample_count = 4;
      const Image drawn = color(with_integrator(scene, "path"));
      double sum = 0;
      int count = 0;
      for (int y = 0; y < stage_size; ++y)
        for (int x = 0; x < stage_size; ++x) {
          if (std::fabs(stage_x(x)) > 0.8) continue;  // Farther out a steep plate lies behind the camera.
          sum += static_cast<double>(drawn.at(x, y, 0));
          ++count;
        }
      CHECK(sum / count == Approx(through).margin(0.03));
    }
  }
}

TEST_CASE("a sphere is the lens that Snell's law makes of it") {
  require_pocl();
  constexpr double eta = 1.5, below = 2.2, target = 0.35;
  Scene scene = stage({Sphere{{0, 0, 0}, 1.5, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}}, glass(eta));
  add_lamp(scene, Disk{{0, 0, -below}, {target, 0, 0}, {0, target, 0}}, {1, 1, 1});
  scene.integrator.max_depth = 3;  // In, out, lamp.
  for (const char* integrator : {"whitted", "path"})
    for (const Precision precision : asked_tiers()) {
      scene.sampler.sample_count = integrator == std::string("path") ? 16 : 1;
      const Image image = color(with_integrator(scene, integrator), precision);
      int inside = 0, outside = 0;
      double sum = 0, expected = 0;
      for (int y = 0; y < stage_size; ++y)
        for (int x = 0; x < stage_size; ++x) {
          const double h = std::hypot(stage_x(x), stage_y(y)), sine = h / 1.5;
          if (sine > 0.99) continue;
          const double in = std::asin(sine), refracted = std::asin(sine / eta);
          // It leaves the sphere turned by twice the difference, at the angle of the two chords from where it came.
          const double turn = 2 * (in - refracted), leaves = 2 * refracted - in;
          const double radius = -1.5 * std::sin(leaves), depth = -1.5 * std::cos(leaves);
          const double at = -radius - (depth + below) * std::tan(turn);
          if (std::fabs(std::fabs(at) - target) < 1e-3) continue;
          const bool is_lit = std::fabs(at) < target;
          const double share = is_lit ? std::pow(1 - reflected(std::cos(in), eta), 2) : 0;
          const auto value = static_cast<double>(image.at(x, y, 0));
          INFO(integrator << " " << precision_name(precision) << " at " << x << ", " << y);
          if (scene.sampler.sample_count == 1) CHECK(value == Approx(share).margin(2e-5));
          if (!is_lit) CHECK(value == 0);
          ++(is_lit ? inside : outside);
          sum += value;
          expected += share;
        }
      CHECK(inside > 50);
      CHECK(outside > 50);
      CHECK(sum == Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("within glass, about the critical angle") {
  require_pocl();
  // The camera is behind the plane's normal, in glass; outside there is a sky.
  const double critical = std::asin(1 / 1.5);
  for (const double angle : {0.0, 0.5, critical - 1e-3, critical, critical + 1e-3, 1.2}) {
    INFO(angle);
    const Vec3 normal{std::sin(angle), 0, -std::cos(angle)};
    Scene scene = stage({plane_through({0, 0, 0}, normal)}, glass(1.5));
    scene.lights = {light(ConstantLight{{1, 1, 1}})};
    const double r = reflected(std::cos(angle), 1 / 1.5);
    // Radiance is 2.25 times as dense in there. Beyond the angle what is reflected comes from the sky as it is.
    const double expected = r + 2.25 * (1 - r);
    for (const Precision precision : asked_tiers()) {
      const double value = at_middle(color(with_integrator(scene, "whitted"), precision));
      CHECK(std::isfinite(value));
      // At the angle itself a rounding moves the share by its square root.
      CHECK(value == Approx(expected).margin(angle == critical ? 0.02 : 1e-3));
    }
  }
}

TEST_CASE("glass that absorbs nothing cannot be seen under an even sky") {
  require_pocl();
  Scene scene =
      stage({Sphere{{0, 0, 0}, 1.2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, plate(0.7)}, glass(1.5046, 1.000277));
  std::get<Cube>(scene.shapes[1].geometry).corner.z -= 90;
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  scene.integrator.rr_depth = 1000;
  scene.integrator.max_depth = 1000;
  for (const char* integrator : {"path", "whitted"})
    for (const Precision precision : asked_tiers()) {
      const Image image = color(with_integrator(scene, integrator), precision);
      double worst = 0;
      for (const float value : image.data) worst = std::max(worst, std::fabs(static_cast<double>(value) - 1));
      INFO(integrator << " " << precision_name(precision));
      CHECK(worst < 3e-5);
    }
}

TEST_CASE("Russian roulette does not mistake light in glass for weak light") {
  require_pocl();
  Scene scene = stage({Sphere{{0, 0, 0}, 1.2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}}, glass(2.4));
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  scene.integrator.rr_depth = 1;
  scene.sampler.sample_count = 64;
  const Image image = color(with_integrator(scene, "path"));
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < image.data.size(); i += 3) {
    const auto x = static_cast<double>(image.data[i]);
    sum += x;
    squares += x * x;
    ++count;
  }
  const double deviation = std::sqrt(squares / count - sum * sum / count / count);
  CHECK(sum / count == Approx(1).margin(4 * deviation / std::sqrt(count)));
  // At 0.95 a surface; by the radiance alone it would go on with 0.17 in there and the noise be six times as large.
  CHECK(deviation < 0.1);
}

TEST_CASE("glass of the index around it is not there") {
  require_pocl();
  Scene scene = stage({});
  add_lamp(scene, Sphere{{0.3, 0.2, -3}, 1, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, {3, 2, 1});
  add_lamp(scene, Rectangle{{-1.5, -1.7, -5}, {2, 0, 0.3}, {0, 2, 0}}, {0.5, 0.25, 8});
  Scene with = scene;
  with.materials.push_back(glass(1.33, 1.33));
  add(with, Sphere{{0, 0, 0}, 1.4, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, static_cast<int>(with.materials.size()) - 1);
  for (const char* integrator : {"path", "whitted"})
    for (const Precision precision : asked_tiers()) {
      INFO(integrator << " " << precision_name(precision));
      const Image bare = color(with_integrator(scene, integrator), precision);
      CHECK(lit_pixels(bare) > 100);
      CHECK(same_bits(bare, color(with_integrator(with, integrator), precision)));
    }
}

TEST_CASE("twosided does not change glass") {
  require_pocl();
  Scene scene = stage({Sphere{{0, 0, 0}, 1.2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}}, glass(1.5));
  add_lamp(scene, lamp_below(), {1, 2, 3});
  const Image plain = color(with_integrator(scene, "whitted"));
  scene.materials[0].twosided = true;
  CHECK(same_bits(plain, color(with_integrator(scene, "whitted"))));
}

// ---- whitted against recursion -----------------------------------------------------------------------------------

struct Ball {
  Vec3 center;
  double radius;
  double ior;  ///< 0: glows.
  Rgb radiance{};
};

const std::vector<Ball>& balls() {
  static const std::vector<Ball> all{{{-0.5, 0.2, 0}, 0.9, 1.5},
                                     {{0.9, -0.4, -0.6}, 0.7, 1.33},
                                     {{0.5, 1.2, -1}, 0.5, 2.4},
                                     {{-0.5, 0.2, 0}, 0.4, 1 / 1.5},
                                     {{-1.2, -0.9, -2.5}, 0.8, 0, {4, 1, 0.5}},
                                     {{1, 0.7, -3.5}, 1, 0, {0.3, 2, 5}},
                                     {{0.3, -1, 6}, 1.2, 0, {1, 1, 1}}};
  return all;
}

Rgb trace(const Vec3& o, const Vec3& d, double weight, int depth, int left) {
  std::optional<double> nearest;
  int met = -1;
  for (int i = 0; i < static_cast<int>(balls().size()); ++i) {
    const Ball& ball = balls()[static_cast<std::size_t>(i)];
    const Vec3 to = o - ball.center;
    const double b = dot(to, d), q = dot(to, to) - ball.radius * ball.radius, root = b * b - q;
    if (root < 0) continue;
    for (const double t : {-b - std::sqrt(root), -b + std::sqrt(root)}) {
      if (t <= (i == left ? 1e-9 : 0) || (nearest && t >= *nearest)) continue;
      nearest = t;
      met = i;
      break;
    }
  }
  if (!nearest || depth > 40 || weight < 1e-9) return {};
  const Ball& ball = balls()[static_cast<std::size_t>(met)];
  if (ball.ior == 0) return ball.radiance;
  const Vec3 p = o + *nearest * d;
  Vec3 n = normalized(p - ball.center);
  double eta = ball.ior;
  if (dot(n, d) > 0) {
    n = -n;
    eta = 1 / eta;
  }
  const double c = -dot(n, d), r = reflected(c, eta), t2 = 1 - (1 - c * c) / (eta * eta);
  const Rgb back = trace(p, normalized(d + 2 * c * n), weight * r, depth + 1, met);
  Rgb sum{r * back.r, r * back.g, r * back.b};
  if (t2 <= 0) return sum;
  const Vec3 through = normalized((1 / eta) * d + (c / eta - std::sqrt(t2)) * n);
  const Rgb front = trace(p, through, weight * (1 - r), depth + 1, met);
  const double share = (1 - r) / (eta * eta);
  return {sum.r + share * front.r, sum.g + share * front.g, sum.b + share * front.b};
}

TEST_CASE("whitted is a recursive walk along both ways") {
  require_pocl();
  Scene scene = stage({});
  const int dark = black(scene);
  for (const Ball& ball : balls()) {
    Shape shape;
    shape.geometry = Sphere{ball.center, ball.radius, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    shape.material = dark;
    if (ball.ior == 0) {
      shape.radiance = ball.radiance;
    } else {
      scene.materials.push_back(glass(ball.ior));
      shape.material = static_cast<int>(scene.materials.size()) - 1;
    }
    add(scene, shape);
  }
  for (const Precision precision : asked_tiers()) {
    const Image image = color(with_integrator(scene, "whitted"), precision);
    int off = 0, mixed = 0;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const Rgb truth = trace({stage_x(x), stage_y(y), 4}, {0, 0, -1}, 1, 0, -1);
        const std::array expected{truth.r, truth.g, truth.b};
        bool is_near = true;
        for (int k = 0; k < 3; ++k) {
          const double value = static_cast<double>(image.at(x, y, k)), right = expected.at(static_cast<std::size_t>(k));
          // What carries less than 2^-20 of the light is left out on both sides, not at the same places.
          const double bound = (precision == Precision::fp64 ? 1e-4 : 2e-3) * (1 + right);
          is_near = is_near && std::fabs(value - right) < bound;
        }
        off += is_near ? 0 : 1;
        mixed += truth.r > 0 && truth.b > 0 ? 1 : 0;
      }
    INFO(precision_name(precision) << ": " << off << " pixels off");
    CHECK(mixed > stage_size * stage_size / 8);
    // Where a ray grazes or an image of a lamp ends, a rounding decides.
    CHECK(off <= (precision == Precision::fp64 ? 2 : stage_size * stage_size / 100));
  }
}

// ---- priorities --------------------------------------------------------------------------------------------------

Sphere ball(double radius, double z = 0) { return {{0, 0, z}, radius, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }

int add_glass(Scene& scene, const Geometry& geometry, double int_ior, double ext_ior, std::optional<int> priority) {
  scene.materials.push_back(glass(int_ior, ext_ior));
  Shape shape;
  shape.geometry = geometry;
  shape.material = static_cast<int>(scene.materials.size()) - 1;
  shape.priority = priority;
  return add(scene, shape);
}

/// What comes through interfaces one behind the other, upright: reflections between all of them added.
double through_layers(const std::vector<double>& indices) {
  double t = 1, r = 0;
  for (std::size_t i = 1; i < indices.size(); ++i) {
    const double one = reflected(1, indices[i] / indices[i - 1]), most = 1 / (1 - r * one);
    r = r + t * t * one * most;
    // Reflectance of what was there, from behind, is the same: nothing absorbs.
    t = t * (1 - one) * most;
  }
  return t;
}

TEST_CASE("where glass overlaps, the higher priority is there") {
  require_pocl();
  const Box upper{{-100, -100, -0.1}, {100, 100, 0.1}}, lower{{-100, -100, -0.5}, {100, 100, 0}};
  const auto picture = [&](std::optional<int> of_upper, std::optional<int> of_lower, const char* integrator,
                           Precision precision) {
    Scene scene = stage({});
    add_glass(scene, upper, 2, 1, of_upper);
    add_glass(scene, lower, 1.33, 1, of_lower);
    add_lamp(scene, lamp_below(), {1, 1, 1});
    return at_middle(color(with_integrator(scene, integrator), precision));
  };
  const double layers = through_layers({1, 2, 1.33, 1});
  for (const Precision precision : asked_tiers())
    for (const auto& [first, second] : {std::pair{2, 1}, {1, 2}, {7, 7}})
      CHECK(picture(first, second, "whitted", precision) == Approx(layers).epsilon(1e-4));
  // As written: into water as if from air, though within glass.
  CHECK(picture({}, {}, "whitted", Precision::robust) < layers - 0.02);
  CHECK(picture(1, {}, "whitted", Precision::robust) < layers - 0.02);
}

TEST_CASE("nested glass with priorities is what indices written for it are") {
  require_pocl();
  Scene written = stage({});
  add_lamp(written, Disk{{0.3, 0, -2.4}, {1, 0, 0}, {0, 1, 0}}, {1, 2, 4});
  Scene tracked = written;
  add_glass(written, ball(1.5), 1.5, 1, {});
  add_glass(written, ball(0.8, 0.2), 1.33, 1.5, {});
  add_glass(tracked, ball(1.5), 1.5, 1, 0);
  add_glass(tracked, ball(0.8, 0.2), 1.33, 1, 1);
  for (const char* integrator : {"whitted", "path"})
    for (const Precision precision : asked_tiers()) {
      const Image a = color(with_integrator(written, integrator), precision);
      const Image b = color(with_integrator(tracked, integrator), precision);
      int off = 0;
      for (std::size_t i = 0; i < a.data.size(); ++i) off += std::fabs(a.data[i] - b.data[i]) > 1e-3F ? 1 : 0;
      INFO(integrator << " " << precision_name(precision));
      CHECK(lit_pixels(a) > 300);
      CHECK(off < 30);
    }
}

TEST_CASE("two balls of one priority are one body") {
  require_pocl();
  Scene scene = stage({});
  add_glass(scene, ball(1, 0.5), 1.5, 1, 3);
  add_glass(scene, ball(1, -0.5), 1.5, 1, 3);
  add_lamp(scene, lamp_below(), {1, 1, 1});
  CHECK(at_middle(color(with_integrator(scene, "whitted"))) == Approx(through_layers({1, 1.5, 1})).epsilon(2e-3));
}

TEST_CASE("a ray within more shapes than are tracked is told") {
  require_pocl();
  for (const int shapes : {8, 9}) {
    Scene scene = stage({});
    for (int i = 0; i < shapes; ++i) add_glass(scene, ball(1.5 - 0.1 * i), 1.1 + 0.1 * i, 1, i);
    add_lamp(scene, lamp_below(), {1, 1, 1});
    // Few pixels: whitted follows both ways through all of them.
    scene.film.width = scene.film.height = 12;
    const RenderResult result = stage_picture(with_integrator(scene, "whitted"), Precision::robust);
    CHECK((result.stats.unusual.lost_interfaces > 0) == (shapes > 8));
  }
}

TEST_CASE("direct says that glass will show emitters alone") {
  Scene scene = stage({floor_plane()}, glass(1.5));
  scene.lights.push_back({"", ConstantLight{{1, 1, 1}}, {}});
  REQUIRE(limitations(scene).size() == 1);
  CHECK(limitations(scene)[0].message.find("whitted") != std::string::npos);
}

}  // namespace
}  // namespace strahl::test
