// SPDX-License-Identifier: MIT
// Boxes, seen at their faces, edges and corners, along their faces, and from inside.
#include <array>
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

using Triple = std::array<double, 3>;

struct Drawn {
  Question q;
  Triple lo, hi;
};

/// Edges of up to `size`, the first `flat` of them 0.
Drawn draw_box(Draft& draft) {
  const double size = draft.size("size", 1);
  const int flat = draft.whole("flat", 0), turn = draft.random.integer(0, 2);
  const Vec3 place = draft.place();
  Drawn box{question_about("box"), {place.x, place.y, place.z}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_flat = (static_cast<int>(i) + turn) % 3 < flat;
    box.hi[i] = is_flat ? box.lo[i] : to_float(box.lo[i] + size * draft.random.uniform(0.1, 1));
    put(box.q, box.lo[i]);
    put(box.q, box.hi[i]);
  }
  return box;
}

/// From `distance` sizes away (0: from within) at a point on `borders` of the box's faces: 0 inside, 3 a corner.
Question seen(Draft& draft) {
  Drawn box = draw_box(draft);
  const int borders = draft.whole("borders", 0), turn = draft.random.integer(0, 2);
  const double distance = draft.size("distance", 10) * draft.size("size", 1);
  const auto point = [&](int fixed) {
    Triple p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_fixed = (static_cast<int>(i) + turn) % 3 < fixed;
      const double share = is_fixed ? draft.random.integer(0, 1) : draft.random.uniform(0.01, 0.99);
      p[i] = box.lo[i] + share * (box.hi[i] - box.lo[i]);
    }
    return Vec3{p[0], p[1], p[2]};
  };
  const Vec3 target = point(borders), d = draft.direction();
  const Vec3 origin = distance > 0 ? target - distance * d : point(0);
  aim(box.q, origin, draft.scaled(d));
  return box.q;
}

/// In a face, or (with `outside` ulps) beside it: one component of the direction a zero of either sign.
Question along_face(Draft& draft) {
  Drawn box = draw_box(draft);
  const auto axis = static_cast<std::size_t>(draft.random.integer(0, 2));
  const bool is_high = draft.random.integer(0, 1) == 1;
  Vec3 d = draft.direction();
  Triple o{}, v{d.x, d.y, d.z};
  for (std::size_t i = 0; i < 3; ++i)
    o[i] = box.lo[i] + draft.random.uniform(0.1, 0.9) * (box.hi[i] - box.lo[i]) - 10 * draft.size("size", 1) * v[i];
  o[axis] = is_high ? box.hi[axis] : box.lo[axis];
  for (int i = draft.whole("outside", 0); i > 0; --i)
    o[axis] = std::nextafterf(static_cast<float>(o[axis]), is_high ? INFINITY : -INFINITY);
  v[axis] = draft.random.sign() * 0.0;
  aim(box.q, {o[0], o[1], o[2]}, {v[0], v[1], v[2]});
  return box.q;
}

void put_box(Question& q, const Vec3& lo, const Vec3& hi) {
  for (const double x : {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z}) put(q, x);
}

/// Copies of one box.
Question copies(Draft& draft) {
  const Drawn box = draw_box(draft);
  Question q = question_about("box");
  for (int i = draft.whole("boxes", 100); i > 0; --i)
    q.planes.insert(q.planes.end(), box.q.planes.begin(), box.q.planes.end());
  const Vec3 d = draft.direction(),
             middle{(box.lo[0] + box.hi[0]) / 2, (box.lo[1] + box.hi[1]) / 2, (box.lo[2] + box.hi[2]) / 2};
  aim(q, middle - 10 * d, d);
  return q;
}

/// Boxes around one point, from 1 to 2, in any order; from within all of them or from outside.
Question nested(Draft& draft) {
  const int count = draft.whole("boxes", 64), turn = draft.random.integer(0, count - 1);
  Question q = question_about("box");
  for (int i = 0; i < count; ++i) {
    const double half = 1 + static_cast<double>((7 * i + turn) % count) / count;
    put_box(q, {-half, -half, -half}, {half, half, half});
  }
  const Vec3 d = draft.direction();
  aim(q, -(draft.index % 2 == 0 ? 0.5 : 8.0) * d, d);
  return q;
}

/// [2^i, 2^i + 2^(i - 1)] in every axis, i from -30 on.
Question doubling(Draft& draft) {
  Question q = question_about("box");
  const int count = draft.whole("boxes", 60);
  for (int i = 0; i < count; ++i) {
    const double lo = std::ldexp(1.0, i - 30), hi = 1.5 * lo;
    put_box(q, {lo, lo, lo}, {hi, hi, hi});
  }
  const double lo = std::ldexp(1.0, draft.random.integer(0, count - 1) - 30);
  const auto within = [&] { return lo * draft.random.uniform(1.05, 1.45); };
  const Vec3 target{within(), within(), within()};
  const Vec3 origin = draft.index % 2 == 0 ? Vec3{0, 0, 0} : target + 3 * lo * draft.direction();
  aim(q, origin, normalized(target - origin));
  return q;
}

/// A grid of cubes half as wide as their spacing; rays along an axis, through their middles or along their faces.
Question grid(Draft& draft) {
  const int n = draft.whole("cells", 6);
  Question q = question_about("box");
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) put_box(q, {1.0 * i, 1.0 * j, 1.0 * k}, {i + 0.5, j + 0.5, k + 0.5});
  const auto axis = static_cast<std::size_t>(draft.random.integer(0, 2));
  const bool is_forward = draft.random.integer(0, 1) == 1;
  Triple o{}, d{};
  for (std::size_t i = 0; i < 3; ++i) {
    o[i] = draft.random.integer(0, n - 1) + 0.25 * draft.random.integer(0, 3);
    d[i] = draft.random.sign() * 0.0;
  }
  o[axis] = is_forward ? -1 : n + 1;
  d[axis] = is_forward ? 1 : -1;
  aim(q, {o[0], o[1], o[2]}, {d[0], d[1], d[2]});
  return q;
}

}  // namespace

const std::vector<Generator> box_generators = {{"box_seen", seen},         {"box_along_face", along_face},
                                               {"box_copies", copies},     {"box_nested", nested},
                                               {"box_doubling", doubling}, {"box_grid", grid}};

}  // namespace strahl::selftest
