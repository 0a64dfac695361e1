#pragma once

#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// How far an attribute of a surface is from that of another surface, at each wedge:
/// `metrics::attribute_deviations_at_wedges`. Between wedges, the page interpolates.
struct AttributeMap {
  std::string name;  ///< "NORMAL", "COLOR_0", "TEXCOORD_0"
  AttributeKind kind = AttributeKind::texcoord;
  std::vector<double> deviations;  ///< W
  double max = 0;                  ///< the greatest deviation
  double usual = 0;  ///< 99 % of the area have less, if a wedge stands for a third of its faces; at most `max`
};

/// Of normals, colours and texture coordinates, as far as both meshes have them. \param threads 0 = all cores; the
/// result doesn't depend on it \throw std::invalid_argument if one of them has no faces
std::vector<AttributeMap> attribute_maps(const IndexedMesh& mesh, const IndexedMesh& other, unsigned threads = 0);

}  // namespace whittle::report
