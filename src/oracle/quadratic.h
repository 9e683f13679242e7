// SPDX-License-Identifier: MIT
// a t^2 + 2 b t + c = 0 with a > 0: every decision about its roots is the sign of P + Q sqrt(D), D = b^2 - a c, which
// squaring reduces to signs of polynomials, so that rationals decide it exactly although the roots are irrational.
// The roots themselves: q = -(b + sgn(b) sqrt(D)), q / a and c / q (Press et al., Numerical Recipes, section 5.6).
#pragma once

#include "oracle/big_float.h"
#include "oracle/number.h"

namespace strahl::oracle {

enum class Root { near = -1, far = 1 };

template <class N>
struct Quadratic {
  N a, b, c;
  N discriminant;  ///< >= 0 wherever a root is asked for
};

/// The sign of p + q sqrt(d), d >= 0.
template <class N>
int sign_with_root(const N& p, const N& q, const N& d) {
  const int root_sign = sign(d) == 0 ? 0 : sign(q);
  const int sign_p = sign(p);
  if (sign_p == 0) return root_sign;
  if (root_sign == 0 || root_sign == sign_p) return sign_p;
  return sign_p * sign(N(p * p - q * q * d));
}

/// The sign of root - bound; bound may be infinite.
template <class N>
int compare(const Quadratic<N>& f, Root root, double bound) {
  if (std::isinf(bound)) return bound < 0 ? 1 : -1;
  return sign_with_root(N(-f.b - f.a * N(bound)), N(static_cast<int>(root)), f.discriminant);
}

template <class N>
bool in_range(const Ray& ray, const Quadratic<N>& f, Root root) {
  return compare(f, root, ray.t_min) >= 0 && compare(f, root, ray.t_max) <= 0;
}

inline Exact root_value(const Quadratic<Filtered>& f, Root root) {
  if (sign(f.discriminant) == 0) return to_exact(-f.b / f.a);
  const Filtered s = sqrt(f.discriminant);
  // The sign of b only chooses the stable form: either is right where it is uncertain, the error bound then tells.
  const bool b_positive = to_double(f.b) > 0;
  const Filtered q = b_positive ? -(f.b + s) : s - f.b;
  const bool is_q_over_a = b_positive == (root == Root::near);
  return to_exact(is_q_over_a ? q / f.a : f.c / q);
}

[[nodiscard]] Exact root_value(const Quadratic<mpq_class>& f, Root root);

}  // namespace strahl::oracle
