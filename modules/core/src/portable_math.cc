#include "whittle/core/detail/portable_math.hh"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "whittle/core/detail/error_free.hh"

// The results require IEEE doubles, not the 80-bit registers of old processors.
static_assert(FLT_EVAL_METHOD == 0, "for 32-bit x86 compile with -msse2 -mfpmath=sse");

namespace whittle::detail {
namespace {

/// A number of twice the digits: value + error, where the error is at most half of the value's last digit.
using Wide = WithError;

Wide operator+(const Wide& a, const Wide& b) {
  const Wide sum = two_sum(a.value, b.value);
  return two_sum(sum.value, sum.error + (a.error + b.error));
}

Wide operator*(const Wide& a, const Wide& b) {
  const Wide product = two_product(a.value, b.value);
  return two_sum(product.value, product.error + (a.value * b.error + a.error * b.value));
}

Wide operator/(const Wide& a, double b) {
  const double quotient = a.value / b;
  const Wide back = two_product(quotient, b);
  return two_sum(quotient, ((a.value - back.value) - back.error + a.error) / b);
}

/// x − x³/3! + x⁵/5! − … \pre |x| ≤ π/2
double sine(const Wide& x) {
  const Wide square = x * x;
  Wide term = x;
  Wide result = x;
  for (int n = 2; n < 36; n += 2) {
    term = term * square / (-n * (n + 1.0));
    result = result + term;
  }
  return result.value;
}

/// ln x = 2 (s + s³/3 + s⁵/5 + …), s = f / (2 + f), f = x − 1. Its largest part is f, which has no rounding.
/// \pre √½ ≤ x ≤ √2
double log_near_one(double x) {
  const double f = x - 1;
  const double s = f / (2 + f);
  const double square = s * s;
  double series = 0;
  for (int n = 21; n > 1; n -= 2) series = (series + 2.0 / n) * square;
  const double half_square = 0.5 * f * f;
  return f - (half_square - s * (half_square + series));
}

/// x − x³/3 + x⁵/5 − … \pre |x| ≤ tan (π/8)
double small_angle(double x) {
  const double square = x * x;
  double series = 0;
  for (int n = 41; n > 1; n -= 2) series = (1.0 / n - series) * square;
  return x - x * series;
}

/// x = mantissa · 2^exponent, the mantissa between √½ and √2
struct Scaled {
  double mantissa;
  int exponent;
};

/// \pre 0 < x < ∞
Scaled scaled(double x) {
  Scaled result{};
  result.mantissa = std::frexp(x, &result.exponent);
  if (result.mantissa < 0.5 * std::numbers::sqrt2) {
    result.mantissa *= 2;
    --result.exponent;
  }
  return result;
}

/// 1 + x + x²/2! + … \pre |x| ≤ ½ ln 2
double exp_near_zero(double x) {
  double series = 1;
  for (int n = 14; n > 1; --n) series = 1 + series * x * (1.0 / n);
  return 1 + series * x;
}

}  // namespace

/// cos x = sin (π/2 − x), where π/2 has twice the digits.
double cosine_of_deg(double angle_deg) {
  constexpr Wide quarter{0x1.921fb54442d18p0, 0x1.1a62633145c07p-54};
  const double x = angle_deg * std::numbers::pi / 180;
  return sine(two_sum(quarter.value, -x) + Wide{quarter.error, 0});
}

/// Newton's step for the root in twice the digits.
double hypotenuse(double x, double y) {
  const double size = std::max(std::abs(x), std::abs(y));
  if (!(size > 0) || std::isinf(size)) return size;
  const int exponent = std::ilogb(size);
  const double a = std::ldexp(x, -exponent);
  const double b = std::ldexp(y, -exponent);
  const Wide square = two_product(a, a) + two_product(b, b);
  const double root = std::sqrt(square.value);
  const Wide back = two_product(root, root);
  return std::ldexp(root + ((square.value - back.value) - back.error + square.error) / (2 * root), exponent);
}

/// The nearest multiple of π/4 plus the rest.
double angle_of(double y, double x) {
  constexpr std::array<WithError, 5> eighths{{{0, 0},
                                              {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
                                              {0x1.921fb54442d18p0, 0x1.1a62633145c07p-54},
                                              {0x1.2d97c7f3321d2p1, 0x1.a79394c9e8a0ap-54},
                                              {0x1.921fb54442d18p1, 0x1.1a62633145c07p-53}}};
  constexpr double half_of_eighth = 0.41421356237309503;  // tan (π/8)
  if (!(y > 0)) return x < 0 ? eighths[4].value : 0;
  const double size = std::abs(x);
  std::size_t eighth = 1;
  double slope = 0;
  if (y < half_of_eighth * size) {
    eighth = 0;
    slope = y / size;
  } else if (size < half_of_eighth * y) {
    eighth = 2;
    slope = -size / y;
  } else {
    slope = (y - size) / (y + size);
  }
  const double rest = small_angle(slope);
  const auto& [angle, error] = eighths[x < 0 ? 4 - eighth : eighth];
  return angle + (x < 0 ? error - rest : error + rest);
}

/// Corrects the rounding error of 1 + x.
double log_of_one_plus(double x) {
  const double one_plus = 1 + x;
  const double lost = x < 1 ? x - (one_plus - 1) : 1 - (one_plus - x);
  const auto [mantissa, exponent] = scaled(one_plus);
  return exponent * std::numbers::ln2 + (log_near_one(mantissa) + lost / one_plus);
}

/// 2^(exponent · log₂ base). Its whole part is exact: `high` has few digits, so that its product fits.
double power(double base, double exponent) {
  if (exponent == 0) return 1;
  if (!(base > 0)) return 0;
  if (exponent == 1) return base;
  const auto [mantissa, twos] = scaled(base);
  const double high = static_cast<float>(exponent);
  const double rest = (exponent - high) * twos + exponent * (log_near_one(mantissa) / std::numbers::ln2);
  const double whole = std::floor(high * twos + rest + 0.5);
  const double fraction = (high * twos - whole) + rest;
  const double part =
      std::abs(fraction) == 0.5 ? std::sqrt(fraction < 0 ? 0.5 : 2.0) : exp_near_zero(fraction * std::numbers::ln2);
  constexpr double far = 5000;  // beyond it all is 0 or infinite
  return std::ldexp(part, static_cast<int>(std::clamp(whole, -far, far)));
}

}  // namespace whittle::detail
