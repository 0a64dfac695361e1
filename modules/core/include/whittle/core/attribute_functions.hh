#pragma once

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
/// values around: neither a step nor a texture at a seam may overshoot.
class AttributeFunctions {
 public:
  /// Keeps references to `functions` and `values`. \param values `n_components` per wedge of the input
  AttributeFunctions(const LocalFunctions& functions, AttributeKind kind, std::size_t n_components,
                     std::span<const double> values, unsigned threads);

  /// Whether faces of the input lie around w. The other functions require it.
  bool any(Index w) const { return functions_.any(w); }
  /// Of the `n_linear(kind, n_components)` first components.
  std::vector<LocalFunction> of(Index w) const;
  /// Moves a value to a position near a wedge, by its kind. Directions keep unit length, colours stay in [0, 1].
  /// Categories and the sign of a tangent don't change. Does nothing unless `any(w)`.
  /// \param position in the frame \param value in: blend of the values merged into w; out: value at `position`
  void move(Index w, const Vec3& position, std::span<double> value) const;

 private:
  /// The function of a component in a chart, if it is linear.
  struct Chart {
    bool is_linear = false;
    LocalFunction function;
  };

  double number(Index wedge, std::size_t i) const { return values_[wedge * n_components_ + i]; }
  std::vector<Index> find_charts() const;
  void find_linear_charts(std::vector<Index> charts, unsigned threads);
  void drop_bent_charts(std::vector<Index>& charts) const;
  void find_chart(const LocalFunctions& charts, Index chart);
  void move_joint_weights(Index w, const Vec3& position, std::span<double> value) const;

  const LocalFunctions& functions_;
  AttributeKind kind_;
  std::size_t n_components_;
  std::size_t n_linear_;
  std::span<const double> values_;
  std::vector<Index> chart_of_;  ///< per wedge of the mesh; invalid_index: no linear chart
  std::vector<Chart> charts_;    ///< n_linear_ per chart
};

}  // namespace whittle
