#include "whittle/render/view.hh"

#include <cmath>
#include <numbers>

namespace whittle::render {

View view_from(const Sphere& sphere, const Vec3& to_eye) {
  View view{sphere, to_eye.normalized(), {}};
  const bool is_along_y = view.to_eye.cross(Vec3::UnitY()).norm() < 0.035;
  const Vec3 up = is_along_y ? Vec3::UnitZ() : Vec3::UnitY();
  view.up = (up - up.dot(view.to_eye) * view.to_eye).normalized();
  return view;
}

std::vector<View> views_around(const Sphere& sphere, std::size_t n) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<View> views;
  views.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double ring = std::sqrt(1 - y * y);
    const double angle = golden_angle * static_cast<double>(i);
    views.push_back(view_from(sphere, {ring * std::sin(angle), y, ring * std::cos(angle)}));
  }
  return views;
}

}  // namespace whittle::render
