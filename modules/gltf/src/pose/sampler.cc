#include "pose/sampler.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace whittle::gltf {
namespace {

/// Differences of times, and their products with tangents, have to be finite. Times of 32 bits are below.
constexpr double largest_number = 0x1p128;

Elements read_elements(const Model& model, const Part& part, const char* key) {
  const Accessor& accessor = model.accessors[part.required_index(key, model.accessors.size(), "accessor")];
  if (!accessor.view && accessor.count > model.n_bytes) part.fail("it has more values than the file has bytes");
  return Elements(accessor);
}

Eigen::Quaterniond rotation_of(const std::vector<double>& numbers) {
  return Eigen::Quaterniond(numbers[3], numbers[0], numbers[1], numbers[2]).normalized();
}

std::vector<double> numbers_of(const Eigen::Quaterniond& rotation) {
  return {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
}

}  // namespace

Sampler::Sampler(const Model& model, const Part& part, const Keyed& keyed)
    : keyed_(keyed), times_(read_elements(model, part, "input")), values_(read_elements(model, part, "output")) {
  const std::string word = part.text("interpolation").value_or("LINEAR");
  if (word == "STEP") {
    interpolation_ = Interpolation::step;
  } else if (word == "CUBICSPLINE") {
    interpolation_ = Interpolation::cubic_spline;
  } else if (word != "LINEAR") {
    part.fail("the interpolation " + printable(word) + " is not known");
  }
  if (times_.shape() != ElementShape{1, 1}) part.fail("its times are " + name_of(times_.shape()));
  if (values_.shape() != keyed.shape) part.fail("its values are " + name_of(values_.shape()));
  if (n_keys() == 0) part.fail("it has no times");
  const std::size_t elements_a_key = keyed.n_elements * (interpolation_ == Interpolation::cubic_spline ? 3 : 1);
  // The product can't overflow: there are fewer keys than bytes, and fewer targets than bytes of the document.
  if (values_.size() < n_keys() * elements_a_key) {
    part.fail("it has " + std::to_string(values_.size()) + " values for " + std::to_string(n_keys()) + " times");
  }
  check_numbers(part);
}

void Sampler::check_numbers(const Part& part) const {
  const auto is_good = [](double x) { return std::abs(x) <= largest_number; };
  for (std::size_t key = 0; key < n_keys(); ++key) {
    if (!is_good(time(key))) part.fail("time " + std::to_string(key) + " is not finite");
    if (key > 0 && time(key) < time(key - 1)) part.fail("time " + std::to_string(key) + " is before the one before it");
  }
  std::array<double, 4> components{};
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_.read(i, components);
    if (!std::all_of(components.begin(), components.end(), is_good)) {
      part.fail("value " + std::to_string(i) + " is not finite");
    }
  }
}

double Sampler::time(std::size_t key) const {
  double seconds = 0;
  times_.read(key, std::span(&seconds, 1));
  return seconds;
}

std::vector<double> Sampler::numbers(std::size_t key, Role role) const {
  std::vector<double> numbers(keyed_.n_numbers());
  const std::size_t group =
      interpolation_ == Interpolation::cubic_spline ? 3 * key + static_cast<std::size_t>(role) : key;
  const std::size_t n_components = keyed_.shape.n_components();
  for (std::size_t i = 0; i < keyed_.n_elements; ++i) {
    values_.read(group * keyed_.n_elements + i, std::span(numbers).subspan(i * n_components, n_components));
  }
  return numbers;
}

std::vector<double> Sampler::at(double seconds) const {
  // The last key that isn't later: before `high`, from `low` on.
  std::size_t low = 0;
  std::size_t high = n_keys();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (time(middle) <= seconds ? low : high) = middle;
  }
  const bool is_between = low + 1 < n_keys() && seconds > time(low);
  std::vector<double> value = is_between ? between(low, seconds) : numbers(low);
  return keyed_.is_rotation ? numbers_of(rotation_of(value)) : value;
}

std::vector<double> Sampler::between(std::size_t key, double seconds) const {
  if (interpolation_ == Interpolation::step) return numbers(key);
  const double share = (seconds - time(key)) / (time(key + 1) - time(key));
  return interpolation_ == Interpolation::linear ? linear(key, share) : cubic(key, share);
}

std::vector<double> Sampler::linear(std::size_t key, double share) const {
  std::vector<double> value = numbers(key);
  const std::vector<double> next = numbers(key + 1);
  if (keyed_.is_rotation) return numbers_of(rotation_of(value).slerp(share, rotation_of(next)));
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = (1 - share) * value[i] + share * next[i];
  return value;
}

std::vector<double> Sampler::cubic(std::size_t key, double share) const {
  const double length = time(key + 1) - time(key);
  const double t = share;
  const double t2 = t * t;
  const double t3 = t2 * t;
  std::vector<double> value = numbers(key);
  const std::vector<double> leaving = numbers(key, Role::out_tangent);
  const std::vector<double> arriving = numbers(key + 1, Role::in_tangent);
  const std::vector<double> next = numbers(key + 1);
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] = (2 * t3 - 3 * t2 + 1) * value[i] + length * (t3 - 2 * t2 + t) * leaving[i] +
               (3 * t2 - 2 * t3) * next[i] + length * (t3 - t2) * arriving[i];
  }
  return value;
}

}  // namespace whittle::gltf
