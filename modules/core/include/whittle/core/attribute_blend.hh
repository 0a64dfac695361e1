#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/attribute.hh"

namespace whittle {

/// Number of leading components that are blended one by one, by sums.
std::size_t n_linear(AttributeKind kind, std::size_t n_components);

/// Scales a summed value to unit length, or clamps it to [0, 1], by its kind.
/// \param before the value to keep if a direction has no length
void restore_range(AttributeKind kind, std::span<const double> before, std::span<double> value);

/// Computes the weighted mean of values of an attribute, by its kind. Can be used again after `result`.
class AttributeBlend {
 public:
  AttributeBlend(AttributeKind kind, std::size_t n_components);

  void add(std::span<const double> value, double weight);
  /// \pre a value was added
  /// \param to gets the mean
  /// \return false if directions cancel out; then `to` is unchanged
  bool result(std::span<double> to);

 private:
  struct Vote {
    double what;  ///< a joint, or a category in the first component
    double weight;
    std::vector<double> value;  ///< of a category: the first value added
  };

  void vote(double what, double weight, std::span<const double> value);
  bool direction(std::span<double> to) const;
  void joint_weights(std::span<double> to);
  void forget();

  AttributeKind kind_;
  std::vector<double> sum_;
  double total_ = 0;
  std::size_t n_ = 0;
  std::vector<double> last_;  ///< the value added last: alone, it keeps every bit
  std::vector<Vote> votes_;   ///< in the order in which they were first added
};

}  // namespace whittle
