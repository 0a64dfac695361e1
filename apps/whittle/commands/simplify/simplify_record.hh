#pragma once

#include <string>
#include <vector>

#include "commands/recording/curve.hh"
#include "commands/recording/recording_input.hh"
#include "whittle/pipeline/run.hh"

namespace whittle::app {

/// The outcome of a run of `whittle simplify`, for its messages and its report.
struct SimplifyRecord {
  Plan plan;
  Outcome outcome;
  std::vector<CurvePoint> curve;      ///< if it is to be written
  std::string shortfall;              ///< if the target was missed: reason and remedy
  std::vector<std::string> warnings;  ///< in the order in which they were told
  double read_seconds = 0;
  double plan_seconds = 0;
  double curve_seconds = 0;
  double write_seconds = 0;
  double total_seconds = 0;

  double decimate_seconds() const { return plan_seconds + outcome.seconds.decimate; }
};

/// The input as recordings have it: with one normal and one colour a vertex.
inline IndexedMesh recorded_input(const SimplifyRecord& record) {
  return with_vertex_attributes(record.plan.scene.read.mesh);
}

}  // namespace whittle::app
