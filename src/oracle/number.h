// SPDX-License-Identifier: MIT
// The two number types of the oracle behind one set of names, so that each primitive is written once: Filtered first,
// GMP rationals (exact) where the filter cannot tell. The names are found by their arguments: outside this namespace
// write sign(x), not oracle::sign(x). Distances leave the rational path through MPFR at 200 bits.
#pragma once

#include <gmpxx.h>

#include <cmath>

#include "oracle/exact.h"
#include "oracle/filtered.h"
#include "oracle/oracle.h"

namespace strahl::oracle {

inline int sign(const mpq_class& a) { return sgn(a); }
inline double to_double(const mpq_class& a) { return a.get_d(); }
inline double ratio(const mpq_class& a, const mpq_class& b) { return mpq_class(a / b).get_d(); }
[[nodiscard]] Exact to_exact(const mpq_class& a);

/// Runs body.operator()<Filtered>(), and body.operator()<mpq_class>() where the filter gives up or is not wanted.
template <class Body>
auto decide(Arithmetic arithmetic, const Body& body) {
  if (arithmetic == Arithmetic::filtered) {
    try {
      return body.template operator()<Filtered>();
    } catch (const Uncertain&) {
    }
  }
  return body.template operator()<mpq_class>();
}

template <class N>
struct Vector {
  N x, y, z;

  Vector(N along_x, N along_y, N along_z) : x(std::move(along_x)), y(std::move(along_y)), z(std::move(along_z)) {}
  explicit Vector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}

  friend Vector operator+(const Vector& a, const Vector& b) { return {N(a.x + b.x), N(a.y + b.y), N(a.z + b.z)}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {N(a.x - b.x), N(a.y - b.y), N(a.z - b.z)}; }
  friend Vector operator*(const N& s, const Vector& v) { return {N(s * v.x), N(s * v.y), N(s * v.z)}; }
};

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return N(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {N(a.y * b.z - a.z * b.y), N(a.z * b.x - a.x * b.z), N(a.x * b.y - a.y * b.x)};
}

/// |v| rounded, for margins only.
template <class N>
double length(const Vector<N>& v) {
  return std::hypot(to_double(v.x), to_double(v.y), to_double(v.z));
}

inline bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// t_min <= t <= t_max; either bound may be infinite.
template <class N>
bool in_range(const Ray& ray, const N& t) {
  if (std::isfinite(ray.t_min) && sign(N(t - N(ray.t_min))) < 0) return false;
  if (std::isfinite(ray.t_max) && sign(N(t - N(ray.t_max))) > 0) return false;
  return ray.t_min < INFINITY && ray.t_max > -INFINITY;
}

[[nodiscard]] inline double range_gap(const Ray& ray, const Exact& t) {
  return std::fmin(relative_gap(t, ray.t_min), relative_gap(t, ray.t_max));
}

}  // namespace strahl::oracle
