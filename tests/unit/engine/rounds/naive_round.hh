#pragma once

#include <span>
#include <vector>

#include "oracle/brute_force_attributes.hh"
#include "rounds/cost_counts.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/options.hh"

namespace whittle::test {

/// One contraction of a round.
struct NaiveContraction {
  Index survivor, removed;
  Vec3 position;
};

/// What a round contracts of a closed manifold mesh: the definition, step by step. All is computed from the faces as
/// they are, each time.
/// \param options their placement and valence weight count
/// \param attributes of the mesh, or none; they become those of the result
std::vector<NaiveContraction> naive_round(const IndexedMesh& mesh, const DecimateOptions& options,
                                          const MeanFaceArea& area, const RoundLimit& limit,
                                          BruteForceAttributes& attributes);

}  // namespace whittle::test
