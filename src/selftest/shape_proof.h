// SPDX-License-Identifier: MIT
// What proves right how rays meet one kind of shape: cases, exact answers, promises. One class a kind, a file each in
// selftest/shapes/. The linker names an entry of cl/shapes/shapes.def that has none.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "oracle/generators.h"
#include "scene/model/scene.h"
#include "selftest/answer.h"
#include "selftest/generators.h"
#include "settings/settings.h"

namespace strahl::selftest {

/// A ray and one primitive, whose planes are those that cl/shapes/<kind> states.
struct Asked {
  const oracle::Ray& ray;
  const double* planes;
  bool has_left;
};

/// docs/selftest.md says them in words. In ulps of float, of t.
struct Promises {
  double robust_ulps, double_ulps;
  std::vector<oracle::Law> stable;  ///< Laws well-conditioned enough for that tier's forms: none is wrong.
  double stable_ulps = std::numeric_limits<double>::infinity();
};

class ShapeProof {
 public:
  virtual ~ShapeProof() = default;

  /// Planes and ray of one primitive as the law asks for them; every number a float.
  virtual void draw(Question&, oracle::Random&, oracle::Law) const = 0;
  /// With the bands within which nothing is promised. A primitive that was left: exact_answer() says what is met.
  [[nodiscard]] virtual ExactAnswer answer(const Asked&) const = 0;
  [[nodiscard]] virtual Promises promises() const = 0;

  /// Some normal of the surface at p, of any length; of a flat shape its own.
  [[nodiscard]] virtual Vec3 normal(const double* planes, const Vec3& p) const = 0;
  /// Writes what a ray meets that leaves the primitive, from as near as rounding lets it begin. A flat one: nothing.
  virtual void expect_leaving(Question& q, Precision) const { q.expected = Expected::miss; }

  /// As a scene has it.
  [[nodiscard]] virtual Geometry geometry(const double* planes) const = 0;
  /// Hard cases by name, for rows of the catalogue.
  [[nodiscard]] virtual std::vector<Generator> generators() const { return {}; }
};

/// Throws std::logic_error for what is no entry.
[[nodiscard]] const ShapeProof& proof_of(const std::string& kind);
/// Of every entry, in the list's order.
[[nodiscard]] const std::vector<const ShapeProof*>& all_proofs();

#define SHAPE(name, planes) [[nodiscard]] const ShapeProof& name##_proof();
#include "../../cl/shapes/shapes.def"
#undef SHAPE

}  // namespace strahl::selftest
