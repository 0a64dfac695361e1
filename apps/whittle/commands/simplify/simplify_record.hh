#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "commands/recording/curve.hh"
#include "commands/recording/recording_input.hh"
#include "commands/regions/regions.hh"
#include "commands/simplify/as_written.hh"
#include "files/input.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::app {

struct SimplifySeconds {
  double read = 0;
  double decimate = 0;
  double polish = 0;
  double certify = 0;
  double curve = 0;
  double write = 0;
  double total = 0;
};

/// What a run of `whittle simplify` has done, and what its messages and its report say of that.
struct SimplifyRecord {
  Input input;
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  std::vector<DecimateTarget> targets_per_mesh;  ///< with --per-mesh; `target` is their sum then
  double diagonal = 0;                           ///< of the input's bounding box
  std::vector<double> tolerances;                ///< of the input's vertices, model units; or empty
  std::vector<std::uint8_t> held;                ///< vertices that stay (`held_borders`); or empty
  std::size_t n_pruned_parts = 0;
  double threshold = 0;  ///< of threshold pairs, model units; 0 = none
  Simplification simplified;
  Vanished vanished;
  std::optional<DistancesAsWritten> distances;  ///< if they are to be proven
  std::string certificate;                      ///< if it is to be written
  bool met = false;
  std::optional<std::size_t> n_intersections_before;  ///< pairs of faces, if they were counted
  std::optional<std::size_t> n_intersections_after;
  std::vector<CurvePoint> curve;  ///< if it is to be written
  std::string shortfall;          ///< if the target was missed: why, and what helps
  std::vector<std::string> warnings;
  SimplifySeconds seconds;
};

/// The input as recordings have it: with one normal and one colour a vertex.
inline IndexedMesh recorded_input(const SimplifyRecord& record) {
  return with_vertex_attributes(record.input.read.mesh);
}

}  // namespace whittle::app
