// SPDX-License-Identifier: MIT
// Questions from a seed, by name, for rows that are too many to write down. A generator draws a ray and shapes whose
// numbers are floats; the exact answer comes from answer.h.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "oracle/random.h"
#include "selftest/catalogue.h"
#include "selftest/to_float.h"

namespace strahl::selftest {

/// What a generator draws from: random numbers, the sizes that the row states, and the way to floats.
class Draft {
 public:
  explicit Draft(const Generated& call) : random(call.seed), sizes_(call.sizes) {}

  oracle::Random random;
  int index = 0;  ///< Of the question that is drawn.

  /// The row's number of that name, or the usual one.
  [[nodiscard]] double size(const std::string& name, double usual);
  [[nodiscard]] int whole(const std::string& name, int usual) { return static_cast<int>(size(name, usual)); }

  /// Uniform on the unit sphere.
  [[nodiscard]] Vec3 direction();
  /// A unit vector perpendicular to the unit vector n.
  [[nodiscard]] Vec3 perpendicular(const Vec3& n);
  /// A point `offset` (of the row, usually 0) away from the world's origin, as floats.
  [[nodiscard]] Vec3 place();
  /// One of `length` (of the row, usually 1) along the unit vector.
  [[nodiscard]] Vec3 scaled(const Vec3& unit) { return size("length", 1) * unit; }

  /// The names that no generator has asked for.
  [[nodiscard]] std::vector<std::string> unused() const;

 private:
  std::map<std::string, double> sizes_;
  std::set<std::string> used_;
};

[[nodiscard]] Question question_about(const char* kind);
/// Appends the components, rounded to float.
void put(Question&, const Vec3& v);
void put(Question&, double x);
/// Sets origin and direction, rounded to float.
void aim(Question&, const Vec3& origin, const Vec3& direction);

enum class Surface {
  open,
  convex,  ///< Closes around the origin, so that one shape is met, whatever the band.
  closed,  ///< Closes around the origin, so that one shape or three are met: within the band any of them.
};

struct Generator {
  const char* name;
  Question (*draw)(Draft&);
  Surface surface = Surface::open;
};

/// The proofs' own (selftest/shape_proof.h), a file each: generate_*.cpp.
extern const std::vector<Generator> sphere_generators, plane_generators, mesh_generators, triangle_generators,
    parallelogram_generators, disk_generators, cylinder_generators, box_generators;

[[nodiscard]] bool is_generator(const std::string& name);

/// Throws InputError for a size that the generator does not have.
[[nodiscard]] std::vector<Question> generate(const Generated&);

}  // namespace strahl::selftest
