#include "whittle/openmesh/detail/drivers/run_input.hh"

#include <algorithm>

#include "whittle/engine/attributes.hh"
#include "whittle/openmesh/detail/status_bits.hh"
#include "whittle/polish/fit_attributes.hh"

namespace whittle {

void RunInput::add_rest(const OpenMesh::TriConnectivity& source, const IsFixed& is_fixed) {
  features = find_features(source);
  locked = find_locked(source, is_fixed);
  add_wedges(source, corners_, mesh);
  if (corners_.empty()) return;
  for (const OpenMesh::FaceHandle f : source.faces()) face_handles_.push_back(static_cast<Index>(f.idx()));
}

/// Several edges may join copies of the same two vertices: the pair is listed once.
std::vector<VertexPair> RunInput::find_features(const OpenMesh::TriConnectivity& source) const {
  std::vector<VertexPair> result;
  const ConstStatusBits<OpenMesh::EdgeHandle> bits(source);
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
std::vector<std::uint8_t> RunInput::find_locked(const OpenMesh::TriConnectivity& source,
                                                const IsFixed& is_fixed) const {
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

void RunInput::write_corners(Decimation& small, std::span<const Index> vertex_of, unsigned threads,
                             OpenMesh::ArrayKernel& to) const {
  if (corners_.empty() || small.result.n_contractions == 0) return;
  fit_attributes(mesh, wedge_map(mesh, small.vertex_map, small.face_origins), small.mesh, {.threads = threads});
  std::vector<Index> handles;
  handles.reserve(small.face_origins.size());
  for (const Index f : small.face_origins) handles.push_back(face_handles_[f]);
  set_corners(small.mesh, handles, vertex_of, corners_, to);
}

std::uint64_t count_vertices(const OpenMesh::TriConnectivity& mesh, const std::vector<Index>& firsts) {
  std::uint64_t n = 0;
  std::vector<bool> has_face(firsts.size());
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    if (!firsts.empty()) {
      const Index first = firsts[static_cast<std::size_t>(v.idx())];
      if (has_face[first]) continue;
      has_face[first] = true;
    }
    ++n;
  }
  return n;
}

}  // namespace whittle
