#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

// Taking part in a decimation from outside the engine. A host refuses contractions, ranks pairs in the place of a cost,
// follows each contraction, and may go on from where an earlier run ended. `PairDecimaterT` is one: it lets the modules
// of an OpenMesh mesh take part, and makes the same contractions on that mesh.

namespace whittle {

/// A contraction that may be made, or was. Vertices are numbers of the input, positions and costs in the frame.
struct HostedContraction {
  Index first, second;         ///< the pair; first has the lower number, but under `stays_at_vertices`
  Index survivor, removed;     ///< one is first, the other second
  std::array<Vec3, 2> before;  ///< where first and second were
  PairEvaluation rank;         ///< what the pair was ranked by
  Vec3 position;               ///< of the merged vertex
};

/// Positions to try for a merged vertex, the best first.
struct CandidatePositions {
  struct Option {
    Vec3 position;
    Index survivor = invalid_index;  ///< if not given, the higher origin, or the vertex that may not move
  };
  std::array<Option, 2> options;
  std::size_t n = 0;

  void add(const Vec3& position, Index survivor = invalid_index) { options[n++] = {position, survivor}; }
};

/// A cost outside the engine. Edges only.
class HostedCost {
 public:
  virtual ~HostedCost() = default;

  /// What merging two vertices would cost. Infinite, negative or not a number: they may not be merged as things are.
  virtual PairEvaluation rank(Index first, Index second, PairConstraint constraint) = 0;
  /// Where the merged vertex goes. None means that the pair is refused.
  virtual CandidatePositions place(Index first, Index second, PairConstraint constraint,
                                   const PairEvaluation& rank) = 0;
  /// What going there costs: the rank, or more. Infinite, negative or not a number refuses the pair; the host counts
  /// that.
  virtual double final_cost(const HostedContraction& contraction) = 0;
  /// Which pairs a contraction may make cheaper, or allow.
  virtual Reach reach() const = 0;
  /// Whether each merged vertex goes to where one of the two is, which survives then.
  virtual bool stays_at_vertices() const { return false; }
  /// The power of a length that is the unit of costs.
  virtual double dimension() const = 0;
};

/// Where an earlier run ended, to go on from.
struct DecimationState {
  Frame frame;
  std::vector<PlacedQuadric> vertices;  ///< of the mesh, in the frame
  MeanFaceArea face_area;               ///< of memoryless quadrics
};

class DecimationHost {
 public:
  virtual ~DecimationHost() = default;

  /// Whether it makes the same contractions on a half-edge mesh: then none may change the topology.
  virtual bool keeps_topology() const { return false; }
  /// Whether `refuses` may ever say so. If not, it isn't asked, which saves time.
  virtual bool may_refuse() const { return true; }
  /// Whether it refuses what is to be done.
  virtual bool refuses(const HostedContraction& /*contraction*/) { return false; }
  /// Told that a pair was refused for what `refuses` refused last.
  virtual void count_refusal() {}
  /// Told after each contraction. \param contraction the same in model units \return false to end the run
  virtual bool follow([[maybe_unused]] const HostedContraction& made, [[maybe_unused]] const Contraction& contraction) {
    return true;
  }
  /// A cost in the place of the engine's; null for none.
  virtual HostedCost* cost() { return nullptr; }
  /// What to go on from; null to begin anew.
  virtual const DecimationState* state() const { return nullptr; }
};

/// `decimate` with a host. \throw as `decimate`
Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                    DecimationHost& host);

}  // namespace whittle
