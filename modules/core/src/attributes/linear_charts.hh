#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/local_functions.hh"

namespace whittle::detail {

/// The numbers of an attribute that may be linear in the position.
struct AttributeNumbers {
  std::span<const double> values;  ///< n_components per wedge of the input
  std::size_t n_components;
  std::size_t n;                                             ///< numbers a wedge
  std::function<double(Index wedge, std::size_t i)> number;  ///< i < n
  bool need_all;  ///< whether a chart is only linear if all of its numbers are
};

/// The charts (`attribute_charts`) of an input where a number is linear in the position: no farther from one function
/// than rounding to four digits of its range, or to the digits that all of the chart's numbers have.
struct LinearCharts {
  std::vector<Index> of_wedges;          ///< per wedge of the mesh; invalid_index: none
  std::vector<LocalFunction> functions;  ///< n per chart; those that are linear hold throughout it
};

LinearCharts find_linear_charts(const LocalFunctions& functions, const AttributeNumbers& numbers, unsigned threads);

}  // namespace whittle::detail
