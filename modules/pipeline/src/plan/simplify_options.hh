#pragma once

#include "whittle/pipeline/request.hh"

namespace whittle {

/// The options of a request, but for what depends on the mesh or the effort.
inline SimplifyOptions simplify_options(const Request& request) {
  SimplifyOptions options = request.simplify;
  options.decimate.refuse_intersections = request.self_intersections == SelfIntersections::refuse;
  if (request.decimater && !options.decimate.cost) options.decimate.cost = Cost::quadric;
  return options;
}

}  // namespace whittle
