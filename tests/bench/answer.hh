#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::bench {

/// What answers are held against.
struct Question {
  const IndexedMesh& input;
  metrics::Topology topology;  ///< of the input
  double area;                 ///< of the input's faces, model units squared
  std::size_t n_faces;         ///< wanted
  std::size_t n_samples;       ///< of the distance; 0 = not measured
};
Question make_question(const IndexedMesh& input, std::size_t n_faces, std::size_t n_samples);

struct Answer {
  std::size_t n_faces = 0;
  bool is_manifold = false;
  std::optional<double> mean_error_rel;  ///< over the diagonal of the input's box
  std::optional<double> max_error_rel;
  /// Why it doesn't count: not the number of faces wanted, or on average far from the surface. Empty if it does.
  std::string problem;
  /// How the surface hangs together otherwise than before: not manifold any more, other parts, borders or handles.
  /// Empty if it doesn't, and for an input that isn't manifold.
  std::string defect;
};
Answer judged(const Question& question, const IndexedMesh& mesh);

}  // namespace whittle::bench
