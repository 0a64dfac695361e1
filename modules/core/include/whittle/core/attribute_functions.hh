#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/local_functions.hh"

namespace whittle {

/// A chart is a part of a mesh in which an attribute is continuous: seams of other attributes are none of this one.
/// \param values those of the mesh's wedges, one after the other
/// \return the chart of each wedge, by the least of its wedges
std::vector<Index> attribute_charts(const IndexedMesh& mesh, std::span<const double> values, std::size_t n_components);

/// How an attribute of an input goes around each wedge of a mesh that was made from it.
///
/// Where a number is linear in the position throughout its chart (`attribute_charts`), as in planar maps of textures,
/// it has that function everywhere. Elsewhere it has the local one
/// (`LocalFunctions`), and goes no further than the values around it: neither a step nor a texture at a seam may
/// overshoot.
class AttributeFunctions {
 public:
  /// Keeps references to both. \param values those of the input's wedges, one after the other
  AttributeFunctions(const LocalFunctions& functions, AttributeKind kind, std::size_t n_components,
                     std::span<const double> values, unsigned threads);

  /// Whether any of the input lies around w. The other functions need that.
  bool any(Index w) const { return functions_.any(w); }
  /// \param i below `n_linear(kind, n_components)`
  LocalFunction of(Index w, std::size_t i) const;
  /// Moves a value to a position near a wedge, as its kind asks. Directions keep unit length, colours stay in [0, 1].
  /// What can't be in between, as categories and the sign of a tangent, stays as it is. Does nothing if there is
  /// nothing around. \param position in the frame \param value of what was merged into w, blended; becomes that there
  void move(Index w, const Vec3& position, std::span<double> value) const;

 private:
  /// The function of a number in a chart, if it is linear.
  struct Chart {
    bool is_linear = false;
    LocalFunction function;
  };

  double number(Index wedge, std::size_t i) const { return values_[wedge * n_components_ + i]; }
  std::vector<Index> find_charts() const;
  void find_linear_charts(const std::vector<Index>& charts, unsigned threads);
  Chart chart_of(const LocalFunctions& charts, Index chart, std::size_t i) const;
  void move_joint_weights(Index w, const Vec3& position, std::span<double> value) const;

  const LocalFunctions& functions_;
  AttributeKind kind_;
  std::size_t n_components_;
  std::size_t n_linear_;
  std::span<const double> values_;
  std::vector<Index> chart_of_;  ///< of the mesh's wedges; invalid_index: no linear chart
  std::vector<Chart> charts_;    ///< n_linear_ for each chart
};

}  // namespace whittle
