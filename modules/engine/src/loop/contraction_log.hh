#pragma once

#include <span>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/run_steps.hh"

namespace whittle {

/// Where the output has a vertex that stands for one of the input. One that nothing moved keeps every bit, that of −0
/// too.
inline Vec3 to_output(const Vec3& in_frame, const Vec3& in_input, const Frame& frame) {
  return in_frame == frame.to_frame(in_input) ? in_input : frame.to_model(in_frame);
}

/// Where a loop writes down its contractions, if it does, by the surface's vertices and in the frame. There is room for
/// as many as there are vertices.
struct ContractionLog {
  Contraction* end = nullptr;

  void add(const Contraction& contraction) { *end++ = contraction; }
};

/// Tells contractions that a stage logged by the input's vertices, and in model units.
/// \param positions of the input \param origins vertices of the surface → those of the input; empty if they are the
/// same
void tell_by_input(std::span<const Vec3> positions, const Frame& frame, std::span<const Index> origins,
                   std::span<Contraction> log);

/// Adds lists of contractions that don't depend on those of other lists. The order is that of cost, or of the greatest
/// cost so far in the list, but for differences of less than a 16th.
void add_by_cost(std::span<const std::span<const Contraction>> lists, std::vector<Contraction>& all);

inline void end_pass(RunSteps& steps) { steps.pass_ends.push_back({steps.contractions.size(), {}, {}}); }

}  // namespace whittle
