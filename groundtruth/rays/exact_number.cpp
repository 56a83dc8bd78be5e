// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/exact_number.h"

#include <mpfr.h>

#include <limits>

namespace pellucid::groundtruth {

double quotient(const Exact& p, const Exact& q) {
  // MPFR rounds a fraction of integers once, to 53 bits; the powers of two are exact.
  mpq_t fraction;
  mpq_init(fraction);
  mpz_set(mpq_numref(fraction), p.man());
  mpz_set(mpq_denref(fraction), q.man());
  if (mpz_sgn(mpq_denref(fraction)) < 0) {
    mpz_neg(mpq_numref(fraction), mpq_numref(fraction));
    mpz_neg(mpq_denref(fraction), mpq_denref(fraction));
  }
  mpfr_t rounded;
  mpfr_init2(rounded, std::numeric_limits<double>::digits);
  mpfr_set_q(rounded, fraction, MPFR_RNDN);
  mpfr_mul_2si(rounded, rounded, long(p.exp()) - long(q.exp()), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  mpq_clear(fraction);
  return result;
}

}  // namespace pellucid::groundtruth
