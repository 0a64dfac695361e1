#pragma once

// Replacements for functions of <cmath> whose rounding depends on system and processor. These give the same bits
// everywhere, as they consist of sums, products, quotients and square roots. (Exact functions of <cmath>, such as
// std::sqrt, std::ldexp and std::fmod, are the same everywhere already.)

namespace whittle::detail {

/// Cosine of an angle in degrees. [0, 180]
double cosine_of_deg(double angle_deg);

/// √(x² + y²), without overflow.
double hypotenuse(double x, double y);

/// atan2(y, x) in radians, [0, π]. \pre y ≥ 0, and both are finite
double angle_of(double y, double x);

/// ln(1 + x). \pre 0 ≤ x < ∞
double log_of_one_plus(double x);

/// base ^ exponent. \pre 0 ≤ base < ∞; if the base is 0, the exponent isn't negative
double power(double base, double exponent);

}  // namespace whittle::detail
