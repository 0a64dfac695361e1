// Poses for assets without animations. From pose to pose each number is a sequence that fills its range evenly, for any
// number of poses: multiples of an irrational number, without the whole part. Each joint begins elsewhere.
#include "pose/artificial.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace whittle::gltf {
namespace {

constexpr double largest_angle = std::numbers::pi / 6;  // a knee or a finger bends more, a spine less

// Powers of 1/x with x^4 = x + 1: the multiples of three of them fill a cube evenly (M. Roberts, The Unreasonable
// Effectiveness of Quasirandom Sequences, 2018).
constexpr double first_step = 0.8191725133961645;
constexpr double second_step = 0.6710436067037893;
constexpr double third_step = 0.5497004779019703;
constexpr double step_of_joints = std::numbers::phi - 1;
constexpr double step_of_targets = std::numbers::sqrt2 - 1;

double fraction(double x) { return x - std::floor(x); }

/// Element `number` of a sequence in [0, 1).
double spread(std::size_t number, double step, double begin) {
  return fraction(begin + static_cast<double>(number + 1) * step);
}

}  // namespace

void turn_joint(Pose& pose, std::size_t node, std::size_t number) {
  const double begin = static_cast<double>(node + 1) * step_of_joints;
  const double height = 2 * spread(number, first_step, begin) - 1;
  const double around = 2 * std::numbers::pi * spread(number, second_step, begin);
  const double angle = largest_angle * spread(number, third_step, begin);
  const double radius = std::sqrt(std::max(1 - height * height, 0.0));
  const Eigen::Vector3d axis(radius * std::cos(around), radius * std::sin(around), height);
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  pose.nodes[node] *= turn;
}

std::vector<double> artificial_weights(std::size_t node, std::size_t n_targets, std::size_t number) {
  std::vector<double> weights(n_targets);
  for (std::size_t t = 0; t < n_targets; ++t) {
    const double begin = static_cast<double>(node + 1) * step_of_joints + static_cast<double>(t + 1) * step_of_targets;
    weights[t] = spread(number, first_step, begin);
  }
  return weights;
}

}  // namespace whittle::gltf
