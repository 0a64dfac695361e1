#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "bench/max_error/contenders/contender.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// The coarsest result of a decimater that is near enough to the input.
struct Coarsest {
  std::size_t n_faces = 0;
  double amount = 0;  ///< that it was asked for
  int n_runs = 0;
  bool is_complete = true;  ///< false if the time didn't suffice for all of the search
};

struct Search {
  double max_error = 0;     ///< of all points, both ways, as `metrics::largest_distances` proves; model units
  double first_amount = 0;  ///< where it begins
  double accuracy = 0.01;   ///< of the amount, relative
  double limit_s = 1e9;     ///< after this no other run begins
};

/// Looks for it by bisection of the amount. The largest distance isn't monotone in it, so there may be a coarser one.
/// \return nothing if no result that was tried is near enough
std::optional<Coarsest> coarsest_within(const IndexedMesh& input, const Contender& contender, const Search& search);

}  // namespace whittle::bench
