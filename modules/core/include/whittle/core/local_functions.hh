#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A component on a surface as a linear function of the position, near one point.
struct LocalFunction {
  Vec3 center = Vec3::Zero();  ///< in the frame
  double mean = 0;             ///< at the center
  Vec3 slope = Vec3::Zero();   ///< per unit of the frame
  double low = 0, high = 0;    ///< range of the values around
  bool is_linear = false;      ///< whether the values around are linear, to a hundredth of their variation
  bool stays = false;          ///< whether also linear values are clamped to low and high

  double at(const Vec3& position) const { return mean + slope.dot(position - center); }
  /// Clamps a number to [low, high]. Linear values are clamped only if `stays`.
  double in_range(double number, const Vec3& position) const;
};

/// Linear functions of the position around each wedge of a mesh made from an input. They are fitted to the faces with a
/// corner merged into the wedge, weighted by area. So attributes that are linear in the position keep their functions,
/// to rounding, wherever the wedge goes, even beside the surface.
///
/// Across a thin layer of points the slope is mostly noise. So along each main axis of the points the slope g is shrunk
/// to g · e / (e + s² / n): e is the variance that it explains, s² the residual variance, n the number of faces.
/// Without residual g stays; if g is noise, it becomes about 0. Rounding errors of values grow at most by the distance
/// over the thickness.
class LocalFunctions {
 public:
  /// Keeps references to the input and the map.
  /// \param frame of the input
  /// \param wedge_map for each wedge of the input its wedge in the mesh, or `invalid_index`
  /// \param n_wedges number of wedges of the mesh
  LocalFunctions(const IndexedMesh& input, const Frame& frame, std::span<const Index> wedge_map, std::size_t n_wedges,
                 unsigned threads);

  const IndexedMesh& input() const { return input_; }
  const Frame& frame() const { return frame_; }
  std::span<const Index> wedge_map() const { return wedge_map_; }
  std::size_t n_wedges() const { return places_.size(); }

  /// Whether faces of the input lie around w. The other functions require it.
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
  /// The function around wedge w. \param value maps a wedge of the input to its number
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
    Vec3 variance = Vec3::Zero();                        ///< along the axes; 0 if within rounding error
  };
  struct Sums {
    double first;  ///< offset of all values, so that large ones lose no digits
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
