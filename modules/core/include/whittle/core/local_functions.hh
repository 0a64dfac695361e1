#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

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
  bool holds = false;          ///< whether it is that of a whole chart, and so holds beyond low and high

  double at(const Vec3& position) const { return mean + slope.dot(position - center); }
  /// What the component gains on a way: no more than a quarter of the range, unless the function `holds`. A few points
  /// are always on a linear function, which says nothing of places that lie farther off than they are apart.
  double gain(const Vec3& way) const;
  /// Clamps a number to [low, high], widened to the function's own value where it `holds`.
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
  bool any(Index w) const { return places_[w].n_faces > 0; }
  /// Calls visit(wedge of the input, position in the frame) for each wedge that the faces around w have.
  template <class Visit>
  void for_each_corner(Index w, const Visit& visit) const {
    for (const Corner& corner : places_[w].corners) visit(corner.wedge, position_of(corner));
  }
  /// The functions of n components around wedge w. \param value maps a wedge of the input and a component to a number
  template <class Value>
  std::vector<LocalFunction> around(Index w, std::size_t n, const Value& value) const {
    const Place& place = places_[w];
    std::vector<Sums> sums;
    sums.reserve(n);
    for (std::size_t i = 0; i < n; ++i) sums.emplace_back(value(place.corners.front().wedge, i));
    for (const Corner& corner : place.corners) {
      const Vec3 from_center = position_of(corner) - place.center;
      for (std::size_t i = 0; i < n; ++i) sums[i].add(corner.weight, from_center, value(corner.wedge, i));
    }
    std::vector<LocalFunction> functions;
    functions.reserve(n);
    for (const Sums& sum : sums) functions.push_back(function_of(place, sum));
    return functions;
  }

 private:
  /// A wedge of the input, at corners of the faces around a wedge.
  struct Corner {
    Index wedge, vertex;
    double weight;  ///< a third of the area of these faces
  };
  /// The points around a wedge.
  struct Place {
    std::size_t n_faces = 0;
    std::vector<Corner> corners;
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
    void add(double w, const Vec3& from_center, double number) {
      const double apart = w * (number - first);
      weight += w;
      value += apart;
      square += apart * (number - first);
      moment += apart * from_center;
      low = std::min(low, number);
      high = std::max(high, number);
    }
  };
  std::vector<Corner> corners_of_faces(std::span<const Index> faces, std::span<const double> areas,
                                       std::span<Index> places_of) const;
  void find_axes(Place& place) const;
  static LocalFunction function_of(const Place& place, const Sums& sums);
  Vec3 position_of(const Corner& corner) const { return frame_.to_frame(input_.positions[corner.vertex]); }

  const IndexedMesh& input_;
  Frame frame_;
  std::span<const Index> wedge_map_;
  std::vector<Place> places_;
};

}  // namespace whittle
