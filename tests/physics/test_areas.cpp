// SPDX-License-Identifier: MIT
// Checks every entry of cl/areas/areas.def in every tier: places lie on the surface, with its normal; they are drawn
// uniformly over the area, or over the solid angle where the row says so; the density equals the closed form. Each is
// seen from near, from far and from within. A new entry needs one row in area_rows.h.
#include "physics/area_rows.h"
#include "physics/rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::vector<std::string> area_entries = {
#define AREA(name, reals) #name,
#include "../../cl/areas/areas.def"
#undef AREA
};

Scene scene_of_area(const AreaRow& row) {
  Scene scene = empty_scene();
  scene.shapes.push_back(emitting_shape(row));
  return scene;
}

/// visit(tier, row, scene, from)
template <class Visit>
void for_each_area(Visit visit) {
  for (const AreaRow& row : area_rows())
    for (const TransportTier& tier : transport_tiers()) {
      const TierScene scene(scene_of_area(row), tier);
      for (const Vec3& from : row.froms) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry << " from " << from.x << " " << from.y << " "
                       << from.z);
        visit(tier, row, scene, from);
      }
    }
}

TEST_CASE("every area has a row") {
  hold_rows("areas.def", area_entries, area_rows(), [](const AreaRow& row) {
    const TierScene scene(scene_of_area(row), true, 1);
    REQUIRE(scene.index(layout::HEADER_LIGHT_COUNT) == 1);
    return scene.light(0, layout::LIGHT_AREA);
  });
}

TEST_CASE("places lie on the surface, with its normal and the density of the closed form") {
  const std::vector<PlaceNumbers> numbers = place_numbers(256);
  for_each_area([&](const TransportTier& tier, const AreaRow& row, const TierScene& scene, const Vec3& from) {
    const double u = roundoff(tier);
    std::size_t lit = 0;
    for (const AreaDraw& drawn : tier.places(scene.buffers(), 0, triad(from), numbers)) {
      const Vec3 place = vec(drawn.position), normal = row.normal(place), towards = place - from;
      CHECK(row.off(place) <= 16 * u * (length(place) + 1));
      CHECK(length(vec(drawn.normal) - normal) <= 16 * u);
      const double distance = length(towards), facing = -dot(towards, normal) / distance;
      // The tolerance follows the accuracy of the computed cosine.
      const double known = 64 * u * (1 + 1 / std::max(std::fabs(facing), 1e-6));
      if (row.is_by_angle(from)) {
        CHECK(drawn.density == Approx(row.is_flipped ? 0 : 1 / row.solid_angle(from)).epsilon(64 * u));
      } else if (facing > 1e-3) {
        CHECK(drawn.density == Approx(distance * distance / (row.area * facing)).epsilon(known));
      } else if (facing < -1e-3) {
        CHECK(drawn.density == 0);
      }
      lit += drawn.density > 0;
    }
    CHECK(lit > 0);
  });
}

TEST_CASE("places are drawn alike over the area, or over the solid angle") {
  static constexpr int side = 8;
  const std::vector<PlaceNumbers> numbers = place_numbers(4096);
  for_each_area([&](const TransportTier& tier, const AreaRow& row, const TierScene& scene, const Vec3& from) {
    // Distant places differ by less than the rounding of the chart.
    if (tier.lanes > 1 || length(from) * roundoff(tier) > 1e-6) return;
    std::vector<double> counts(side * side, 0);
    for (const AreaDraw& drawn : tier.places(scene.buffers(), 0, triad(from), numbers)) {
      const auto [a, b] = row.chart(from, vec(drawn.position));
      REQUIRE(std::clamp(a, -1e-3, 1 + 1e-3) == a);
      REQUIRE(std::clamp(b, -1e-3, 1 + 1e-3) == b);
      const auto cell = [](double x) { return std::clamp(static_cast<int>(x * side), 0, side - 1); };
      counts.at(static_cast<std::size_t>(cell(a) * side + cell(b))) += 1;
    }
    hold_counts(counts, std::vector<double>(side * side, 4096.0 / (side * side)));
  });
}

TEST_CASE("every width draws the places that one lane does, to the bit") {
  const std::vector<PlaceNumbers> numbers = place_numbers(35);
  std::map<std::string, TransportTier> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  for_each_area([&](const TransportTier& tier, const AreaRow&, const TierScene& scene, const Vec3& from) {
    if (tier.lanes == 1) return;
    const auto wide = tier.places(scene.buffers(), 0, triad(from), numbers),
               one = narrow.at(tier.name).places(scene.buffers(), 0, triad(from), numbers);
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(wide[i].position == one[i].position);
      CHECK(wide[i].normal == one[i].normal);
      CHECK(wide[i].density == one[i].density);
    }
  });
}

// Numbers that floats have, of emitters that pass next to the origin.
TEST_CASE("a place near the origin, on an emitter that reaches far, is off by no more than its bound") {
  struct Row {
    Geometry geometry;
    Vec3 from;
    std::function<double(const Vec3&)> off;
    double spread;  ///< Of the numbers about a half.
  };
  const Vec3 centre{-600, -640, 480}, foot{-401, -302, -197}, axis{802, 604, 396}, along = normalized(axis);
  const std::vector<Row> rows = {
      {Sphere{centre, 1000}, {3, 3.2, -2.4}, [&](const Vec3& p) { return std::fabs(length(p - centre) - 1000); }, 1},
      {Cylinder{foot, foot + axis, 0.0625, normalized(cross(axis, {0, 0, 1}))},
       {0.5, 1, -0.5},
       [&](const Vec3& p) { return std::fabs(length(cross(p - foot, along)) - 0.0625); },
       2e-3},
      {Rectangle{{-300, -400, -512}, {600, 800, 0}, {0, 0, 1024}},
       {1, -0.5, 0.25},
       [](const Vec3& p) { return std::fabs(0.8 * p.x - 0.6 * p.y); },
       2e-3}};
  for (const Row& row : rows) {
    Scene scene = empty_scene();
    scene.shapes.emplace_back().geometry = row.geometry;
    scene.shapes.back().radiance = Rgb{1, 1, 1};
    std::vector<PlaceNumbers> numbers = place_numbers(4096);
    for (PlaceNumbers& n : numbers) {
      if (row.spread == 1) continue;
      n.v = 0.5 + row.spread * (n.v - 0.5);
      if (std::holds_alternative<Rectangle>(row.geometry)) n.u = 0.5 + row.spread * (n.u - 0.5);
    }
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << row.geometry.index());
      const TierScene packed(scene, tier);
      double worst = 0;
      for (const AreaDraw& drawn : tier.places(packed.buffers(), 0, triad(row.from), numbers))
        worst = std::max(worst, row.off(vec(drawn.position)) / drawn.bound);
      CHECK(worst < 1);
    }
  }
}

}  // namespace
