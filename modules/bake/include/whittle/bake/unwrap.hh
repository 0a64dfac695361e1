#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bake {

/// The faces of a mesh laid out on a square image. No two overlap, up to rounding.
struct Unwrapping {
  std::vector<Index> charts;               ///< F; the chart of each face
  std::vector<Vec3> right;                 ///< Per chart, the unit direction along which the first coordinate grows.
  std::vector<Eigen::Vector2d> texcoords;  ///< 3F; of corner c of face f at 3f + c; [0, 1], rows go down as in glTF.
  double fill = 0;                         ///< Share of the image that faces cover, (0, 1].
};

/// Makes charts of connected faces that turn by less than 60° from an axis, projects each along its axis, and packs
/// them by rows, all at one scale: a face has at least half as many texels as one that lies across its axis. Between
/// two charts are 2 texels, or a 512th of the image if that is more. The result is the same on all machines.
/// \param mesh with a face that has an area; positions finite, an extent of at most 1e70
/// \param image_size texels along a side, a power of two from 16 on
/// \throw std::invalid_argument if the mesh has no area, or more charts than the image has room for
Unwrapping unwrap(const IndexedMesh& mesh, std::size_t image_size);

}  // namespace whittle::bake
