// SPDX-License-Identifier: MIT
// What test_lights.cpp does not ask of environments: densities over the cells of the image itself, so also of a sun and
// at the poles; that densities integrate to 1; MIS compensation; where texels lie; the angle in lanes.
#include "kinds/lights.h"
#include "physics/environment_rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;
using std::numbers::pi;

namespace {

/// A sky of 1 with a sun of 10^5 in one texel.
EnvironmentLight sun_and_sky() {
  std::vector<float> values(32 * 17, 1);
  values[5 * 32 + 11] = 100000;
  return environment_of(32, 17, values);
}

std::vector<EnvironmentRow> all_environments() {
  std::vector<EnvironmentRow> rows = smooth_environments();
  rows.push_back({"with a sun", sun_and_sky()});
  rows.push_back({"with a bright pole", bright_texel(8, 5, 2, 0)});
  rows.push_back({"with a bright lower pole", bright_texel(8, 5, 7, 4)});
  EnvironmentLight compensated = noisy_environment(12, 7);
  compensated.mis_compensation = true;
  rows.push_back({"compensated", compensated});
  return rows;
}

Scene scene_with(const EnvironmentLight& light) {
  Scene scene = empty_scene();
  scene.lights.emplace_back().emitter = light;
  return scene;
}

/// As Mitsuba has it: x = sin phi sin theta, y = cos theta, z = -cos phi sin theta.
Vec3 direction(const EnvironmentLight& light, double u, double v) {
  const double phi = 2 * pi * u, theta = pi * v, sine = std::sin(theta);
  return sine * std::sin(phi) * light.axes[0] + std::cos(theta) * light.axes[1] - sine * std::cos(phi) * light.axes[2];
}

template <class Visit>
void for_each_environment(const std::vector<EnvironmentRow>& rows, Visit visit) {
  for (const EnvironmentRow& row : rows)
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes > 1) continue;  // The same bits: test_lights.cpp.
      INFO(tier.name << ", an environment " << row.what);
      visit(tier, row.light, TierScene(scene_with(row.light), tier));
    }
}

/// Density at the middles of `parts` x `parts` squares of every cell, each with its solid angle.
struct Grid {
  static constexpr int parts = 8;
  std::vector<Triad> directions;
  std::vector<double> solid_angles;
  std::vector<std::size_t> cells;

  explicit Grid(const EnvironmentLight& light) {
    const int width = light.texels->width, rows = light.texels->height - 1;
    for (int row = 0; row < rows * parts; ++row)
      for (int column = 0; column < width * parts; ++column) {
        const double u = ((column + 0.5) / parts + 0.5) / width, v = (row + 0.5) / (rows * parts);
        directions.push_back(triad(direction(light, u, v)));
        const double step = pi / (rows * parts);
        solid_angles.push_back(2 * pi / (width * parts) * 2 * std::sin(pi * v) * std::sin(step / 2));
        cells.push_back(static_cast<std::size_t>((row / parts) * width + column / parts));
      }
  }
};

std::size_t cell_of(const EnvironmentLight& light, const Vec3& d) {
  const int width = light.texels->width, rows = light.texels->height - 1;
  const double turn = std::atan2(dot(d, light.axes[0]), -dot(d, light.axes[2])) / (2 * pi);
  const double column = (turn - std::floor(turn)) * width - 0.5;
  const double line = std::acos(std::clamp(dot(d, light.axes[1]), -1.0, 1.0)) / pi * rows;
  const int at = (static_cast<int>(std::floor(column)) + width) % width;
  return static_cast<std::size_t>(std::min(static_cast<int>(line), rows - 1) * width + at);
}

TEST_CASE("an environment is drawn by its density, cell by cell, and the density integrates to 1") {
  const std::vector<PlaceNumbers> numbers = place_numbers(40000);
  for_each_environment(
      all_environments(), [&](const TransportTier& tier, const EnvironmentLight& light, const TierScene& scene) {
        const Grid grid(light);
        const std::vector<Sight> seen = tier.look(scene.buffers(), {0, 0, 0}, grid.directions);
        std::vector<double> expected(light.texels->count() - static_cast<std::size_t>(light.texels->width), 0);
        double whole = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
          const double share = seen[i].density * grid.solid_angles[i];
          expected[grid.cells[i]] += share * static_cast<double>(numbers.size());
          whole += share;
        }
        CHECK(whole == Approx(1).epsilon(1e-3));
        std::vector<double> counts(expected.size(), 0);
        for (const LightDraw& one : tier.draw(scene.buffers(), {0}, {0, 0, 0}, numbers))
          if (one.radiance[0] > 0) counts[cell_of(light, normalized(vec(one.towards)))] += 1;
        hold_counts(counts, expected);
      });
}

TEST_CASE("radiance over density varies by no more than the angle's sine within a row of cells") {
  const std::vector<PlaceNumbers> numbers = place_numbers(4000);
  std::vector<EnvironmentRow> rows = all_environments();
  rows.pop_back();  // Compensation leaves light to the other technique.
  for_each_environment(rows, [&](const TransportTier& tier, const EnvironmentLight& light, const TierScene& scene) {
    // Twice the sine at the row's middle, at the edge of a pole's row, over two thirds of it, its mean where the pole
    // is bright.
    const double most = 3.1 * fluence(light);
    double sum = 0, squares = 0;
    for (const LightDraw& one : tier.draw(scene.buffers(), {0}, {0, 0, 0}, numbers)) {
      const double share = one.radiance[0] / one.density;
      CHECK(share <= most);
      sum += share;
      squares += share * share;
    }
    const double n = static_cast<double>(numbers.size()), mean = sum / n;
    CHECK(mean == Approx(fluence(light)).margin(5 * std::sqrt((squares / n - mean * mean) / n) + 1e-5 * mean));
  });
}

TEST_CASE("MIS compensation draws what exceeds the mean, where the material's directions find the rest") {
  EnvironmentLight light = noisy_environment(12, 7);
  Material material;
  const auto densities = [&](const std::string& integrator, bool is_compensated) {
    light.mis_compensation = is_compensated;
    Scene scene = scene_with(light);
    scene.materials.push_back(material);
    scene.integrator.name = integrator;
    const TransportTier tier = transport_double().front();
    std::vector<double> found;
    const TierScene packed(scene, tier);
    for (const Sight& one : tier.look(packed.buffers(), {0, 0, 0}, Grid(light).directions))
      found.push_back(one.density);
    return found;
  };
  const auto zeros = [](const std::vector<double>& all) { return std::count(all.begin(), all.end(), 0.0); };
  CHECK(zeros(densities("path", false)) == 0);
  CHECK(zeros(densities("path", true)) > 50);
  CHECK(zeros(densities("direct", true)) > 50);
  CHECK(densities("whitted", true) == densities("whitted", false));
  // Those of this one would find none of what its base reflects.
  material.bsdf = Principled{.diffuse_reflectance_sampling_rate = 0};
  CHECK(densities("path", true) == densities("path", false));
  material = {};
  // All as bright as the mean: nothing would be left to draw.
  light = environment_of(4, 3, std::vector<float>(12, 0.5F));
  CHECK(densities("path", true) == densities("path", false));
}

TEST_CASE("an environment is as likely among other lights as it is bright, wherever that is") {
  for (const EnvironmentRow& row : all_environments()) {
    INFO(row.what);
    const double mean = luminance({1, 0.5, 0.25}) * fluence(row.light) / (4 * pi);
    const double power = kinds::light_reach({{}, row.light, {}}, UploadFrame{}).power;
    CHECK(power / pi > 0.6 * mean);
    CHECK(power / pi < 1.7 * mean);
  }
}

TEST_CASE("texels lie where Mitsuba has them") {
  for_each_environment({{"of noise", noisy_environment(6, 5)}, {"turned", turned(noisy_environment(6, 5), true)}},
                       [&](const TransportTier& tier, const EnvironmentLight& light, const TierScene& scene) {
                         const TexelDecoder decoded(*light.texels, light.curve);
                         std::vector<Triad> directions;
                         for (int row = 0; row < 5; ++row)
                           for (int column = 0; column < 6; ++column)
                             directions.push_back(triad(direction(light, (column + 0.5) / 6, row / 4.0)));
                         const std::vector<Sight> seen = tier.look(scene.buffers(), {0, 0, 0}, directions);
                         // At a pole every column is met at once.
                         for (std::size_t n = 6; n < 24; ++n)
                           CHECK(seen[n].radiance[0] == Approx(decoded(n)[0]).epsilon(1e-5));
                       });
}

TEST_CASE("one bright texel lights as a directional light of its fluence") {
  // Far finer than the cosine varies.
  const EnvironmentLight light = bright_texel(2048, 1025, 700, 300, 1000);
  const Vec3 towards = direction(light, 700.5 / 2048, 300.0 / 1024);
  const TransportTier tier = transport_double().front();
  const TierScene scene(scene_with(light), tier);
  const Vec3 normal = normalized(Vec3{0.3, 1, -0.2});
  double sum = 0;
  const std::vector<PlaceNumbers> numbers = place_numbers(2000);
  for (const LightDraw& one : tier.draw(scene.buffers(), {0}, {0, 0, 0}, numbers))
    sum += one.radiance[0] / one.density * dot(vec(one.towards), normal);
  const double irradiance = fluence(light) * dot(towards, normal);
  CHECK(sum / static_cast<double>(numbers.size()) == Approx(irradiance).epsilon(1e-4));
}

TEST_CASE("angles in lanes have the bits of angles alone") {
  std::vector<TexturePlace> vectors = {{0, 0, 0}, {1, 0, 0},  {-1, 0, 0},       {0, 1, 0},         {0, -1, 0},
                                       {1, 1, 0}, {-1, 1, 0}, {1e38, -1e38, 0}, {1e-30, 1e-31, 0}, {1, -1e-12, 0}};
  std::mt19937_64 engine(4);
  for (int i = 0; i < 3000; ++i) vectors.push_back({unit_number(engine) - 0.5, unit_number(engine) - 0.5, 0});
  for (const TransportTier& tier : transport_tiers()) {
    if (std::string(tier.name) == "fast") continue;  // Which contracts as it likes.
    INFO(tier.name << ", " << tier.lanes << " lanes");
    CHECK(tier.angles(vectors) == tier.angles_alone(vectors));
  }
}

}  // namespace
