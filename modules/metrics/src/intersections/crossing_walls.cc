#include "whittle/metrics/crossing_walls.hh"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "intersections/face_intersections.hh"
#include "intersections/vertex_map.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/parts.hh"

namespace whittle::metrics {
namespace {

using FacePairs = std::vector<std::array<Index, 2>>;

/// The vertices of the mesh afterwards that a face became; `invalid_index` for a corner that has gone.
using Image = std::array<Index, 3>;

bool have_common_corner(const IndexedMesh& mesh, Index f, Index g) {
  for (const Index v : mesh.faces[f]) {
    for (const Index w : mesh.faces[g]) {
      if (v == w || mesh.positions[v] == mesh.positions[w]) return true;
    }
  }
  return false;
}

FacePairs crossing_faces(const IndexedMesh& mesh, unsigned threads) {
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  const auto is_wanted = [&](Index f, Index g) {
    const bool are_of_one_part = parts.part_of[mesh.faces[f][0]] == parts.part_of[mesh.faces[g][0]];
    return are_of_one_part && !have_common_corner(mesh, f, g);
  };
  return face_intersections(mesh, is_wanted, threads, {});
}

/// Faces of the mesh before that became some of the mesh afterwards.
struct Origins {
  IndexedMesh mesh;
  std::vector<Image> images;  ///< of each face
};

/// The faces that became one of `pairs`. \throw std::invalid_argument if a face names a missing vertex
Origins origins_of(const FacePairs& pairs, const IndexedMesh& after, const IndexedMesh& before,
                   std::span<const Index> vertex_map) {
  std::vector<char> is_asked(after.positions.size());
  for (const auto& pair : pairs) {
    for (const Index f : pair) {
      for (const Index v : after.faces[f]) is_asked[v] = 1;
    }
  }
  std::vector<std::uint8_t> is_origin(before.positions.size());
  for (std::size_t v = 0; v < is_origin.size(); ++v) {
    const Index to = vertex_map[v];
    is_origin[v] = to != invalid_index && is_asked[to];
  }
  const auto became = [&](Index v) { return is_origin[v] != 0 ? vertex_map[v] : invalid_index; };
  Origins origins;
  std::vector<Index> used;
  check_corners(before.positions.size(), before.faces);
  for (const Triangle& face : before.faces) {
    if ((is_origin[face[0]] | is_origin[face[1]] | is_origin[face[2]]) == 0) continue;
    origins.mesh.faces.push_back(face);
    origins.images.push_back({became(face[0]), became(face[1]), became(face[2])});
    used.insert(used.end(), face.begin(), face.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const Index v : used) origins.mesh.positions.push_back(before.positions[v]);
  for (Triangle& face : origins.mesh.faces) {
    for (Index& v : face) v = static_cast<Index>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  }
  return origins;
}

/// Intersections of such faces.
class EarlierIntersections {
 public:
  EarlierIntersections(const Origins& origins, unsigned threads) {
    if (origins.mesh.faces.empty()) return;
    for (const auto& [f, g] : face_intersections(origins.mesh, {}, threads, {})) {
      add(origins.images[f], origins.images[g]);
      add(origins.images[g], origins.images[f]);
    }
  }

  /// Whether a face that became the one intersected one that became the other.
  bool has(const Triangle& face, const Triangle& other) const {
    const auto became_other = [&](const Image& image) {
      return std::any_of(image.begin(), image.end(), [&](Index v) {
        return v != invalid_index && std::find(other.begin(), other.end(), v) != other.end();
      });
    };
    return std::any_of(face.begin(), face.end(), [&](Index v) {
      const auto found = others_at_.find(v);
      return found != others_at_.end() && std::any_of(found->second.begin(), found->second.end(), became_other);
    });
  }

 private:
  void add(const Image& image, const Image& other) {
    for (const Index v : image) {
      if (v != invalid_index) others_at_[v].push_back(other);
    }
  }

  /// Per vertex of the result, images of faces that intersected an origin of a face with this corner.
  std::unordered_map<Index, std::vector<Image>> others_at_;
};

}  // namespace

FacePairs newly_crossing_faces(const IndexedMesh& before, const IndexedMesh& after, std::span<const Index> vertex_map,
                               unsigned threads) {
  check_vertex_map(vertex_map, before, after);
  FacePairs pairs = crossing_faces(after, threads);
  if (pairs.empty()) return {};
  const EarlierIntersections earlier(origins_of(pairs, after, before, vertex_map), threads);
  std::erase_if(pairs, [&](const auto& pair) { return earlier.has(after.faces[pair[0]], after.faces[pair[1]]); });
  return pairs;
}

}  // namespace whittle::metrics
