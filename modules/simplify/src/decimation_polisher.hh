#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/engine/detail/input_edges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// Polishes decimations of one mesh, as options say that `with_effort` has settled.
class DecimationPolisher {
 public:
  /// Keeps a reference to the mesh.
  explicit DecimationPolisher(const IndexedMesh& mesh) : mesh_(mesh) {}

  /// \param held a vertex of the decimation, 1 if it is to stay where it is; or empty
  PolishResult polish(const SimplifyOptions& options, Decimation& decimation,
                      const std::vector<std::uint8_t>& held = {});

 private:
  /// What polish looks up about the input.
  struct Input {
    PolishOriginal original;
    detail::InputEdges edges;
    std::vector<Index> regions;  ///< of its faces, or empty
    double diagonal;             ///< of its bounding box
  };

  PolishOptions polish_options(const SimplifyOptions& options, const std::vector<std::uint8_t>& held,
                               const Decimation& decimation) const;

  const IndexedMesh& mesh_;
  std::optional<Input> input_;  ///< made when it is needed
};

}  // namespace whittle
