#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A number on a surface, as a linear function of the position, near one place.
struct LocalFunction {
  Vec3 center = Vec3::Zero();  ///< in the frame
  double mean = 0;             ///< at the center
  Vec3 slope = Vec3::Zero();   ///< per unit of the frame
  double low = 0, high = 0;    ///< of the values there
  bool is_linear = false;      ///< whether the number is such a function there, but for a hundredth of how it varies
  bool stays = false;          ///< whether also a linear number goes no further than low and high

  double at(const Vec3& position) const { return mean + slope.dot(position - center); }
  /// Puts a number back into the range of the values there. A linear number may go on beyond them, unless it stays.
  double in_range(double number, const Vec3& position) const;
};

/// How the numbers of an input go around each wedge of a mesh that was made from it: linear functions of the position
/// that are fitted to the faces with a corner that was merged into the wedge, each by its area. So attributes that are
/// linear in the position have their functions, to rounding, wherever the wedge goes: beside the surface, too.
///
/// Across a thin layer of points the slope is what noise makes of it. So along each main axis of the points the slope
/// g is made shorter, to g · e / (e + s² / n): e is the variance that it explains, s² the variance that is left, n the
/// number of faces. That is all of g where nothing is left, and nothing where g is noise. The error that rounded
/// values make is no more than theirs, times the distance over the thickness.
class LocalFunctions {
 public:
  /// Keeps references to the input and the map. \param frame of the input
  /// \param wedge_map for each wedge of the input that of the mesh that it has become, or `invalid_index`
  /// \param n_wedges of the mesh
  LocalFunctions(const IndexedMesh& input, const Frame& frame, std::span<const Index> wedge_map, std::size_t n_wedges,
                 unsigned threads);

  const IndexedMesh& input() const { return input_; }
  const Frame& frame() const { return frame_; }
  std::span<const Index> wedge_map() const { return wedge_map_; }
  std::size_t n_wedges() const { return places_.size(); }

  /// Whether any of the input lies around w. The other functions need that.
  bool any(Index w) const { return !faces_of_.of(w).empty(); }
  /// Calls visit(wedge of the input, position in the frame) for each corner of the faces around w.
  template <class Visit>
  void for_each_corner(Index w, const Visit& visit) const {
    for (const Index f : faces_of_.of(w)) {
      for (std::size_t k = 0; k < 3; ++k) {
        visit(input_.wedge(f, k), frame_.to_frame(input_.positions[input_.faces[f][k]]));
      }
    }
  }
  /// \param value of a wedge of the input → its number
  template <class Value>
  LocalFunction around(Index w, const Value& value) const {
    Sums sums(value(input_.wedge(faces_of_.of(w).front(), 0)));
    for (const Index f : faces_of_.of(w)) {
      const double weight = areas_[f] / 3;
      for (std::size_t k = 0; k < 3; ++k) {
        sums.add(weight, frame_.to_frame(input_.positions[input_.faces[f][k]]) - places_[w].center,
                 value(input_.wedge(f, k)));
      }
    }
    return function_of(w, sums);
  }

 private:
  /// The points around a wedge.
  struct Place {
    Vec3 center = Vec3::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< main axes, in columns
    Vec3 variance = Vec3::Zero();                        ///< along them; 0 if that is no more than rounding error
  };
  struct Sums {
    double first;  ///< the value that others are looked at from, so that large ones lose no digits
    double low = first, high = first;
    double weight = 0, value = 0, square = 0;
    Vec3 moment = Vec3::Zero();

    explicit Sums(double number) : first(number) {}
    void add(double w, const Vec3& from_center, double number);
  };
  Place place_of(Index w) const;
  LocalFunction function_of(Index w, const Sums& sums) const;

  const IndexedMesh& input_;
  Frame frame_;
  std::span<const Index> wedge_map_;
  std::vector<double> areas_;  ///< of the input's faces; none is zero
  detail::IndexLists<Index> faces_of_;
  std::vector<Place> places_;
};

}  // namespace whittle
