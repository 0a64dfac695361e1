#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "whittle/engine/detail/input_edges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// Polishes decimations of one mesh. Options come from `with_effort`.
class DecimationPolisher {
 public:
  /// Keeps a reference to the mesh.
  explicit DecimationPolisher(const IndexedMesh& mesh) : mesh_(mesh) {}

  /// Several threads may do so at once, each with a decimation of its own.
  PolishResult polish(const SimplifyOptions& options, Decimation& decimation);

 private:
  /// The input, prepared for polish.
  struct Input {
    PolishOriginal original;
    detail::InputEdges edges;
    std::vector<Index> regions;  ///< per face, or empty
    double diagonal;             ///< of its bounding box
  };

  void prepare(const DecimateOptions& options, const ProgressCallback& progress);
  PolishOptions polish_options(const SimplifyOptions& options, const Decimation& decimation) const;

  const IndexedMesh& mesh_;
  std::once_flag is_prepared_;
  std::optional<Input> input_;  ///< made on first use, when the mesh is known to be valid
};

}  // namespace whittle
