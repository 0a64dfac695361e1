#pragma once

#include <span>
#include <vector>

#include "rounds/cost_counts.hh"
#include "rounds/round_mesh.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle {

/// The numbers of edges at vertices, and what these make of the costs of pairs (valence_term.hh). Frozen vertices, of
/// which only a part is known, count for nothing.
class Valences {
 public:
  /// \param weight of the penalty; without one, costs stay as they are, and nothing is kept
  Valences(const RoundMesh& mesh, double weight)
      : mesh_(mesh), weight_(weight), of_vertices_(weight > 0 ? mesh.n_vertices() : 0) {}

  bool count() const { return weight_ > 0; }
  /// At the start. \pre they count, and v isn't frozen
  void set(Index v, std::size_t valence, bool is_on_border) {
    of_vertices_[v] = {static_cast<int>(valence), is_on_border};
  }
  /// The cost of a pair with the penalty, if they count. It is rounded to single precision before, as lists have it.
  double penalized(const VertexPair& pair, double cost) const {
    return count() ? change(pair).penalize(CostCounts::in_range(cost), weight_) : cost;
  }
  /// \param opposites the third corners of the faces that vanish \pre the link condition holds
  void merge(const VertexPair& pair, Index survivor, std::span<const Index> opposites);

 private:
  struct Valence {
    int n = 0;
    bool is_on_border = false;
  };
  bool is_known(Index v) const { return of_vertices_[v].n != 0; }
  ValenceChange change(const VertexPair& pair) const;

  const RoundMesh& mesh_;
  double weight_;
  std::vector<Valence> of_vertices_;
};

}  // namespace whittle
