#pragma once

#include <vector>
#include "whittle/engine/decimate.hh"
#include "whittle/engine/frame.hh"
#include "whittle/engine/pair_evaluation.hh"

namespace whittle::test {

/// Decimation as its definition says, one contraction after the other: every edge of the mesh as it then is gets
/// evaluated, and the least (cost, lower, higher vertex number) that is allowed is contracted. No queue, no bounds, no
/// memory of refusals; the topology is looked at through the definition of links. Takes O(F²) or worse.
///
/// Shares with the engine the arithmetic of one pair (`evaluate_pair`, `merged`) and the frame, nothing else.
class BruteForceDecimater {
 public:
  BruteForceDecimater(const IndexedMesh& mesh, const DecimateOptions& options);

  /// Contracts until `target`, or until nothing is allowed; returns what was contracted, positions in model units.
  std::vector<Contraction> run(const DecimateTarget& target);

  std::uint64_t n_faces() const { return faces_.size(); }
  std::uint64_t n_vertices() const;

 private:
  struct Choice {
    double cost;
    Index low, high;
    Vec3 position;
    bool is_minimum;
  };
  PlacedQuadric placed(Index v) const { return {positions_[v], quadrics_[v]}; }
  std::vector<Choice> choices() const;
  bool keeps_topology(Index a, Index b) const;
  bool keeps_normals(Index v, Index other, const Vec3& to) const;
  bool is_locked(Index v) const { return !locked_.empty() && locked_[v]; }
  void contract(const Choice& choice, Index survivor, Index removed);

  DecimateOptions options_;
  Frame frame_;
  std::vector<Vec3> positions_;
  std::vector<Quadric> quadrics_;
  std::vector<bool> locked_;
  std::vector<Triangle> faces_;  ///< of the mesh as it now is, in the input's order
};

}  // namespace whittle::test
