#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// A decimater that doesn't take the largest distance as its target, but something that grows or shrinks with it.
struct Contender {
  enum class Amount {
    faces,  ///< of the result; fewer are coarser
    length  ///< model units, whatever the decimater takes it for; more is coarser
  };
  std::string name;
  Amount takes;
  /// \throw std::runtime_error if it can't hold the mesh
  std::function<IndexedMesh(const IndexedMesh& input, double amount)> decimate;
};

/// The names `make_contender` knows: those that take a length, meshlab, and all peers (`peer_names`).
std::vector<std::string> contender_names();
/// \throw std::invalid_argument for a name that isn't among them
Contender make_contender(std::string_view name);

// One file for each.
IndexedMesh by_openmesh_hausdorff(const IndexedMesh& input, double length);
IndexedMesh by_meshoptimizer_error(const IndexedMesh& input, double length);
IndexedMesh by_cgal_envelope(const IndexedMesh& input, double length);
IndexedMesh by_meshlab(const IndexedMesh& input, double n_faces);

}  // namespace whittle::bench
