#pragma once

#include <functional>
#include <vector>

#include "pictures/draw_meshes.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::app {

/// A mesh with a value at each vertex, which is linear on each face.
struct ValueMesh {
  IndexedMesh mesh;
  std::vector<double> values;
};

/// How long an edge looks, in pixels. \param a, b its ends
using SeenLength = std::function<double(const Vec3& a, const Vec3& b)>;

/// Signed distances to another surface, exact at vertices that are at most `most_pixels` apart.
/// \param distances from where faces are cut on \param threads 0 = all cores
ValueMesh exact_distances(const ShownDistances& distances, const IndexedMesh& other, const SeenLength& seen_length,
                          double most_pixels, unsigned threads);

}  // namespace whittle::app
