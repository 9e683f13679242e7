// SPDX-License-Identifier: MIT
// An instance's box: it holds all that its group holds, and is no larger than that takes, however the group is turned;
// the outline that it comes from holds every box in few.
#include <catch2/catch.hpp>
#include <cmath>

#include "errors.h"
#include "kinds/extent.h"
#include "oracle/random.h"
#include "packing/outline.h"
#include "packing/pack_instances.h"
#include "scene/model/transforms.h"

using namespace strahl;

namespace {

/// Small boxes all over an ellipsoid.
template <typename Real>
std::vector<Bounds<Real>> ellipsoid(std::size_t count, oracle::Random& random) {
  std::vector<Bounds<Real>> boxes;
  while (boxes.size() < count) {
    Vec3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (dot(p, p) > 1 || dot(p, p) < 1e-4) continue;
    p = (1 / length(p)) * p;
    p = {3 + p.x, 2 * p.y, 0.4 * p.z};
    const Vec3 half{0.02, 0.02, 0.02};
    boxes.push_back(rounded_outwards<Real>(p - half, p + half));
  }
  return boxes;
}

Transform random_map(oracle::Random& random) {
  Transform map;
  for (auto& row : map.m)
    for (double& x : row) x = random.uniform(-2, 2);
  return map;
}

Transform scaling(const Vec3& by) {
  Transform map;
  map.m[0][0] = by.x;
  map.m[1][1] = by.y;
  map.m[2][2] = by.z;
  return map;
}

Vec3 corner(const Bounds<float>& box, unsigned i) {
  return {double(box[i & 1U]), double(box[2 + (i >> 1U & 1U)]), double(box[4 + (i >> 2U & 1U)])};
}

double area(const Vec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

}  // namespace

TEST_CASE("an instance's box holds its group and little else, however it is placed") {
  oracle::Random random(9);
  const std::vector<Bounds<float>> boxes = ellipsoid<float>(20000, random);
  Bounds<float> all = empty_bounds<float>();
  for (const Bounds<float>& box : boxes) include(all, box);
  double loose = 0, tight = 0, least = 0;
  for (int i = 0; i < 30; ++i) {
    const Transform map = random_map(random);
    kinds::Extent truth;
    for (const Bounds<float>& box : boxes)
      for (unsigned k = 0; k < 8; ++k) truth.add(map.point(corner(box, k)));
    const auto area_of = [&](const std::vector<Bounds<float>>& outline) {
      const InstanceReals<float> reals = instance_reals<float>(map, all, outline);
      const float* box = &reals[layout::INSTANCE_BOX];
      const Vec3 lo{box[0], box[2], box[4]}, hi{box[1], box[3], box[5]};
      CHECK((lo.x <= truth.box()->min.x && lo.y <= truth.box()->min.y && lo.z <= truth.box()->min.z));
      CHECK((hi.x >= truth.box()->max.x && hi.y >= truth.box()->max.y && hi.z >= truth.box()->max.z));
      return area(hi - lo);
    };
    least += area(truth.box()->max - truth.box()->min);
    tight += area_of(outline(boxes, outline_size(1000)));
    loose += area_of({});
  }
  CHECK(tight <= 1.06 * least);
  CHECK(loose >= 1.3 * least);
}

TEST_CASE("an outline holds every box in few, and is the same in any order") {
  oracle::Random random(10);
  std::vector<Bounds<double>> boxes = ellipsoid<double>(5000, random);
  for (const std::size_t most : {outline_size(1000000), outline_size(10000)}) {
    const std::vector<Bounds<double>> few = outline(boxes, most);
    CHECK(few.size() <= std::max<std::size_t>(2 * 2 * 2, 2 * most));
    std::size_t held = 0;
    for (const Bounds<double>& box : boxes)
      held += std::any_of(few.begin(), few.end(), [&](Bounds<double> around) {
        const Bounds<double> before = around;
        include(around, box);
        return around == before;
      });
    CHECK(held == boxes.size());
    std::reverse(boxes.begin(), boxes.end());
    CHECK(outline(boxes, most) == few);
  }
  CHECK(outline<double>({}, 4).empty());
  // All middles in one place; and boxes without a size.
  CHECK(outline(std::vector<Bounds<double>>(100, {1, 1, 2, 2, 3, 3}), 4) ==
        std::vector<Bounds<double>>{{1, 1, 2, 2, 3, 3}});
}

TEST_CASE("an instance whose inverse is not held in its bits is refused where it stands") {
  const Bounds<float> box{-1, 1, -1, 1, -1, 1};
  const Bounds<double> wide{-1, 1, -1, 1, -1, 1};
  const Transform turn = rotation({1, 0, 0}, 45);
  for (const double flat : {1e-5, 1e-9, 1e-12}) {
    const Transform map = turn * scaling({1, 1, flat}) * turn.inverse();
    INFO(flat);
    CHECK_NOTHROW(instance_reals<double>(map, wide, {}));
    if (flat > 1e-6)
      CHECK_NOTHROW(instance_reals<float>(map, box, {}));
    else
      CHECK_THROWS_AS(instance_reals<float>(map, box, {}), SceneError);
  }
  // Flat along an axis, before or after a turn: its numbers are held one by one.
  for (const Transform& map : {turn * scaling({1, 1, 1e-12}), scaling({1, 1, 1e-12}) * turn})
    CHECK_NOTHROW(instance_reals<float>(map, box, {}));
  CHECK_THROWS_AS(instance_reals<float>(scaling({1e-45, 1e-45, 1e-45}), box, {}), SceneError);
  CHECK_NOTHROW(instance_reals<float>(scaling({1e-30, 1e-30, 1e-30}), box, {}));
}
