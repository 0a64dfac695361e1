#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/corner_properties.hh"

namespace whittle {

/// The input that `PairDecimaterT` gives the engine.
struct RunInput {
  using IsFixed = std::function<bool(OpenMesh::VertexHandle)>;

  detail::VertexNumbers numbers;     ///< handles of the vertices of `mesh`, and the reverse
  IndexedMesh mesh;                  ///< positions and faces, and what corners carry
  std::vector<VertexPair> features;  ///< edges with the feature bit, ascending
  std::vector<std::uint8_t> locked;  ///< by vertex, or empty if none is

  /// \param is_fixed whether the vertex may neither move nor vanish
  template <class MeshT>
  RunInput(const MeshT& source, Copies copies, const IsFixed& is_fixed)
      : numbers(detail::number_vertices(source, copies)), mesh(detail::geometry_of(source, numbers)), corners_(source) {
    add_rest(source, is_fixed);
  }

  OpenMesh::VertexHandle handle(Index v) const { return OpenMesh::VertexHandle(static_cast<int>(numbers.handles[v])); }
  Index number(OpenMesh::VertexHandle v) const { return numbers.number_of[static_cast<std::size_t>(v.idx())]; }

  /// Gives the corners that are left what they have become, fitted to what they were (`fit_attributes`).
  /// \param vertex_of by handle, the vertex of `small.mesh` \param threads 0 = all cores
  void write_corners(Decimation& small, std::span<const Index> vertex_of, unsigned threads,
                     OpenMesh::ArrayKernel& to) const;

 private:
  void add_rest(const OpenMesh::TriConnectivity& source, const IsFixed& is_fixed);
  std::vector<VertexPair> find_features(const OpenMesh::TriConnectivity& source) const;
  std::vector<std::uint8_t> find_locked(const OpenMesh::TriConnectivity& source, const IsFixed& is_fixed) const;

  CornerProperties corners_;
  std::vector<Index> face_handles_;  ///< of the faces of `mesh`, if corners carry something
};

/// Counts the vertices that have a face; copies count as one. \param firsts of copies (`first_copies`)
std::uint64_t count_vertices(const OpenMesh::TriConnectivity& mesh, const std::vector<Index>& firsts);

}  // namespace whittle
