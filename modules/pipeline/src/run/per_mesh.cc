#include "run/per_mesh.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

#include "whittle/core/pieces.hh"
#include "whittle/core/wedges.hh"
#include "whittle/scene/scene_document.hh"

namespace whittle {
namespace {

/// \param share of the faces that both have together: that of `more`
void add_polish(const PolishResult& more, double share, PolishResult& all) {
  const auto add_rms = [share](double value, double& mean) {
    mean = std::sqrt((1 - share) * mean * mean + share * value * value);
  };
  all.n_passes = std::max(all.n_passes, more.n_passes);
  all.n_moved += more.n_moved;
  add_rms(more.rms_before, all.rms_before);
  add_rms(more.rms_after, all.rms_after);
}

/// Adds what became of a piece. \param n_faces_before of the pieces that were added before
void add_simplified(const MeshPiece& piece, std::size_t n_faces_before, Simplification more, Simplification& all) {
  const auto first = static_cast<Index>(all.mesh.positions.size());
  const auto moved = [first](const VertexPair& pair) { return VertexPair{pair.a + first, pair.b + first}; };
  for (std::size_t v = 0; v < piece.vertices.size(); ++v) {
    if (more.vertex_map[v] != invalid_index) all.vertex_map[piece.vertices[v]] = first + more.vertex_map[v];
  }
  all.n_folded_texture_faces += more.n_folded_texture_faces;
  for (const Index f : more.face_origins) all.face_origins.push_back(piece.faces[f]);
  for (const VertexPair& edge : more.feature_edges) all.feature_edges.push_back(moved(edge));
  for (const RefusedPair& refused : more.refused_pairs) {
    all.refused_pairs.push_back({moved(refused.pair), refused.reason});
  }
  more.mesh.group_names.clear();
  append_mesh(all.mesh, std::move(more.mesh));
  const auto n_faces = static_cast<double>(piece.faces.size());
  add_polish(more.polish, n_faces / (n_faces + static_cast<double>(n_faces_before)), all.polish);
  if (n_faces_before == 0) {
    all.cost = more.cost;
    all.result = std::move(more.result);
  } else {
    all.result += more.result;
  }
  all.decimate_seconds += more.decimate_seconds;
  all.polish_seconds += more.polish_seconds;
}

/// The progress of a piece as that of all.
std::function<bool(const Progress&)> part_of_progress(const std::function<bool(const Progress&)>& progress,
                                                      double begin, double share) {
  return [=](Progress now) {
    now.fraction = begin + share * now.fraction;
    return progress(now);
  };
}

struct CountsPerMesh {
  std::vector<std::uint64_t> n_faces;
  std::vector<std::uint64_t> n_vertices;
};

CountsPerMesh counts_per_mesh(const SceneDocument& document, const IndexedMesh& mesh) {
  CountsPerMesh counts;
  counts.n_faces.resize(document.n_meshes());
  counts.n_vertices.resize(document.n_meshes());
  std::vector<Index> counted_in(mesh.positions.size(), invalid_index);
  const std::vector<Index> meshes = document.meshes_of_faces(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    ++counts.n_faces[meshes[f]];
    for (const Index v : mesh.faces[f]) {
      if (std::exchange(counted_in[v], meshes[f]) != meshes[f]) ++counts.n_vertices[meshes[f]];
    }
  }
  return counts;
}

/// Which vertices several pieces have. V, or empty if there are none.
std::vector<std::uint8_t> shared_vertices(const std::vector<MeshPiece>& pieces, std::size_t n_vertices) {
  std::vector<std::uint8_t> n_pieces(n_vertices);
  for (const MeshPiece& piece : pieces) {
    for (const Index v : piece.vertices) n_pieces[v] = static_cast<std::uint8_t>(n_pieces[v] + (n_pieces[v] < 2));
  }
  if (std::find(n_pieces.begin(), n_pieces.end(), 2) == n_pieces.end()) return {};
  for (std::uint8_t& n : n_pieces) n = std::uint8_t{n > 1};
  return n_pieces;
}

/// Joins what several pieces have of one vertex of the input, which hasn't moved.
void join_pieces(Simplification& all) {
  IndexedMesh& mesh = all.mesh;
  std::vector<Index> by_origin(mesh.positions.size());
  std::iota(by_origin.begin(), by_origin.end(), Index{0});
  std::stable_sort(by_origin.begin(), by_origin.end(),
                   [&](Index a, Index b) { return mesh.origins[a] < mesh.origins[b]; });
  std::vector<Index> joined(mesh.positions.size());
  for (std::size_t i = 0; i < by_origin.size(); ++i) {
    const bool is_first = i == 0 || mesh.origins[by_origin[i]] != mesh.origins[by_origin[i - 1]];
    joined[by_origin[i]] = is_first ? by_origin[i] : joined[by_origin[i - 1]];
  }
  const std::vector<Index> map = join_vertices(mesh, joined);
  for (Index& v : all.vertex_map) v = v == invalid_index ? v : map[v];
  for (VertexPair& edge : all.feature_edges) edge = {map[edge.a], map[edge.b]};
  for (auto& refused : all.refused_pairs) refused.pair = {map[refused.pair.a], map[refused.pair.b]};
  all.result.n_vertices = mesh.positions.size();
}

}  // namespace

std::vector<DecimateTarget> targets_per_mesh(const Targets& options, const Scene& scene, double diagonal) {
  const auto [n_faces, n_vertices] = counts_per_mesh(*scene.document, scene.read.mesh);
  std::vector<DecimateTarget> targets;
  for (std::size_t i = 0; i < n_faces.size(); ++i) {
    DecimateTarget target = resolve(options, n_vertices[i], n_faces[i], diagonal);
    if (target.n_faces()) target = target.or_faces(std::min(*target.n_faces(), n_faces[i]));
    if (target.n_vertices()) target = target.or_vertices(std::min(*target.n_vertices(), n_vertices[i]));
    targets.push_back(target);
  }
  return targets;
}

DecimateTarget sum_of(const std::vector<DecimateTarget>& targets) {
  DecimateTarget sum = targets.front();
  for (std::size_t i = 1; i < targets.size(); ++i) {
    if (sum.n_faces()) sum = sum.or_faces(*sum.n_faces() + *targets[i].n_faces());
    if (sum.n_vertices()) sum = sum.or_vertices(*sum.n_vertices() + *targets[i].n_vertices());
  }
  return sum;
}

std::vector<std::string> meshes_above(const std::vector<DecimateTarget>& targets, const SceneDocument& document,
                                      const IndexedMesh& mesh) {
  std::vector<std::string> names;
  const auto [n_faces, n_vertices] = counts_per_mesh(document, mesh);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!targets[i].is_reached_at(n_faces[i], n_vertices[i])) names.push_back(document.mesh_name(i));
  }
  return names;
}

Simplification simplify_per_mesh(const Scene& scene, const std::vector<DecimateTarget>& targets, Effort effort,
                                 const SimplifyOptions& options) {
  const IndexedMesh& mesh = scene.read.mesh;
  Simplification all;
  all.vertex_map.assign(mesh.positions.size(), invalid_index);
  std::size_t n_faces = 0;
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(mesh.faces.size()); };
  const std::vector<MeshPiece> pieces = split_mesh(mesh, scene.document->meshes_of_faces(mesh), targets.size());
  const std::vector<std::uint8_t> shared = shared_vertices(pieces, mesh.positions.size());
  const std::vector<std::uint8_t>& locked = options.decimate.locked;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const MeshPiece& piece = pieces[i];
    if (piece.faces.empty()) continue;  // by --prune
    SimplifyOptions own = options;
    own.decimate.locked.clear();
    for (const Index v : piece.vertices) {
      const bool stays = (!shared.empty() && shared[v] != 0) || (!locked.empty() && locked[v] != 0);
      own.decimate.locked.push_back(std::uint8_t{stays});
    }
    if (options.decimate.progress) {
      own.decimate.progress = part_of_progress(options.decimate.progress, share(n_faces), share(piece.faces.size()));
    }
    add_simplified(piece, n_faces, simplify(piece.mesh, targets[i], effort, own), all);
    if (all.result.stop == StopReason::cancelled) break;
    n_faces += piece.faces.size();
  }
  all.mesh.group_names = mesh.group_names;
  if (!shared.empty()) join_pieces(all);
  return all;
}

}  // namespace whittle
