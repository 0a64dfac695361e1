#pragma once

#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// Deviation of an attribute from another surface's, per wedge (`metrics::attribute_deviations_at_wedges`). The page
/// interpolates between wedges.
struct AttributeMap {
  std::string name;  ///< "NORMAL", "COLOR_0", "TEXCOORD_0"
  AttributeKind kind = AttributeKind::texcoord;
  std::vector<double> deviations;  ///< W
  double max = 0;                  ///< largest deviation
  double usual = 0;  ///< upper bound for 99 % of the area, if a wedge stands for a third of its faces; at most `max`
};

/// Maps of normals, colours and texture coordinates that both meshes have.
/// \param threads 0 = all cores; the result is the same for any number
/// \throw std::invalid_argument if a mesh has no faces
std::vector<AttributeMap> attribute_maps(const IndexedMesh& mesh, const IndexedMesh& other, unsigned threads = 0);

}  // namespace whittle::report
