#include "pictures/meshes/page_camera.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whittle::app {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Vec3 up_of(const PictureView& view) {
  if (view.up == "x") return Vec3::UnitX();
  return view.up == "z" ? Vec3::UnitZ() : Vec3::UnitY();
}

/// A direction with y upwards, turned around y and then up or down.
Vec3 turned(const Vec3& direction, const PictureView& view) {
  constexpr double from_pole = 1e-6;  // radians
  const double around = std::atan2(direction.x(), direction.z()) + radians(view.turn_deg);
  const double from_up =
      std::clamp(std::acos(direction.y()) + radians(view.tilt_deg), from_pole, std::numbers::pi - from_pole);
  return {std::sin(from_up) * std::sin(around), std::cos(from_up), std::sin(from_up) * std::cos(around)};
}

}  // namespace

render::Camera page_camera(const Box& box, const PictureView& view, double aspect) {
  constexpr double margin = 1.05;
  render::Camera camera;
  const double radius = box.isEmpty() || !(box.sizes().norm() > 0) ? 1 : box.sizes().norm() / 2;
  const double narrow = std::atan(std::tan(radians(camera.height_angle_deg / 2)) * std::min(1.0, aspect));
  const double distance = margin * radius / std::sin(narrow) / (view.zoom > 0 ? view.zoom : 1);
  camera.target = box.isEmpty() ? Vec3(Vec3::Zero()) : center_of(box);
  camera.up = up_of(view);
  const Eigen::Quaterniond to_up = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), camera.up);
  camera.eye = camera.target + to_up * turned(Vec3(0.35, 0.25, 1).normalized(), view) * distance;
  return camera;
}

Projection::Projection(const render::Camera& camera, double height)
    : eye_(camera.eye), height_(height), scale_(height / 2 / std::tan(radians(camera.height_angle_deg / 2))) {
  const Vec3 to_eye = (camera.eye - camera.target).normalized();
  const Vec3 right = camera.up.cross(to_eye).normalized();
  axes_ << right.transpose(), to_eye.cross(right).transpose(), to_eye.transpose();
}

double Projection::seen_length(const Vec3& a, const Vec3& b, double width) const {
  const Vec3 p = axes_ * (a - eye_);
  const Vec3 q = axes_ * (b - eye_);
  if (!(p.z() < 0) || !(q.z() < 0)) return 0;
  const Eigen::Vector2d at_p = p.head<2>() * (scale_ / -p.z());
  const Eigen::Vector2d at_q = q.head<2>() * (scale_ / -q.z());
  const Eigen::Vector2d half(width / 2, height_ / 2);
  const bool is_beyond = (at_p.array() > half.array() && at_q.array() > half.array()).any() ||
                         (at_p.array() < -half.array() && at_q.array() < -half.array()).any();
  return is_beyond ? 0 : (at_p - at_q).norm();
}

}  // namespace whittle::app
