#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/report.hh"
#include "terminal/talk.hh"
#include "whittle/progressive/replay.hh"

// The error of a run at its levels, from the input to the result.

namespace whittle::app {

struct CurvePoint {
  std::uint64_t n_faces, n_vertices;
  double max_cost;        ///< of the contractions so far, unit as `DecimateTarget::max_cost`
  double mean, rms, max;  ///< distances, sampled both ways, model units
};

/// The number of faces falls by a quarter from one point to the next. The first one is the input, the last one the
/// result, if that has faces. \param replay is left at the last level measured \param samples on each surface
std::vector<CurvePoint> measure_curve(progressive::Replay& replay, std::size_t samples, unsigned threads,
                                      const Talk& talk);

/// A line of names, then a line a point.
std::string curve_csv(const std::vector<CurvePoint>& curve);
/// A chart. \param name of the input
std::string curve_svg(const std::vector<CurvePoint>& curve, const std::string& name);
/// An array of {"faces", "vertices", "max_cost", "mean", "rms", "max"}
Json curve_json(const std::vector<CurvePoint>& curve);

}  // namespace whittle::app
