#pragma once

#include <Eigen/Geometry>
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
  /// The faces that a point was found on. Points near by are looked for on them first.
  struct Near {
    Index own = invalid_index;    ///< of its chart
    Index other = invalid_index;  ///< of another
  };

  /// \param texcoords the first two of `n_components` finite numbers, for each wedge of the original
  /// \param charts of each wedge
  TextureAtlas(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components,
               std::vector<Index> charts);

  bool has_several_charts() const { return groups_.size() > 1; }
  /// Charts are numbered group by group, from 0. \return invalid_index for a wedge of no face
  Index chart_of(Index wedge) const { return chart_of_wedge_[wedge]; }

  /// Twice the area of a chart on the image. \pre there are several charts
  double area(Index chart) const { return area_of_chart_[chart]; }
  /// Whether a point lies on another chart of the same group, and not on its own. Charts of other groups have other
  /// images. \pre there are several charts
  /// \param near what a call for a point near by and the same chart left there, or nothing
  bool is_on_another(const Vec2& point, Index own, Near& near) const;

 private:
  using Box = Eigen::AlignedBox2d;

  struct Numbers {
    std::size_t begin, end;
  };
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

  void number_charts(const IndexedMesh& original);
  void add_faces(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components);
  void make_grid();
  void divide(std::size_t n_cells);
  std::size_t cell_along(int axis, double number) const;
  /// The first of the faces that a point lies on, or invalid_index.
  Index face_at(const Vec2& point, std::span<const Entry> entries) const;
  template <class Use>
  void for_each_cell(const Box& box, const Use& use) const;

  std::vector<Index> chart_of_wedge_;
  std::vector<Numbers> groups_;  ///< per chart, the numbers of the charts of its group
  std::vector<double> area_of_chart_;
  std::vector<Face> faces_;  ///< that have an area on the image; in the order of their charts
  Box box_;
  std::size_t n_cells_ = 1;  ///< along each axis
  Vec2 cells_a_unit_ = Vec2::Zero();
  IndexLists<Entry, std::size_t> cells_;  ///< the faces whose boxes touch each, in their order
};

}  // namespace whittle::detail
