// SPDX-License-Identifier: MIT
#include "oracle/number.h"

#include "oracle/big_float.h"

namespace strahl::oracle {

Exact to_exact(const mpq_class& a) {
  BigFloat t;
  mpfr_set_q(t.get(), a.get_mpq_t(), MPFR_RNDN);
  return to_exact(t);
}

}  // namespace strahl::oracle
