#pragma once

#include <iosfwd>
#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

/// Counts from the face list alone, with sorted containers and simple code: the oracle for faster code. Coincident
/// vertices stay separate; every duplicate face is counted.
struct Topology {
  int vertices = 0;  ///< Referenced by a face.
  int edges = 0;     ///< Different pairs of corners.
  int faces = 0;
  int components = 0;  ///< Of vertices connected by edges.
  int border_edges = 0;
  int border_loops = 0;  ///< Connected sets of border edges.
  int nonmanifold_edges = 0;
  int nonmanifold_vertices = 0;  ///< Whose opposite edges form neither one path nor one circle.
  int misoriented_edges = 0;     ///< Two faces that run along the edge in the same direction.
  int degenerate_faces = 0;      ///< With two equal corners; left out of all counts except `faces`.

  [[nodiscard]] int euler() const { return vertices - edges + faces - degenerate_faces; }
  [[nodiscard]] bool closed() const { return border_edges == 0; }
  [[nodiscard]] bool manifold() const { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
  /// Sum over the parts. Meaningful only if closed, manifold and without misoriented edges.
  [[nodiscard]] int genus() const { return components - euler() / 2; }

  bool operator==(const Topology&) const = default;
};

Topology topology(const IndexedMesh& mesh);
std::ostream& operator<<(std::ostream& out, const Topology& topology);

/// Volume inside a closed mesh; positive if the mesh is oriented outwards.
double signed_volume(const IndexedMesh& mesh);
double surface_area(const IndexedMesh& mesh);

}  // namespace whittle::test
