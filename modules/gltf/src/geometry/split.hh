#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/surface.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// The faces of one primitive in a mesh, over vertices of its own.
struct Piece {
  std::size_t primitive = 0;
  std::vector<Triangle> faces;
  std::vector<Index> vertices;  ///< that of the mesh, for each of this primitive
  std::vector<Index> wedges;    ///< likewise
};

/// \throw std::invalid_argument if the mesh can't replace the triangles of that number (`Asset::set_triangles`)
void check_replacement(const Model& model, std::size_t mesh, const IndexedMesh& triangles);

/// Which primitives have faces in a mesh.
std::vector<bool> primitives_with_faces(const Mesh& mesh, const IndexedMesh& triangles);
/// Which primitives lose all the triangles that they had.
std::vector<bool> lost_primitives(const Model& model, const Mesh& mesh, const IndexedMesh& triangles);

/// The primitives that have faces, ascending. Their vertices are in the order of the wedges.
std::vector<Piece> split_by_primitive(const Mesh& mesh, const IndexedMesh& triangles);

/// The values of a primitive's channel at each vertex of its piece, as many components as its accessor has. Empty if
/// the mesh has no such attribute. Weights have the sum 1; if the accessor's type is an integer, they are its
/// multiples.
std::optional<std::vector<double>> values_of(const Model& model, const Mesh& mesh, const IndexedMesh& triangles,
                                             const Piece& piece, const Channel& channel, const Accessor& accessor);

}  // namespace whittle::gltf
