// SPDX-License-Identifier: MIT
#include "oracle/quadratic.h"

namespace strahl::oracle {

Exact root_value(const Quadratic<mpq_class>& f, Root root) {
  if (sign(f.discriminant) == 0) return to_exact(mpq_class(-f.b / f.a));
  const int sign_b = sign(f.b) > 0 ? 1 : -1;
  BigFloat q;
  mpfr_set_q(q.get(), f.discriminant.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(q.get(), q.get(), MPFR_RNDN);
  if (sign_b < 0) mpfr_neg(q.get(), q.get(), MPFR_RNDN);
  mpfr_add_q(q.get(), q.get(), f.b.get_mpq_t(), MPFR_RNDN);
  mpfr_neg(q.get(), q.get(), MPFR_RNDN);
  if ((sign_b > 0) == (root == Root::near)) {
    mpfr_div_q(q.get(), q.get(), f.a.get_mpq_t(), MPFR_RNDN);
    return to_exact(q);
  }
  BigFloat t;
  mpfr_set_q(t.get(), f.c.get_mpq_t(), MPFR_RNDN);
  mpfr_div(t.get(), t.get(), q.get(), MPFR_RNDN);
  return to_exact(t);
}

}  // namespace strahl::oracle
