#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/local_functions.hh"

namespace whittle {

/// A chart is a part of a mesh in which an attribute is continuous. Seams of other attributes don't end it.
/// \param values `n_components` per wedge of the mesh
/// \return the chart of each wedge, named by its lowest wedge
std::vector<Index> attribute_charts(const IndexedMesh& mesh, std::span<const double> values, std::size_t n_components);

/// An attribute of an input as functions of the position, around each wedge of a mesh made from the input.
///
/// If a component is linear in the position throughout its chart (`attribute_charts`), as in planar texture maps, that
/// function holds in the whole chart. Elsewhere it has a local function (`LocalFunctions`), clamped to the range of the
/// values around: neither a step nor a texture at a seam may overshoot. The weight of each joint counts as a component;
/// in a chart all of them are linear, or none.
class AttributeFunctions {
 public:
  /// Keeps references to `functions` and `values`. \param values `n_components` per wedge of the input
  AttributeFunctions(const LocalFunctions& functions, AttributeKind kind, std::size_t n_components,
                     std::span<const double> values, unsigned threads);

  /// Whether faces of the input lie around w. The other functions require it.
  bool any(Index w) const { return functions_.any(w); }
  /// Per wedge of the mesh, a number of the map that its chart is part of; invalid_index where some component isn't
  /// linear. Charts with the same functions but for whole numbers are of one map, such as tiles of a texture that
  /// repeats: beyond its border a chart goes on as the other does. \pre the components are texture coordinates
  std::vector<Index> maps() const;
  /// Of the `n_linear(kind, n_components)` first components.
  std::vector<LocalFunction> of(Index w) const;
  /// Moves a value to a position near a wedge, by its kind. Directions keep unit length, colours stay in [0, 1].
  /// Categories and the sign of a tangent don't change. Does nothing unless `any(w)`.
  /// \param position in the frame \param value in: blend of the values merged into w; out: value at `position`
  void move(Index w, const Vec3& position, std::span<double> value) const;

 private:
  double number(Index wedge, std::size_t i) const { return values_[wedge * n_components_ + i]; }
  double weight_of(double joint, Index wedge) const;
  void find_joints();
  std::span<const LocalFunction> chart_of(Index w) const;
  std::vector<std::array<double, 2>> joints_at(Index w, const Vec3& position) const;
  void move_joint_weights(Index w, const Vec3& position, std::span<double> value) const;

  const LocalFunctions& functions_;
  AttributeKind kind_;
  std::size_t n_components_;
  std::size_t n_linear_;
  std::span<const double> values_;
  std::vector<double> joints_;            ///< all with a weight; empty for other kinds
  std::vector<Index> charts_;             ///< per wedge of the mesh; invalid_index: no linear chart
  std::vector<LocalFunction> in_charts_;  ///< per linear chart one for each component, or joint
};

}  // namespace whittle
