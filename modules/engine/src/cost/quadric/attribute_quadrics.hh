#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

// What a contraction costs in attributes. On a face t of the input, a component j of an attribute is a linear function
// f_tj(x) = g_tj · x + d_tj of the position, with g_tj in the face's plane. A wedge w has the faces of all wedges
// merged into it, each with its area w_t. If its vertex is at x, its best value of j is the mean of the f_tj(x), and it
// costs
//
//   E_w(x) = Σ_j [ Σ_t w_t f_tj(x)² - (Σ_t w_t f_tj(x))² / Σ_t w_t ]
//
// That is the quadric of Hoppe 1999 with the attribute solved for. Unit: length² · area, as that of the planes: before,
// components are multiplied by a length (`scaled_attributes`).
//
// Noise in an attribute must not hold geometry: |g_tj| is at most `steepest`, and E_w at most `farthest`² Σ w_t.
// \cite hoppe_1999_attributes, \cite garland_1998_color

/// The attributes of the input that count, as lengths in the frame.
struct ScaledAttributes {
  std::size_t n_components = 0;
  std::vector<double> values;  ///< of each wedge of the input, one after the other
  double farthest = 0;         ///< in the frame
};

/// Whether the cost looks at attributes, and the mesh has some that may count.
bool looks_at_attributes(const DecimateOptions& options, const IndexedMesh& mesh);

/// None if no attribute counts. \param weights of `DecimateOptions`
ScaledAttributes scaled_attributes(const IndexedMesh& input, const Frame& frame, const AttributeWeights& weights);

/// The sums of wedges, of the surface that a pass begins with.
struct AttributeSums {
  std::size_t n_components = 0;  ///< 0 = none
  double farthest = 0;           ///< in the frame
  std::vector<double> sums;      ///< `stride()` numbers for each wedge
  std::vector<Index> vertex_of;  ///< wedges → vertices of the surface

  std::size_t stride() const { return 11 + 4 * n_components; }
};

/// \param wedge_of input's wedges → those of the surface, or `invalid_index` \param vertex_of of the surface's wedges
AttributeSums sum_attributes(const IndexedMesh& input, const Frame& frame, const ScaledAttributes& attributes,
                             std::span<const Index> wedge_of, std::vector<Index> vertex_of);

/// The attribute quadrics of a complex's vertices, one for each wedge.
class AttributeQuadrics {
 public:
  /// None.
  AttributeQuadrics() = default;
  AttributeQuadrics(const TriangleComplex& complex, AttributeSums sums);

  bool any() const { return sums_.n_components > 0; }

  /// What contracting a pair to `position` costs: each wedge of the end that has fewer joins that of the other end with
  /// which it costs least. Wedges of threshold pairs stay apart.
  double error(const Pair& pair, bool is_edge, const Vec3& position) const;
  void merge(const Change& change, bool is_edge);

 private:
  struct Match {
    Index wedge;
    double error;
  };
  const double* sum(Index wedge) const { return sums_.sums.data() + wedge * sums_.stride(); }
  double error_at(Index wedge, const Vec3& position) const;
  double error_of_both(Index first, Index second, const Vec3& position) const;
  Match best_match(Index wedge, Index vertex, std::uint64_t used, const Vec3& position) const;
  /// Calls `found` with each wedge of the pair and the one that joins it, or `invalid_index`, and what both cost.
  template <class Found>
  void match(const Pair& pair, bool is_edge, const Vec3& position, const Found& found) const;
  std::size_t n_wedges_at(Index v) const;

  AttributeSums sums_;
  std::vector<Index> first_;  ///< of the wedges at each vertex
  std::vector<Index> next_;   ///< of those at the same vertex, after each wedge
};

}  // namespace whittle
