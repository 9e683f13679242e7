// SPDX-License-Identifier: MIT
// Rays with shapes for tests: deterministic from the seed, well-conditioned and adversarial. Every number of a case has
// been rounded to the precision asked for, so oracle and device see the same input.
#pragma once

#include <array>

#include "oracle/oracle.h"
#include "oracle/random.h"

namespace strahl::oracle {

enum class Rounding { to_float, to_double };

/// How a case is drawn.
enum class Law {
  aimed,          ///< at the inside of a shape of ordinary size, from outside, inside, behind or the surface itself
  log_uniform,    ///< every magnitude 10^-8 ... 10^8 (as pbrt's shape tests), half of the rays aimed
  border,         ///< tangent to within 2^-24 ... 2^-10, grazing a plane, at edges, vertices and rims, as rounded
  exact_border,   ///< the same exactly: small integers times a power of two
  in_surface,     ///< origin and direction within the face or the plane; origin on the quadric, direction tangent
  axis_parallel,  ///< one or two components +0 or -0, at the inside or the border
  offset,         ///< shape and origin up to 10^7 away from zero
  unnormalised,   ///< direction of length 10^-20 ... 10^18
  extreme,        ///< everything denormal in float, or 10^15 ... 10^18
};

inline constexpr std::array all_laws{Law::aimed,        Law::log_uniform,  Law::border,
                                     Law::exact_border, Law::in_surface,   Law::axis_parallel,
                                     Law::offset,       Law::unnormalised, Law::extreme};

template <class Shape>
struct Case {
  Ray ray;
  Shape shape;
};

[[nodiscard]] Case<Sphere> sphere_case(Random&, Law, Rounding);
[[nodiscard]] Case<Cylinder> cylinder_case(Random&, Law, Rounding);
[[nodiscard]] Case<Plane> plane_case(Random&, Law, Rounding);
[[nodiscard]] Case<Triangle> triangle_case(Random&, Law, Rounding);
[[nodiscard]] Case<Parallelogram> parallelogram_case(Random&, Law, Rounding);
[[nodiscard]] Case<Disk> disk_case(Random&, Law, Rounding);
[[nodiscard]] Case<Aabb> aabb_case(Random&, Law, Rounding);

}  // namespace strahl::oracle
