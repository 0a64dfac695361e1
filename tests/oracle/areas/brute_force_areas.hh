#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle::test {

/// The areas between seams that keep a face as long as there is anything else to contract. They are found by walking
/// over edges, and each face of the input is looked at anew for each pair.
class BruteForceAreas {
 public:
  BruteForceAreas() = default;
  BruteForceAreas(const IndexedMesh& mesh, const DecimateOptions& options);

  /// Whether each area that has a face has one after contracting (a, b).
  bool keep_faces_without(Index a, Index b) const;
  void contract(Index survivor, Index removed);
  /// \return whether areas were kept until now
  bool give_up();

 private:
  std::vector<Triangle> faces_;  ///< those of the input that have an area, with their vertices now
  std::vector<Index> areas_;     ///< of each, a number
};

}  // namespace whittle::test
