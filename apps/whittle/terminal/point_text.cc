#include "terminal/point_text.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace whittle::app {
namespace {

/// \param format takes the number of digits and the number
std::string with_digits(const char* format, int digits, double x) {
  std::array<char, 48> text;
  const int size = std::snprintf(text.data(), text.size(), format, digits, x);
  return {text.data(), static_cast<std::size_t>(size)};
}

/// \param last_place of the last digit: -3 for thousandths, 0 for whole units
std::string coordinate_text(double x, int last_place) {
  const int n_decimals = std::max(0, -last_place);
  const double unit = std::pow(10, -n_decimals);
  if (std::abs(x) < unit / 2) return "0";
  // Numbers with very many zeros are shorter with an exponent.
  const int first_place = static_cast<int>(std::floor(std::log10(std::abs(x))));
  if (n_decimals > 8 || first_place > 14)
    return with_digits("%.*g", std::clamp(first_place - last_place + 1, 4, 17), x);
  std::string digits = with_digits("%.*f", n_decimals, x);
  if (n_decimals > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

}  // namespace

std::string point_text(const Vec3& point, double extent) {
  const double size = extent > 0 ? extent : std::max(point.cwiseAbs().maxCoeff(), 1.0);
  const int last_place = static_cast<int>(std::floor(std::log10(size))) - 3;
  std::string text;
  for (const double x : point) text += (text.empty() ? "" : " ") + coordinate_text(x, last_place);
  return text;
}

}  // namespace whittle::app
