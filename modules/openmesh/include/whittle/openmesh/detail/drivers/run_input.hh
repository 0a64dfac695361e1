#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "whittle/engine/attributes.hh"
#include "whittle/engine/host.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/corner_attributes.hh"
#include "whittle/openmesh/detail/status_bits.hh"
#include "whittle/polish/fit_attributes.hh"

namespace whittle {

/// The input that `PairDecimaterT` gives the engine.
template <class MeshT>
struct RunInputT {
  detail::VertexNumbers numbers;     ///< handles of the vertices of `mesh`, and the reverse
  IndexedMesh mesh;                  ///< positions and faces, and what corners carry
  std::vector<VertexPair> features;  ///< edges with the feature bit, ascending
  std::vector<std::uint8_t> locked;  ///< by vertex, or empty if none is
  CornerAttributesT<MeshT> corners;

  /// \param is_fixed handle → whether the vertex may neither move nor vanish
  template <class IsFixed>
  RunInputT(const MeshT& source, Copies copies, const IsFixed& is_fixed)
      : numbers(detail::number_vertices(source, copies)),
        mesh(detail::geometry_of(source, numbers)),
        features(find_features(source)),
        locked(find_locked(source, is_fixed)),
        corners(source) {
    add_wedges(source, corners, mesh);
    if (corners.empty()) return;
    const StatusBitsT<OpenMesh::FaceHandle, const MeshT> bits(source);
    for (int i = 0; i < static_cast<int>(source.n_faces()); ++i) {
      if (!bits.is_deleted(OpenMesh::FaceHandle(i))) face_handles_.push_back(static_cast<Index>(i));
    }
  }

  OpenMesh::VertexHandle handle(Index v) const { return OpenMesh::VertexHandle(static_cast<int>(numbers.handles[v])); }
  Index number(OpenMesh::VertexHandle v) const { return numbers.number_of[static_cast<std::size_t>(v.idx())]; }

  /// Gives the corners that are left what they have become, fitted to what they were (`fit_attributes`).
  /// \param vertex_of by handle, the vertex of `small.mesh` \param threads 0 = all cores
  void write_corners(Decimation& small, std::span<const Index> vertex_of, unsigned threads, MeshT& to) const {
    if (corners.empty() || small.result.n_contractions == 0) return;
    fit_attributes(mesh, wedge_map(mesh, small.vertex_map, small.face_origins), small.mesh, {.threads = threads});
    std::vector<Index> handles;
    handles.reserve(small.face_origins.size());
    for (const Index f : small.face_origins) handles.push_back(face_handles_[f]);
    set_corners(small.mesh, handles, vertex_of, corners, to);
  }

 private:
  std::vector<Index> face_handles_;  ///< of the faces of `mesh`, if corners carry something

  /// Several edges may join copies of the same two vertices: the pair is listed once.
  std::vector<VertexPair> find_features(const MeshT& source) const {
    std::vector<VertexPair> result;
    const StatusBitsT<OpenMesh::EdgeHandle, const MeshT> bits(source);
    for (int i = 0; i < static_cast<int>(source.n_edges()); ++i) {
      const OpenMesh::EdgeHandle e(i);
      if (bits[e].deleted() || !bits[e].feature()) continue;
      const auto [low, high] = std::minmax({number(source.to_vertex_handle(source.halfedge_handle(e, 0))),
                                            number(source.to_vertex_handle(source.halfedge_handle(e, 1)))});
      result.push_back({low, high});
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// A vertex is locked if any of its copies is. A vertex with the feature bit is locked unless it lies on a feature
  /// line.
  template <class IsFixed>
  std::vector<std::uint8_t> find_locked(const MeshT& source, const IsFixed& is_fixed) const {
    std::vector<Index> n_features(mesh.positions.size());
    for (const auto& [a, b] : features) {
      ++n_features[a];
      ++n_features[b];
    }
    std::vector<std::uint8_t> result(mesh.positions.size());
    bool any = false;
    for (const OpenMesh::VertexHandle v : source.vertices()) {
      const bool is_point = source.status(v).feature() && n_features[number(v)] != 2;
      if (!is_point && !is_fixed(v)) continue;
      result[number(v)] = 1;
      any = true;
    }
    if (!any) result.clear();
    return result;
  }
};

}  // namespace whittle
