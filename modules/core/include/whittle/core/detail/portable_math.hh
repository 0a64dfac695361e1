#pragma once

// Functions of <cmath> that each system rounds in its own way, and even one system on different processors. These give
// the same bits everywhere, as they consist of sums, products, quotients and square roots. (Those of <cmath> that are
// exact, such as std::sqrt, std::ldexp and std::fmod, are the same everywhere already.)

namespace whittle::detail {

/// Of an angle in degrees. [0, 180]
double cosine_of_deg(double angle_deg);

/// √(x² + y²), without overflow.
double hypotenuse(double x, double y);

/// atan2(y, x) in radians, [0, π]. \pre y ≥ 0, and both are finite
double angle_of(double y, double x);

/// ln(1 + x). \pre 0 ≤ x < ∞
double log_of_one_plus(double x);

/// \pre 0 ≤ base < ∞; where the base is 0, the exponent isn't negative
double power(double base, double exponent);

}  // namespace whittle::detail
