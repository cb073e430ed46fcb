// Functions of the controller's mathematics with 256 bits (MPFR), and how far a double is from them.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace armature::test {

class MpfrOracle {
 public:
  MpfrOracle() {
    for (mpfr_ptr v : {x_, y_, result_, error_}) mpfr_init2(v, 256);
  }
  ~MpfrOracle() {
    for (mpfr_ptr v : {x_, y_, result_, error_}) mpfr_clear(v);
  }
  MpfrOracle(const MpfrOracle&) = delete;
  MpfrOracle& operator=(const MpfrOracle&) = delete;

  void sin(double x) { mpfr_sin(result_, of(x_, x), MPFR_RNDN); }
  void cos(double x) { mpfr_cos(result_, of(x_, x), MPFR_RNDN); }
  void atan2(double y, double x) { mpfr_atan2(result_, of(y_, y), of(x_, x), MPFR_RNDN); }
  void hypot(double x, double y) { mpfr_hypot(result_, of(x_, x), of(y_, y), MPFR_RNDN); }
  void cbrt(double x) { mpfr_cbrt(result_, of(x_, x), MPFR_RNDN); }

  // The double nearest to n pi/2.
  double half_pis(std::int64_t n) {
    mpfr_const_pi(x_, MPFR_RNDN);
    mpfr_mul_si(x_, x_, static_cast<long>(n), MPFR_RNDN);
    mpfr_div_2ui(x_, x_, 1, MPFR_RNDN);
    return mpfr_get_d(x_, MPFR_RNDN);
  }

  // |got - last result| in units of the last place of that result, rounded.
  double ulps(double got) {
    const double rounded = mpfr_get_d(result_, MPFR_RNDN);
    if (!std::isfinite(rounded) || !std::isfinite(got))
      return got == rounded ? 0.0 : std::numeric_limits<double>::infinity();
    const int exponent = std::max(rounded == 0.0 ? -1022 : std::ilogb(rounded), -1022);
    mpfr_sub(error_, of(error_, got), result_, MPFR_RNDN);
    mpfr_mul_2si(error_, error_, 52 - exponent, MPFR_RNDN);
    return std::fabs(mpfr_get_d(error_, MPFR_RNDN));
  }

 private:
  static mpfr_ptr of(mpfr_ptr to, double v) {
    mpfr_set_d(to, v, MPFR_RNDN);
    return to;
  }
  mpfr_t x_, y_, result_, error_;
};

}  // namespace armature::test
