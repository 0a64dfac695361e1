#include "oracle/sides/brute_force_sides.hh"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "support/face_list.hh"

namespace whittle::test {
namespace {

bool is_face(const Triangle& f) { return f[0] != f[1] && f[1] != f[2] && f[2] != f[0]; }

bool has_same_vertices(const Triangle& f, const Triangle& g) {
  return std::ranges::all_of(f, [&](Index v) { return has(g, v); });
}

bool has_opposite_orientation(const Triangle& f, const Triangle& g) { return g[(corner_of(g, f[0]) + 1) % 3] != f[1]; }

/// For each face the other one on the same vertices, turned over, if there is but one on these.
std::vector<std::optional<std::size_t>> other_sides(const std::vector<Triangle>& faces) {
  std::vector<std::optional<std::size_t>> others(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<std::size_t> same;
    for (std::size_t g = 0; g < faces.size(); ++g) {
      if (g != f && is_face(faces[f]) && is_face(faces[g]) && has_same_vertices(faces[f], faces[g])) same.push_back(g);
    }
    if (same.size() == 1 && has_opposite_orientation(faces[f], faces[same[0]])) others[f] = same[0];
  }
  return others;
}

std::array<Edge, 3> edges_of(const Triangle& f) { return {edge(f[0], f[1]), edge(f[1], f[2]), edge(f[2], f[0])}; }

/// The faces of the set of pairs that a face belongs to: those that can be reached over edges of pairs.
std::vector<std::size_t> set_of(std::size_t start, const std::vector<Triangle>& faces,
                                const std::vector<std::optional<std::size_t>>& others) {
  std::vector<std::size_t> reached{start};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (std::size_t g = 0; g < faces.size(); ++g) {
      if (!others[g] || std::ranges::find(reached, g) != reached.end()) continue;
      const std::array<Edge, 3> edges = edges_of(faces[reached[i]]);
      const bool is_next = std::ranges::any_of(
          edges_of(faces[g]), [&](const Edge& e) { return std::ranges::find(edges, e) != edges.end(); });
      if (is_next) reached.push_back(g);
    }
  }
  return reached;
}

bool is_sheet(const std::vector<std::size_t>& set, const std::vector<Triangle>& faces,
              const std::vector<std::optional<std::size_t>>& others) {
  if (set.size() < 4) return false;
  bool ends_at_bodies = false;
  bool ends_elsewhere = false;
  for (const std::size_t f : set) {
    for (const Edge& e : edges_of(faces[f])) {
      int n_pair_faces = 0;
      int n_others = 0;
      for (std::size_t g = 0; g < faces.size(); ++g) {
        if (!is_face(faces[g]) || !has(faces[g], e.first) || !has(faces[g], e.second)) continue;
        ++(others[g] ? n_pair_faces : n_others);
      }
      ends_at_bodies |= n_others >= 2;
      ends_elsewhere |= n_others == 1 || (n_others == 0 && n_pair_faces == 2);
    }
  }
  return ends_elsewhere || !ends_at_bodies;
}

Triangle from_its_least(Triangle face) {
  std::rotate(face.begin(), std::ranges::min_element(face), face.end());
  return face;
}

}  // namespace

void BruteForceSides::contract(Index survivor, Index removed) {
  for (Face& face : faces_) std::ranges::replace(face.corners, removed, survivor);
}

std::vector<Triangle> BruteForceSides::faces_left(const std::vector<Triangle>& there) const {
  std::map<Triangle, int> n_there;
  for (const Triangle& f : there) ++n_there[from_its_least(f)];
  std::vector<Triangle> left;
  for (const auto& [corners, n_sides] : faces_) {
    const auto same = n_there.find(from_its_least(corners));
    if (same == n_there.end() || same->second == 0) continue;
    --same->second;
    left.push_back(corners);
    if (n_sides == 2) left.push_back({corners[1], corners[0], corners[2]});
  }
  return left;
}

OneSided brute_force_without_backs(const IndexedMesh& mesh) {
  OneSided result{mesh, std::vector<int>(mesh.faces.size(), 1)};
  std::vector<std::optional<std::size_t>> others = other_sides(mesh.faces);
  std::vector<bool> is_in_sheet(mesh.faces.size());
  std::vector<bool> is_known(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!others[f] || is_known[f]) continue;
    const std::vector<std::size_t> set = set_of(f, mesh.faces, others);
    const bool is_one = is_sheet(set, mesh.faces, others);
    for (const std::size_t member : set) {
      is_known[member] = true;
      is_in_sheet[member] = is_one;
    }
  }
  if (std::ranges::find(is_in_sheet, true) == is_in_sheet.end()) return result;
  result = {};
  result.mesh.positions = mesh.positions;
  std::map<std::pair<int, int>, Index> groups;
  const auto group_of = [&](std::size_t f) {
    return mesh.face_groups.empty() ? 0 : static_cast<int>(mesh.face_groups[f]);
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (is_in_sheet[f] && *others[f] < f) continue;
    result.mesh.faces.push_back(mesh.faces[f]);
    result.n_sides.push_back(is_in_sheet[f] ? 2 : 1);
    const std::pair<int, int> both{group_of(f), is_in_sheet[f] ? group_of(*others[f]) : -1};
    result.mesh.face_groups.push_back(groups.try_emplace(both, static_cast<Index>(groups.size())).first->second);
  }
  return result;
}

}  // namespace whittle::test
