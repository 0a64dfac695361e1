#include "cost/attributes/surface_attributes.hh"

#include <algorithm>

namespace whittle {

SurfaceAttributes SurfaceAttributes::at(std::span<const Index> vertices) const {
  std::vector<Index> chosen;
  SurfaceAttributes some;
  auto next = vertex_of.begin();
  for (Index i = 0; i < vertices.size(); ++i) {
    next = std::lower_bound(next, vertex_of.end(), vertices[i]);
    for (; next != vertex_of.end() && *next == vertices[i]; ++next) {
      chosen.push_back(static_cast<Index>(next - vertex_of.begin()));
      some.vertex_of.push_back(i);
    }
  }
  some.wedges = wedges.gathered(chosen);
  some.farthest = farthest;
  return some;
}

}  // namespace whittle
