#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// Per wedge, the first wedge of its vertex with the same value. \param values n_components per wedge
std::vector<Index> first_equal_wedges(const IndexedMesh& mesh, std::span<const double> values,
                                      std::size_t n_components);

/// As `attribute_charts`. \param firsts of `first_equal_wedges`
std::vector<Index> charts_of(const IndexedMesh& mesh, std::span<const Index> firsts);

}  // namespace whittle::detail
