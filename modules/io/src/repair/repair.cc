#include "whittle/io/repair.hh"

#include <algorithm>

#include "repair/duplicate_faces.hh"
#include "repair/weld.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/wedges.hh"

namespace whittle::io {

std::array<std::pair<std::string_view, std::size_t>, 5> Repairs::entries() const {
  return {{{"welded_vertices", welded_vertices},
           {"triangulated_polygons", triangulated_polygons},
           {"degenerate_faces", degenerate_faces},
           {"duplicate_faces", duplicate_faces},
           {"isolated_vertices", isolated_vertices}}};
}

bool Repairs::any() const {
  const auto all = entries();
  return std::any_of(all.begin(), all.end(), [](const auto& entry) { return entry.second > 0; });
}

Repairs& Repairs::operator+=(const Repairs& more) {
  welded_vertices += more.welded_vertices;
  triangulated_polygons += more.triangulated_polygons;
  degenerate_faces += more.degenerate_faces;
  duplicate_faces += more.duplicate_faces;
  isolated_vertices += more.isolated_vertices;
  return *this;
}

std::string to_string(const Repairs& repairs) {
  std::string text;
  std::string_view last_verb;
  const auto say = [&](std::string_view verb, std::size_t count, std::string_view one, std::string_view many) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    if (verb != last_verb) text += std::string(verb) + ' ';
    text += std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
    last_verb = verb;
  };
  say("triangulated", repairs.triangulated_polygons, "polygon", "polygons");
  say("welded", repairs.welded_vertices, "vertex", "vertices");
  say("dropped", repairs.degenerate_faces, "degenerate face", "degenerate faces");
  say("dropped", repairs.duplicate_faces, "duplicate face", "duplicate faces");
  say("dropped", repairs.isolated_vertices, "isolated vertex", "isolated vertices");
  return text;
}

std::size_t drop_degenerate_faces(IndexedMesh& mesh) {
  return drop_faces(mesh, [&](std::size_t f) { return !has_three_corners(mesh.faces[f]); });
}

std::size_t drop_duplicate_faces(IndexedMesh& mesh, unsigned threads) {
  const std::vector<char> is_duplicate = find_duplicate_faces(mesh.faces, mesh.positions.size(), threads);
  return drop_faces(mesh, [&](std::size_t f) { return is_duplicate[f] != 0; });
}

namespace {

std::vector<Index> drop_isolated(IndexedMesh& mesh) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) is_used[v] = 1;
  }
  return drop_vertices(mesh, [&](std::size_t v) { return is_used[v] == 0; });
}

}  // namespace

std::vector<Index> tidy_after_welding(IndexedMesh& mesh, Repairs& done, unsigned threads) {
  if (done.welded_vertices > 0) {
    done.degenerate_faces += drop_degenerate_faces(mesh);
    done.duplicate_faces += drop_duplicate_faces(mesh, threads);
  }
  const std::size_t count = mesh.positions.size();
  std::vector<Index> renumbered = drop_isolated(mesh);
  done.isolated_vertices += count - mesh.positions.size() - done.welded_vertices;
  join_equal_wedges(mesh);
  return renumbered;
}

std::vector<Index> vertex_map_of(const IndexedMesh& mesh, std::size_t n_before, const std::vector<Index>& joined_to) {
  std::vector<Index> map;
  resize_large(map, n_before, invalid_index);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    map[mesh.origins.empty() ? v : mesh.origins[v]] = static_cast<Index>(v);
  }
  for (std::size_t v = 0; v < joined_to.size(); ++v) map[v] = map[joined_to[v]];
  return map;
}

Repairs repair(IndexedMesh& mesh, bool weld, std::vector<Index>* joined_to, unsigned threads) {
  Repairs done;
  if (joined_to != nullptr) joined_to->clear();
  done.degenerate_faces = drop_degenerate_faces(mesh);
  done.duplicate_faces = drop_duplicate_faces(mesh, threads);
  if (weld) done += weld_borders_without_copies(mesh, joined_to, threads);
  tidy_after_welding(mesh, done, threads);
  return done;
}

}  // namespace whittle::io
