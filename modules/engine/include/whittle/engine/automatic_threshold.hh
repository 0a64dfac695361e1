#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A threshold at which the parts of a mesh that lie near one another can be joined: a tenth above the widest of the
/// gaps by which a part is apart from the one nearest to it. A gap wider than the part itself, or than a twentieth of
/// the mesh (the diagonals of their bounding boxes) doesn't count: that part is no neighbour of any.
/// \param threads 0 = all cores; the result is the same
/// \return model units; 0 where there is one part only, or none near another
/// \throw std::invalid_argument for a vertex number out of range or a coordinate that isn't finite.
double automatic_threshold(const IndexedMesh& mesh, unsigned threads = 0);

}  // namespace whittle
