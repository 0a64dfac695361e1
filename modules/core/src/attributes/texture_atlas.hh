#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// The charts of an original on a texture's image: which of them are where.
class TextureAtlas {
 public:
  /// \param texcoords the first two of `n_components` finite numbers, for each wedge of the original
  /// \param charts of each wedge
  TextureAtlas(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components,
               std::vector<Index> charts);

  bool has_several_charts() const { return n_charts_ > 1; }
  Index chart_of(Index wedge) const { return chart_of_wedge_[wedge]; }

  /// Twice the area of a chart on the image. \pre there are several charts
  double area(Index chart) const { return area_of_chart_[chart]; }
  /// Whether a point lies on another chart of the same group, and not on its own. Charts of other groups have other
  /// images. \pre there are several charts
  bool is_on_another(const Vec2& point, Index own) const;

 private:
  using Box = Eigen::AlignedBox2d;

  struct Face {
    ImageTriangle corners;  ///< counter-clockwise
    Index chart;
  };
  /// A face in the list of a cell, with what leaves most of them out at a glance.
  struct Entry {
    float low_x, high_x, low_y, high_y;  ///< its box
    Index face;
    Index chart;
  };

  void add_faces(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components);
  void make_grid();
  std::size_t cell_along(int axis, double number) const;
  template <class Use>
  void for_each_cell(const Box& box, const Use& use) const;

  std::vector<Index> chart_of_wedge_;
  std::vector<Index> group_of_chart_;  ///< of its first face
  std::vector<double> area_of_chart_;
  std::size_t n_charts_ = 0;
  std::vector<Face> faces_;  ///< that have an area on the image
  Box box_;
  std::array<std::size_t, 2> n_cells_{1, 1};
  IndexLists<Entry, std::size_t> cells_;  ///< the faces whose boxes touch each
};

}  // namespace whittle::detail
