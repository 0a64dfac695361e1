#include "whittle/openmesh/detail/drivers/engine_run.hh"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/manifold_cut.hh"
#include "whittle/engine/attributes.hh"

namespace whittle {
namespace {

/// Counts vertices with a face.
std::uint64_t count_vertices(const IndexedMesh& mesh) {
  std::vector<bool> has_face(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) has_face[v] = true;
  }
  return static_cast<std::uint64_t>(std::count(has_face.begin(), has_face.end(), true));
}

struct Shape {
  std::size_t n_further_fans;  ///< fans beyond the first of each vertex
  std::ptrdiff_t euler_number;
  bool operator==(const Shape&) const = default;
};

Shape shape_of(const IndexedMesh& mesh) {
  const auto n_edges = static_cast<std::ptrdiff_t>(detail::EdgeTable(mesh.faces, mesh.positions.size()).size());
  const auto n_vertices = static_cast<std::ptrdiff_t>(count_vertices(mesh));
  const std::size_t n_further_fans = cut_into_manifold(mesh.positions.size(), mesh.faces).originals.size();
  return {n_further_fans, n_vertices - n_edges + static_cast<std::ptrdiff_t>(mesh.faces.size())};
}

}  // namespace

std::uint64_t EngineRun::n_vertices_of_input() const { return count_vertices(input_.mesh); }

/// What moves each vertex by d at most, moves each point of the surface by d at most.
DecimateTarget EngineRun::target_before_rounding(double epsilon) const {
  const double surface = *target_.error_limit();
  const double border = *target_.border_error_limit();
  double farthest = surface;  // a vertex may move outwards
  for (const Vec3& p : input_.mesh.positions) farthest = std::max(farthest, p.cwiseAbs().maxCoeff() + surface);
  // Each of three coordinates is rounded by half of epsilon at most: √3 / 2 in all.
  const double rounding = farthest * epsilon;
  const auto is_too_small = [rounding](double limit) { return limit > 0 && limit <= rounding; };
  if (is_too_small(surface) || is_too_small(border)) {
    throw std::invalid_argument("PairDecimaterT: max_error is less than rounding may move a vertex of the mesh");
  }
  return target_.or_max_error(surface - rounding, border - rounding);
}

/// Without threshold pairs and copies they are, with one exception: vertices with several open fans, which OpenMesh can
/// hold. There the engine may also join two border edges or part a fan. Joining increases the Euler number, and never
/// the number of fans. Parting keeps the Euler number and adds a fan. So both are noticed.
bool EngineRun::are_collapses(const Decimation& small, const std::vector<Index>& firsts) const {
  if (small.result.threshold_pairs.contracted > 0 || small.result.n_coincident_faces > 0) return false;
  if (!firsts.empty()) return false;
  if (small.result.before.nonmanifold_vertices == 0) return true;
  return shape_of(input_.mesh) == shape_of(small.mesh);
}

std::vector<EngineRun::Copy> EngineRun::collapse(const Decimation& small) {
  BulkCollapse(connectivity_, merges_).run();
  std::vector<Copy> vertices;
  vertices.reserve(small.mesh.origins.size());
  for (Index v = 0; v < small.mesh.origins.size(); ++v) {
    vertices.push_back({v, VertexHandle(static_cast<int>(small.mesh.origins[v]))});
  }
  return vertices;
}

std::vector<EngineRun::Copy> EngineRun::relink(const Decimation& small, const std::vector<Index>& firsts) {
  JoinedFaces joined;
  joined.vertex_handles = small.mesh.origins;
  joined.faces = small.mesh.faces;
  joined.first_copies = firsts;
  joined.vertex_of.assign(connectivity_.n_vertices(), invalid_index);
  for (const VertexHandle v : connectivity_.vertices()) {
    const auto place = static_cast<std::size_t>(v.idx());
    if (!connectivity_.is_isolated(v)) joined.vertex_of[place] = small.vertex_map[input_.number(v)];
  }
  std::vector<Index> face_handles;
  for (const OpenMesh::FaceHandle f : connectivity_.faces()) face_handles.push_back(static_cast<Index>(f.idx()));
  for (const Index f : small.face_origins) joined.face_handles.push_back(face_handles[f]);
  return FaceRelinker(connectivity_, joined).run();
}

IndexedMesh EngineRun::vertex_attributes_of(const Decimation& small, unsigned threads) const {
  IndexedMesh before;
  IndexedMesh after;
  if (attributes_.empty()) return after;
  before.positions = input_.mesh.positions;
  before.faces = input_.mesh.faces;
  attributes_.add_to(before, connectivity_, input_.numbers.handles);
  after.positions = small.mesh.positions;
  after.faces = small.mesh.faces;
  carry_attributes(before, Frame::of_points(before.positions), Normals::keep, small.vertex_map, small.face_origins,
                   after, threads);
  return after;
}

std::vector<Index> EngineRun::vertices_by_handle(const std::vector<Copy>& vertices) const {
  std::vector<Index> result(connectivity_.n_vertices(), invalid_index);
  for (const auto& [vertex, handle] : vertices) result[static_cast<std::size_t>(handle.idx())] = vertex;
  return result;
}

std::vector<bool> EngineRun::merged_vertices(const std::vector<Copy>& vertices,
                                             const std::vector<Index>& origins) const {
  std::vector<bool> is_merged(connectivity_.n_vertices());
  for (const VertexMerge& merge : merges_) is_merged[static_cast<std::size_t>(merge.survivor.idx())] = true;
  for (const auto& [vertex, handle] : vertices) {
    is_merged[static_cast<std::size_t>(handle.idx())] = is_merged[origins[vertex]];
  }
  return is_merged;
}

}  // namespace whittle
