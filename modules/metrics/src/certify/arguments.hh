#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// \throw std::invalid_argument if it is negative or not a number
void require_distance(double max_distance);
/// \throw std::invalid_argument unless empty or one per vertex, all positive, and the distance finite
void require_tolerances(std::span<const double> tolerances, std::size_t n_vertices, double max_distance);
/// \throw std::invalid_argument if it has another length than the first mesh's vertices, or names others than the
/// second
///        mesh's and `invalid_index`
void require_vertex_map(std::span<const Index> vertex_map, std::size_t n_first, std::size_t n_second);
/// \throw std::invalid_argument if it is not in [1e-6, 1]
void require_accuracy(double relative_accuracy);

}  // namespace whittle::metrics
