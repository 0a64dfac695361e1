#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// What a surface carries besides its shape, as far as the page shows it.
enum class SurfaceAttribute : std::uint8_t {
  texcoord,  ///< The first set of texture coordinates; two numbers.
  color,     ///< Red, green and blue.
  normal     ///< The normals of the file.
};
inline constexpr std::array all_surface_attributes{SurfaceAttribute::texcoord, SurfaceAttribute::color,
                                                   SurfaceAttribute::normal};

bool has_attribute(const IndexedMesh& mesh, SurfaceAttribute attribute);

/// How far an attribute of a surface is from that of another surface, at each wedge.
///
/// At a wedge with position p and value a, the other surface's point q with the value b is looked at for which
/// |p − q|² + s² |a − b|² is least. The second term is small. It finds the right side of a seam or a crease, where one
/// position has several values. s is a hundredth of the diagonal of the other surface's box; of texture coordinates a
/// quarter of √(area of the other surface / its area in the texture). q is at most four mean edges of the coarser
/// surface farther away than the nearest point is.
struct AttributeMap {
  SurfaceAttribute attribute = SurfaceAttribute::texcoord;
  /// W. Of texture coordinates the length |a − b|, 1 is the whole texture; of colours the greatest difference of red,
  /// green and blue, in [0, 1]; of normals the angle, degrees. 0 for wedges without a face, and where a normal is zero.
  std::vector<double> deviations;
  double max = 0;    ///< greatest deviation
  double usual = 0;  ///< less has 99 % of the area, if each wedge stands for a third of its faces; at most `max`
};

/// \param threads 0 = all cores; the result doesn't depend on it
/// \pre both have the attribute \throw std::invalid_argument if one of them has no faces
AttributeMap attribute_map(SurfaceAttribute attribute, const IndexedMesh& mesh, const IndexedMesh& other,
                           unsigned threads = 0);

}  // namespace whittle::report
