#pragma once

#include <span>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Gives a decimated mesh the attributes of the input, as `decimate` does: each wedge has what the input has at the
/// place where the wedge is, on the same side of every seam (local_functions.hh); each face has what its origin has.
/// A wedge at the place of one merged into it has the value of that one, and a category is that of the nearest.
/// Normals that are computed anew are those of `vertex_normals`; `break_normals` lets them break at creases.
/// Faces that lie over another chart on a texture are drawn back (keep_in_charts.hh), but not where all vertices are
/// the input's, as in an index buffer.
/// \param frame of the input \param vertex_map, face_origins as those of `Decimation`
/// \param mesh has positions and faces. If the input has wedges, the corners of each face are in their first order
/// \param threads 0 = all cores; the result is the same for any number
/// \param keeps_in_charts whether faces are drawn back; `fit_attributes` does so, too
void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals, std::span<const Index> vertex_map,
                      std::span<const Index> face_origins, IndexedMesh& mesh, unsigned threads = 0,
                      bool keeps_in_charts = true);

/// The last step of a run with `Normals::recompute`: `recompute_normals`, where the mesh has normals. Nothing with
/// other `normals`. Wedges are other ones afterwards. \param frame of the input
void break_normals(const Frame& frame, Normals normals, double crease_angle_deg, IndexedMesh& mesh);

/// What each wedge of the input has become, or `invalid_index`. Two of them become one where an edge of a face that has
/// both was contracted, as in Hoppe's wedge meshes (\cite hoppe_1999_attributes): each side of a seam keeps its own.
/// \param vertex_map, face_origins as those of `Decimation`
std::vector<Index> wedge_map(const IndexedMesh& input, std::span<const Index> vertex_map,
                             std::span<const Index> face_origins);

}  // namespace whittle
