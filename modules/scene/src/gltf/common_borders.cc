// Borders of meshes of a glTF file that coincide in the scene. The file rounds each mesh's coordinates, and nodes, to
// 32 bits, so coincident points may lie a little apart.
#include <algorithm>
#include <cstddef>
#include <span>

#include "gltf/gltf_file.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/pieces.hh"
#include "whittle/core/text/text.hh"
#include "whittle/core/transform.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/border_gaps.hh"

namespace whittle {
namespace {

/// Largest number of faces of a scene to check: copies can multiply it without end.
constexpr std::size_t most_faces = std::size_t{1} << 24;

/// Welds between copies: for each vertex the first one of its group; itself if it is the first, or if its copy has
/// another vertex in the group. Vertices of one mesh stay apart.
/// \param welded a number for each group, or `invalid_index`
/// \param copies of the vertices
std::vector<Index> joined_across(const std::vector<Index>& welded, const std::vector<Index>& copies) {
  std::vector<Index> by_group;
  std::vector<Index> joined(welded.size());
  for (Index v = 0; v < welded.size(); ++v) {
    joined[v] = v;
    if (welded[v] != invalid_index) by_group.push_back(v);
  }
  std::stable_sort(by_group.begin(), by_group.end(), [&](Index a, Index b) { return welded[a] < welded[b]; });
  std::vector<Index> copies_in_group;
  for (std::size_t i = 0, first = 0; i < by_group.size(); ++i) {
    const Index v = by_group[i];
    if (welded[v] != welded[by_group[first]]) first = i;
    if (i == first) copies_in_group.clear();
    if (std::find(copies_in_group.begin(), copies_in_group.end(), copies[v]) != copies_in_group.end()) continue;
    copies_in_group.push_back(copies[v]);
    joined[v] = by_group[first];
  }
  return joined;
}

}  // namespace

/// Four times the error of rounding a coordinate to 24 bits.
double GltfFile::border_tolerance(const IndexedMesh& mesh) const {
  return 0x1p-22 * std::max(reach_, diagonal_of(mesh.positions));
}

/// A copy of a mesh in the whole that has a volume: others may lie folded on themselves.
std::vector<Index> GltfFile::copies_of_vertices(std::size_t n_vertices) const {
  std::vector<Index> copies(n_vertices, invalid_index);
  for (Index i = 0; i < copies_.size(); ++i) {
    if (copies_[i].is_flat) continue;
    const std::size_t end = i + 1 < copies_.size() ? copies_[i + 1].first_vertex : n_vertices;
    std::fill(copies.begin() + copies_[i].first_vertex, copies.begin() + static_cast<std::ptrdiff_t>(end), i);
  }
  return copies;
}

void GltfFile::weld_borders(const io::ReadOptions& options, io::ReadResult& all) {
  if (!options.weld || copies_.size() < 2 || all.mesh.faces.empty()) return;
  const std::vector<Index> copies = copies_of_vertices(all.mesh.positions.size());
  IndexedMesh bare = without_attributes(all.mesh);
  std::erase_if(bare.faces, [&](const Triangle& face) { return copies[face[0]] == invalid_index; });
  if (bare.faces.empty()) return;
  std::vector<Index> welded;
  io::weld_gaps(bare, border_tolerance(all.mesh), &welded, options.threads);
  const std::vector<Index> joined = joined_across(welded, copies);
  std::size_t n_joined = 0;
  for (Index v = 0; v < joined.size(); ++v) n_joined += joined[v] != v ? 1 : 0;
  if (n_joined == 0) return;
  const std::vector<Index> origins = all.mesh.origins;
  const std::vector<Index> map = join_vertices(all.mesh, joined);
  all.repairs.welded_vertices += n_joined;
  for (Index& v : all.vertex_map) v = v == invalid_index ? v : map[v];
  if (scope_ != SceneScope::scene) remember_welded(origins, map, all.mesh);
}

/// \param origins of the vertices before \param map the vertex of `mesh` for each
void GltfFile::remember_welded(const std::vector<Index>& origins, const std::vector<Index>& map,
                               const IndexedMesh& mesh) {
  std::size_t i = 0;
  for (std::size_t v = 0; v < map.size(); ++v) {
    while (i + 1 < parts_.size() && origins[v] >= parts_[i + 1].first_origin) ++i;
    if (mesh.origins[map[v]] == origins[v]) continue;
    const auto file_vertex = static_cast<Index>(origins[v] - parts_[i].first_origin);
    parts_[i].welded.push_back({mesh.origins[map[v]], file_vertex, mesh.positions[map[v]]});
  }
  for (Part& part : parts_) {
    std::stable_sort(part.welded.begin(), part.welded.end(),
                     [](const Part::Welded& a, const Part::Welded& b) { return a.origin < b.origin; });
  }
}

/// Each mesh as often as the scene shows it. \param copied gets an entry for each vertex
IndexedMesh GltfFile::scene_of(const IndexedMesh& mesh, std::vector<CopiedVertex>& copied) const {
  const std::vector<MeshPiece> pieces = split_mesh(without_attributes(mesh), meshes_of_faces(mesh), parts_.size());
  IndexedMesh scene;
  Index n_copies = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::vector<Eigen::Affine3d> places = places_of(parts_[i].mesh);
    for (Eigen::Affine3d place : places) {
      place.translation() -= scene_origin_;
      const Eigen::Affine3d from_whole = place * parts_[i].place.inverse();
      if (!from_whole.matrix().allFinite()) continue;
      IndexedMesh copy = pieces[i].mesh;
      transform_mesh(copy, from_whole);
      append_mesh(scene, std::move(copy));
      for (const Index v : pieces[i].vertices) copied.push_back({v, n_copies, places.size() > 1});
      ++n_copies;
    }
  }
  return scene;
}

std::vector<std::uint8_t> GltfFile::held_borders(const IndexedMesh& mesh, unsigned threads) const {
  std::size_t n_faces = 0;
  bool has_repeated = false;
  for (const Part& part : parts_) {
    const std::size_t n = asset_.n_instances(part.mesh);
    has_repeated = has_repeated || n > 1;
    n_faces += n * std::min(asset_.n_triangles(part.mesh), most_faces);
  }
  if (!has_repeated || n_faces > most_faces) return {};
  std::vector<CopiedVertex> copied;
  IndexedMesh scene = scene_of(mesh, copied);
  std::vector<Index> map;
  io::weld_gaps(scene, border_tolerance(scene), &map, threads);
  struct Meeting {
    Index copy = invalid_index;
    bool has_several = false;
    bool has_repeated = false;
  };
  std::vector<Meeting> meetings(scene.positions.size());
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] == invalid_index) continue;
    Meeting& meeting = meetings[map[v]];
    meeting.has_several = meeting.has_several || (meeting.copy != invalid_index && meeting.copy != copied[v].copy);
    meeting.has_repeated = meeting.has_repeated || copied[v].is_of_repeated;
    meeting.copy = copied[v].copy;
  }
  std::vector<std::uint8_t> held(mesh.positions.size());
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] != invalid_index && meetings[map[v]].has_several && meetings[map[v]].has_repeated) {
      held[copied[v].vertex] = 1;
    }
  }
  if (std::find(held.begin(), held.end(), 1) == held.end()) held.clear();
  return held;
}

}  // namespace whittle
