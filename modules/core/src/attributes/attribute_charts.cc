#include "attributes/attribute_charts.hh"

#include <algorithm>
#include <numeric>

#include "whittle/core/attribute_functions.hh"
#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/wedges.hh"

namespace whittle {

std::vector<Index> detail::first_equal_wedges(const IndexedMesh& mesh, std::span<const double> values,
                                              std::size_t n_components) {
  const auto value = [&](Index w) { return values.subspan(w * n_components, n_components); };
  std::vector<Index> firsts(values.size() / n_components);
  std::iota(firsts.begin(), firsts.end(), Index{0});
  const IndexLists<Index> wedges = wedges_of_vertices(mesh);
  for (Index v = 0; v < wedges.size(); ++v) {
    const std::span<const Index> of = wedges.of(v);
    for (const Index w : of) {
      const auto is_equal = [&](Index a) { return std::equal(value(a).begin(), value(a).end(), value(w).begin()); };
      const auto first = std::find_if(of.begin(), of.end(), is_equal);
      if (first != of.end()) firsts[w] = *first;  // a NaN equals nothing
    }
  }
  return firsts;
}

std::vector<Index> detail::charts_of(const IndexedMesh& mesh, std::span<const Index> firsts) {
  std::vector<Index> charts(firsts.size());
  DisjointSets<Index> sets(charts.size());
  for (Index w = 0; w < charts.size(); ++w) sets.join(w, firsts[w]);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 1; k < 3; ++k) sets.join(mesh.wedge(f, 0), mesh.wedge(f, k));
  }
  for (Index w = 0; w < charts.size(); ++w) charts[w] = sets.find(w);
  return charts;
}

std::vector<Index> attribute_charts(const IndexedMesh& mesh, std::span<const double> values, std::size_t n_components) {
  return detail::charts_of(mesh, detail::first_equal_wedges(mesh, values, n_components));
}

}  // namespace whittle
