// SPDX-License-Identifier: MIT
// Checks every entry of cl/lights/lights.def in every tier. Directions are drawn with the density that a ray which hits
// the light reads (chi^2); the integral of that density is the share of draws; both techniques see the same radiance,
// and their mean is the light's fluence in closed form. A light of one direction is a delta and nothing else. Rays
// beside a light do not see it. A new entry is tested with its defaults, and in closed form once it has a row in
// `closed_forms`; lights with an area are tested for every row of area_rows.h.
#include "kinds/lights.h"
#include "physics/area_rows.h"
#include "physics/environment_rows.h"
#include "physics/rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct LightRow {
  std::string entry;  ///< Of lights.def.
  std::string what;
  std::function<void(Scene&)> put;
  bool is_delta;
  std::vector<Vec3> froms;
  /// The fluence from all directions in the first channel; the others have a half and a quarter of it. May be empty.
  std::function<double(const Vec3& from)> fluence;
  /// How much a rounding of the direction changes, as a share of the most.
  double blur = 0;
};

template <class Emitter>
std::function<void(Scene&)> put_lamp(const Emitter& emitter) {
  return [=](Scene& scene) { scene.lights.emplace_back().emitter = emitter; };
}

/// Only integrators whose paths begin on lights have beams.
std::function<void(Scene&)> put_beam(const CollimatedLight& beam) {
  return [=](Scene& scene) {
    scene.integrator.name = "ptracer";
    scene.lights.emplace_back().emitter = beam;
  };
}

void put_shining_disk(Scene& scene) {
  scene.integrator.name = "ptracer";
  scene.shapes.emplace_back().geometry = Disk{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.shapes.back().exitance = Rgb{2, 1, 0.5};
}

std::vector<LightRow> closed_forms() {
  const std::vector<Vec3> froms = {{0, 0, 0}, {3, -1, 2}, {1000, 0, -2000}};
  const Vec3 lamp{1, 2, 3}, axis{-1, -2, -3};
  const auto falloff = [=](const Vec3& from, double cutoff, double beam) {
    const double degrees = std::acos(dot(normalized(from - lamp), normalized(axis))) * 180 / std::numbers::pi;
    if (degrees >= cutoff) return 0.0;
    return degrees <= beam ? 1.0 : (cutoff - degrees) / (cutoff - beam);
  };
  const ProjectorLight projector{lamp,
                                 {normalized(Vec3{-2, 1, 0}), normalized(Vec3{3, 6, -5}), normalized(Vec3{-1, -2, -3})},
                                 1.5,
                                 0.5,
                                 {2, 1, 0.5}};
  const auto on_screen = [=](const Vec3& from) {
    const Vec3 way = from - lamp;
    const double z = dot(way, projector.axes[2]), x = dot(way, projector.axes[0]) / z;
    const bool is_lit = z > 0 && std::fabs(x) < 1.5 && std::fabs(dot(way, projector.axes[1]) / z) < 0.5;
    return is_lit ? 2 * std::numbers::pi * length(way) / (z * z * z) : 0;
  };
  std::vector<LightRow> rows = {
      {"point", "", put_lamp(PointLight{lamp, {2, 1, 0.5}}), true, froms,
       [=](const Vec3& from) { return 2 / dot(lamp - from, lamp - from); }},
      {"spot", "of a soft edge", put_lamp(SpotLight{lamp, 3.0 * axis, {2, 1, 0.5}, 100, 10}), true, froms,
       [=](const Vec3& from) { return 2 * falloff(from, 100, 10) / dot(lamp - from, lamp - from); }},
      {"spot", "of a hard edge", put_lamp(SpotLight{lamp, axis, {2, 1, 0.5}, 55, 55}), true, froms,
       [=](const Vec3& from) { return 2 * falloff(from, 55, 55) / dot(lamp - from, lamp - from); }},
      {"projector", "", put_lamp(projector), true, froms, on_screen},
      {"directional", "", put_lamp(DirectionalLight{{1, -2, 0.5}, {2, 1, 0.5}}), true, froms,
       [](const Vec3&) { return 2; }},
      {"collimated", "", put_beam(CollimatedLight{lamp, axis, {2, 1, 0.5}}), true, froms,
       [](const Vec3&) { return 0; }},
      {"directionalarea", "", put_shining_disk, true, {{3, -1, 2}, {-5, 7, 1}}, [](const Vec3&) { return 0; }},
      {"sun", "", put_lamp(SunLight{{2, -1, 3}, 8, {2, 1, 0.5}}), false, froms,
       [](const Vec3&) { return 4 * std::numbers::pi * (1 - std::cos(std::numbers::pi / 45)); }},
      {"constant", "", put_lamp(ConstantLight{{2, 1, 0.5}}), false, froms,
       [](const Vec3&) { return 8 * std::numbers::pi; }},
  };
  for (const EnvironmentRow& row : smooth_environments())
    rows.push_back(
        {"envmap", row.what, put_lamp(row.light), false, froms, [=](const Vec3&) { return fluence(row.light); }, 1e-5});
  for (const AreaRow& row : area_rows())
    rows.push_back({"area", row.entry, [=](Scene& scene) { scene.shapes.push_back(emitting_shape(row)); }, false,
                    row.froms, [=](const Vec3& from) { return 2 * row.solid_angle(from); }});
  return rows;
}

/// Appends the emitters of scenes that are not shapes and have no row yet.
template <std::size_t alternative = 0>
void add_defaults(std::vector<LightRow>& rows) {
  using AnyEmitter = decltype(Light::emitter);
  if constexpr (alternative < std::variant_size_v<AnyEmitter>) {
    Light light;
    light.emitter = std::variant_alternative_t<alternative, AnyEmitter>{};
    const kinds::LightFacts& facts = kinds::light(light);
    const bool is_known =
        std::any_of(rows.begin(), rows.end(), [&](const LightRow& row) { return row.entry == facts.entry; });
    if (!is_known)
      rows.push_back({facts.entry,
                      "by default",
                      [=](Scene& scene) { scene.lights.push_back(light); },
                      facts.is_delta,
                      {{3, -1, 2}, {-5, 7, 1}},
                      {}});
    add_defaults<alternative + 1>(rows);
  }
}

std::vector<LightRow> light_rows() {
  std::vector<LightRow> rows = closed_forms();
  add_defaults(rows);
  return rows;
}

const std::vector<std::string> light_entries = {
#define LIGHT(name) #name,
#define DELTA_LIGHT LIGHT
#include "../../cl/lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
};

Scene scene_of_light(const LightRow& row) {
  Scene scene = empty_scene();
  row.put(scene);
  return scene;
}

/// visit(tier, row, scene, from)
template <class Visit>
void for_each_light(Visit visit) {
  for (const LightRow& row : light_rows())
    for (const TransportTier& tier : transport_tiers()) {
      const TierScene scene(scene_of_light(row), tier);
      for (const Vec3& from : row.froms) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry << " " << row.what << " from " << from.x << " "
                       << from.y << " " << from.z);
        visit(tier, row, scene, from);
      }
    }
}

bool is_lit(const LightDraw& drawn) { return drawn.radiance[0] > 0; }

std::vector<Vec3> lit_directions(const std::vector<LightDraw>& drawn) {
  std::vector<Vec3> directions;
  for (const LightDraw& one : drawn)
    if (is_lit(one)) directions.push_back(normalized(vec(one.towards)));
  return directions;
}

/// Cells of equal solid angle of a cone around directions.
class Cone {
 public:
  static constexpr int rings = 6, sectors = 12, within = 12;

  explicit Cone(const std::vector<Vec3>& directions) {
    Vec3 sum{};
    for (const Vec3& d : directions) sum = sum + d;
    axis_ = normalized(sum);
    across_ = orthonormal_basis(axis_);
    for (const Vec3& d : directions) less_ = std::max(less_, less(d));
    less_ = less_ > 1 ? 2 : 1.1 * less_;
  }
  /// The cell, each with `parts` x `parts` cells of its own.
  [[nodiscard]] std::size_t cell(const Vec3& d) const {
    const int ring = std::min(static_cast<int>(less(d) / less_ * rings), rings - 1);
    const int sector =
        std::min(static_cast<int>(turn_of(dot(d, across_[0]), dot(d, across_[1])) * sectors), sectors - 1);
    return static_cast<std::size_t>(ring * sectors + sector);
  }
  [[nodiscard]] std::vector<Triad> middles() const {
    std::vector<Triad> all;
    for (int i = 0; i < rings * within; ++i)
      for (int j = 0; j < sectors * within; ++j) {
        const double l = less_ * (i + 0.5) / (rings * within), sine = std::sqrt(l * (2 - l));
        const double turn = 2 * std::numbers::pi * (j + 0.5) / (sectors * within);
        all.push_back(triad((1 - l) * axis_ + sine * std::cos(turn) * across_[0] + sine * std::sin(turn) * across_[1]));
      }
    return all;
  }
  [[nodiscard]] double solid_angle() const { return 2 * std::numbers::pi * less_; }

 private:
  /// 1 - cos, from the chord.
  [[nodiscard]] double less(const Vec3& d) const { return 0.5 * dot(d - axis_, d - axis_); }

  Vec3 axis_;
  std::array<Vec3, 2> across_;
  double less_ = 0;
};

TEST_CASE("every light has a row") {
  hold_rows("lights.def", light_entries, light_rows(), [](const LightRow& row) {
    const TierScene scene(scene_of_light(row), true, 1);
    // Drawn, or behind those that are.
    REQUIRE(std::max(scene.index(layout::HEADER_LIGHT_COUNT), scene.index(layout::HEADER_BACKGROUND) + 1) == 1);
    return scene.light(0, layout::LIGHT_KIND);
  });
}

TEST_CASE("directions are drawn as densely as rays that find the light are told") {
  const std::vector<PlaceNumbers> numbers = place_numbers(4000);
  for_each_light([&](const TransportTier& tier, const LightRow& row, const TierScene& scene, const Vec3& from) {
    if (row.is_delta || tier.lanes > 1) return;
    const std::vector<Vec3> directions = lit_directions(tier.draw(scene.buffers(), {0}, triad(from), numbers));
    REQUIRE(directions.size() > numbers.size() / 4);
    const Cone cone(directions);
    std::vector<double> counts(Cone::rings * Cone::sectors, 0), expected(counts.size(), 0);
    for (const Vec3& d : directions) counts.at(cone.cell(d)) += 1;
    const std::vector<Triad> middles = cone.middles();
    const std::vector<Sight> seen = tier.look(scene.buffers(), triad(from), middles);
    const double n = static_cast<double>(numbers.size());
    double whole = 0, beside = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i].light < 0) beside += seen[i].radiance[0];
      const double share = seen[i].density * cone.solid_angle() / static_cast<double>(seen.size());
      expected.at(cone.cell(vec(middles[i]))) += share * n;
      whole += share;
    }
    CHECK(beside == 0);
    const double drawn = static_cast<double>(directions.size()) / n;
    CHECK(whole == Approx(drawn).margin(0.01 + 5 * std::sqrt(drawn * (1 - drawn) / n)));
    // Not for distant lights, where rounding moves a place by as much as a cell.
    if (length(from) * roundoff(tier) < 1e-6) hold_counts(counts, expected);
  });
}

TEST_CASE("what draws a light and what finds it see the same radiance at the same density") {
  const std::vector<PlaceNumbers> numbers = place_numbers(500);
  for_each_light([&](const TransportTier& tier, const LightRow& row, const TierScene& scene, const Vec3& from) {
    if (row.is_delta) return;
    const std::vector<LightDraw> all = tier.draw(scene.buffers(), {0}, triad(from), numbers);
    std::vector<LightDraw> drawn;
    std::vector<Triad> directions;
    for (const LightDraw& one : all) {
      CHECK_FALSE(one.is_delta);
      if (!is_lit(one)) continue;
      CHECK(one.density > 0);
      drawn.push_back(one);
      directions.push_back(triad(normalized(vec(one.towards))));
    }
    const std::vector<Sight> seen = tier.look(scene.buffers(), triad(from), directions);
    int missed = 0;
    double most = 0, densest = 0;
    for (const LightDraw& one : drawn) {
      most = std::max(most, one.radiance[0]);
      densest = std::max(densest, one.density);
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      // Rounding sometimes moves a place past an edge, or onto the back there.
      if (seen[i].light != 0 || seen[i].radiance[0] == 0) {
        ++missed;
        continue;
      }
      if (row.blur == 0) CHECK(seen[i].radiance == drawn[i].radiance);
      CHECK(seen[i].radiance[0] == Approx(drawn[i].radiance[0]).epsilon(0).margin(row.blur * most));
      const double far_off = 1 + length(from) / 4;
      CHECK(seen[i].density ==
            Approx(drawn[i].density).epsilon(2000 * roundoff(tier) * far_off).margin(row.blur * densest));
    }
    CHECK(missed <= static_cast<int>(seen.size()) / 50);
  });
}

TEST_CASE("drawn radiance over its density is the light's fluence") {
  const std::vector<PlaceNumbers> numbers = place_numbers(4000);
  for_each_light([&](const TransportTier& tier, const LightRow& row, const TierScene& scene, const Vec3& from) {
    if (!row.fluence) return;
    std::vector<double> shares;
    for (const LightDraw& one : tier.draw(scene.buffers(), {0}, triad(from), numbers)) {
      shares.push_back(is_lit(one) ? one.radiance[0] / one.density : 0);
      // The colour is the light's.
      CHECK(one.radiance[1] == Approx(one.radiance[0] / 2).epsilon(4 * roundoff(tier)));
      CHECK(one.radiance[2] == Approx(one.radiance[0] / 4).epsilon(4 * roundoff(tier)));
    }
    const Mean mean = mean_of(shares);
    const double fluence = row.fluence(from);
    CHECK(mean.value == Approx(fluence).margin(5 * mean.noise + 64 * roundoff(tier) * fluence));
  });
}

TEST_CASE("a light of one direction is a delta, which no ray finds") {
  const std::vector<PlaceNumbers> numbers = place_numbers(16);
  for_each_light([&](const TransportTier& tier, const LightRow& row, const TierScene& scene, const Vec3& from) {
    const std::vector<LightDraw> drawn = tier.draw(scene.buffers(), {0}, triad(from), numbers);
    for (const LightDraw& one : drawn) CHECK(one.is_delta == row.is_delta);
    if (!row.is_delta) return;
    for (const LightDraw& one : drawn) {
      CHECK(one.density == 1);
      CHECK(one.towards == drawn.front().towards);
    }
    CHECK(tier.density(scene.buffers(), 0, triad(from), drawn.front().towards) == 0);
    for (const Triad& towards : {drawn.front().towards, Triad{1, 0, 0}, Triad{0, -1, 0}}) {
      const Sight seen = tier.look(scene.buffers(), triad(from), {towards}).front();
      CHECK(seen.light == -1);
      CHECK(seen.radiance == Triad{0, 0, 0});
    }
  });
}

TEST_CASE("every width draws and finds lights as one lane does, to the bit") {
  const std::vector<PlaceNumbers> numbers = place_numbers(35);
  std::map<std::string, TransportTier> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  for_each_light([&](const TransportTier& tier, const LightRow& row, const TierScene& scene, const Vec3& from) {
    if (tier.lanes == 1) return;
    const TransportTier& one = narrow.at(tier.name);
    const TierScene narrow_scene(scene_of_light(row), one);
    const auto wide = tier.draw(scene.buffers(), {0}, triad(from), numbers),
               drawn = one.draw(narrow_scene.buffers(), {0}, triad(from), numbers);
    std::vector<Triad> directions;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      check_same(wide[i], drawn[i]);
      directions.push_back(drawn[i].towards);
    }
    const auto wide_seen = tier.look(scene.buffers(), triad(from), directions),
               seen = one.look(narrow_scene.buffers(), triad(from), directions);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      CHECK(wide_seen[i].light == seen[i].light);
      CHECK(wide_seen[i].radiance == seen[i].radiance);
      if (seen[i].light >= 0) CHECK(wide_seen[i].density == seen[i].density);
    }
  });
}

}  // namespace
