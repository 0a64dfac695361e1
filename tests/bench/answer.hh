#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::bench {

/// What answers are compared with.
struct Question {
  const IndexedMesh& input;
  metrics::Topology topology;  ///< of the input
  double area;                 ///< of the input's faces, model units squared
  std::size_t n_faces;         ///< of the result
  std::size_t n_samples;       ///< of the distance; 0 = not measured
};
Question make_question(const IndexedMesh& input, std::size_t n_faces, std::size_t n_samples);

struct Answer {
  std::size_t n_faces = 0;
  bool is_manifold = false;
  std::optional<double> mean_error_rel;  ///< over the diagonal of the input's bounding box
  std::optional<double> max_error_rel;
  /// Why the answer doesn't count: the number of faces is wrong, or the mean distance to the surface is large. Empty if
  /// it counts.
  std::string problem;
  /// How the topology has changed: no longer manifold, or other parts, borders or handles. Empty if it hasn't changed,
  /// and if the input isn't manifold.
  std::string defect;
};
Answer judged(const Question& question, const IndexedMesh& mesh);

}  // namespace whittle::bench
