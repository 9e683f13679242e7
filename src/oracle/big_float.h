// SPDX-License-Identifier: MIT
// Owns one MPFR number of 200 bits; the operations are MPFR's own.
#pragma once

#include <mpfr.h>

#include "oracle/exact.h"

namespace strahl::oracle {

class BigFloat {
 public:
  BigFloat() { mpfr_init2(number_, 200); }
  ~BigFloat() { mpfr_clear(number_); }
  BigFloat(const BigFloat&) = delete;
  BigFloat& operator=(const BigFloat&) = delete;

  [[nodiscard]] mpfr_ptr get() { return number_; }
  [[nodiscard]] mpfr_srcptr get() const { return number_; }

 private:
  mpfr_t number_;
};

[[nodiscard]] inline Exact to_exact(const BigFloat& t) {
  Exact exact;
  exact.value = mpfr_get_d(t.get(), MPFR_RNDN);
  BigFloat rest;
  mpfr_sub_d(rest.get(), t.get(), exact.value, MPFR_RNDN);
  exact.rest = mpfr_get_d(rest.get(), MPFR_RNDN);
  return exact;
}

}  // namespace strahl::oracle
