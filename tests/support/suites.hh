#pragma once

#include <string>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

/// Small meshes by kind, for tests that loop over them: a few hundred faces at most, so brute force is fast.
namespace whittle::test {

struct NamedMesh {
  std::string name;  ///< The call that made it, for failure messages.
  IndexedMesh mesh;
};

/// Closed, manifold, oriented: organic shapes, shapes with sharp edges, different genera, several parts.
std::vector<NamedMesh> closed_meshes();
/// Manifold with a border (one of them not orientable).
std::vector<NamedMesh> open_meshes();
/// With edges of three or more faces, or vertices of several fans.
std::vector<NamedMesh> nonmanifold_meshes();
/// All of these.
std::vector<NamedMesh> all_meshes();

}  // namespace whittle::test
