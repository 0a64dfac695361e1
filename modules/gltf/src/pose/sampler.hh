#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "document/json.hh"
#include "geometry/elements.hh"
#include "model/model.hh"

namespace whittle::gltf {

/// Content of an animation's keys: the number of components, and their interpolation.
struct Keyed {
  ElementShape shape;          ///< of an element of the accessor
  std::size_t n_elements = 1;  ///< a key has
  bool is_rotation = false;    ///< a unit quaternion: x, y, z, w

  std::size_t n_numbers() const { return n_elements * shape.n_components(); }
};

/// A function of time by its values at some times. Appendix C of the specification has the formulas.
class Sampler {
 public:
  /// \param part of the document. \throw io::ReadError if it has no keys, too few values, times that fall, or a number
  ///        that isn't finite
  Sampler(const Model& model, const Part& part, const Keyed& keyed);

  double first_time() const { return time(0); }            ///< seconds
  double last_time() const { return time(n_keys() - 1); }  ///< seconds
  /// The value at a time, `Keyed::n_numbers` numbers. Before the first time the first one, after the last time the
  /// last.
  std::vector<double> at(double seconds) const;

 private:
  enum class Interpolation : std::uint8_t { linear, step, cubic_spline };
  /// The values of a key of a cubic spline, in this order.
  enum class Role : std::uint8_t { in_tangent, value, out_tangent };

  void check_numbers(const Part& part) const;
  std::size_t n_keys() const { return times_.size(); }
  double time(std::size_t key) const;
  std::vector<double> numbers(std::size_t key, Role role = Role::value) const;
  std::vector<double> between(std::size_t key, double seconds) const;
  std::vector<double> linear(std::size_t key, double share) const;
  std::vector<double> cubic(std::size_t key, double share) const;

  Keyed keyed_;
  Interpolation interpolation_ = Interpolation::linear;
  Elements times_;
  Elements values_;
};

}  // namespace whittle::gltf
