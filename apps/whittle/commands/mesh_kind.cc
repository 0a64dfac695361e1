#include "commands/mesh_kind.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terminal/table.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"

namespace whittle::app {
namespace {

constexpr double flat_deg = 0.5;           ///< an edge turns less if its faces lie in one plane
constexpr double sharp_deg = 40;           ///< suggested as feature angle
constexpr double cad_share = 0.4;          ///< of flat edges; scans and organic shapes have hardly any
constexpr double soup_share = 0.5;         ///< of border edges
constexpr double small_part = 0.01;        ///< of the mesh's diagonal
constexpr double border_tolerance = 1e-6;  ///< of the diagonal: on the bounding box

/// Counts of edges with two faces.
struct EdgeAngles {
  double flat_share = 0;    ///< share of edges whose faces lie in one plane
  std::size_t n_sharp = 0;  ///< number of edges that turn by more than `sharp_deg`
};

/// Computed in the frame, for meshes of any size.
EdgeAngles edge_angles(const IndexedMesh& mesh) {
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  const Frame frame = Frame::of_points(mesh.positions);
  const auto normal = [&](Index side) {
    const Corners corners = corners_of(mesh.positions, mesh.faces[detail::face_of(side)]);
    return Vec3(area_normal(frame.to_frame(corners)).stableNormalized());
  };
  const double least_sine = std::sin(flat_deg * std::numbers::pi / 180);
  const double sharp_cosine = std::cos(sharp_deg * std::numbers::pi / 180);
  EdgeAngles angles;
  std::size_t n_flat = 0;
  std::size_t n_regular = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_regular(e, mesh.faces)) continue;
    ++n_regular;
    const Vec3 first = normal(edges.sides(e)[0]);
    const Vec3 second = normal(edges.sides(e)[1]);
    n_flat += static_cast<std::size_t>(first.dot(second) > 0 && first.cross(second).norm() < least_sine);
    angles.n_sharp += static_cast<std::size_t>(first.dot(second) < sharp_cosine);
  }
  if (n_regular > 0) angles.flat_share = static_cast<double>(n_flat) / static_cast<double>(n_regular);
  return angles;
}

/// Whether all border vertices lie on the sides of the bounding box, seen along one axis: a piece that was cut out.
bool is_tile(const IndexedMesh& mesh) {
  const Box box = bounds_of(mesh.positions);
  const double tolerance = border_tolerance * diagonal_of(box);
  const auto is_border = detail::border_vertices(mesh.faces, mesh.positions.size());
  for (int up = 0; up < 3; ++up) {
    bool is_cut = true;
    for (std::size_t v = 0; v < is_border.size() && is_cut; ++v) {
      if (is_border[v] == 0) continue;
      bool is_on_side = false;
      for (int axis = 0; axis < 3; ++axis) {
        const double x = mesh.positions[v][axis];
        const double to_side = std::min(x - box.min()[axis], box.max()[axis] - x);
        const bool is_side = axis != up && box.max()[axis] - box.min()[axis] > 2 * tolerance;
        is_on_side = is_on_side || (is_side && to_side <= tolerance);
      }
      is_cut = is_on_side;
    }
    if (is_cut) return true;
  }
  return false;
}

std::size_t count_small_parts(const IndexedMesh& mesh, const Parts& parts) {
  const double size = small_part * diagonal_of(mesh.positions);
  const std::vector<double> diagonals = part_diagonals(mesh.positions, parts);
  return static_cast<std::size_t>(
      std::count_if(diagonals.begin(), diagonals.end(), [size](double diagonal) { return diagonal < size; }));
}

void suggest_for_borders(const IndexedMesh& mesh, bool is_gltf, MeshKind& kind) {
  const io::BorderGaps gaps = is_gltf ? io::BorderGaps{} : io::find_border_gaps(mesh);
  if (gaps.n_vertices > 0) {
    kind.suggestions.push_back({"--weld auto", std::to_string(gaps.n_vertices) +
                                                   " vertices lie at gaps between borders, at most " +
                                                   significant(gaps.widest) + " wide"});
    return;
  }
  if (!is_tile(mesh)) return;
  kind.words.emplace_back("tile");
  kind.suggestions.push_back(
      {"--boundary locked", "if it has neighbours: the border lies on the bounding box, and they are to fit on"});
}

void suggest_for_parts(const IndexedMesh& mesh, bool is_gltf, unsigned threads, MeshKind& kind) {
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  if (parts.count < 2) return;
  kind.words.emplace_back("parts");
  if (const std::size_t n_small = count_small_parts(mesh, parts); n_small > 0 && n_small < parts.count) {
    kind.suggestions.push_back({"--prune 1%", std::to_string(n_small) + " of " + std::to_string(parts.count) +
                                                  " parts are smaller than 1 % of the diagonal"});
  }
  if (automatic_threshold(mesh, threads) > 0) {
    if (!is_gltf) {
      kind.suggestions.push_back({"--threshold auto", "if parts may join: some lie near one another"});
    }
    kind.suggestions.push_back({"--self-intersections refuse", "if parts that lie near one another are to stay apart"});
  }
}

/// Positions and faces alone.
IndexedMesh without_backs(const IndexedMesh& mesh) {
  IndexedMesh one_side;
  one_side.positions = mesh.positions;
  for (const Index f : faces_without_backs(mesh)) one_side.faces.push_back(mesh.faces[f]);
  return one_side;
}

MeshKind kind_of_one_side(const IndexedMesh& mesh, const metrics::Topology& topology, bool is_gltf, unsigned threads) {
  MeshKind kind;
  kind.words.emplace_back(topology.closed ? "closed" : "open");
  const bool is_soup = static_cast<double>(topology.boundary_edges) > soup_share * static_cast<double>(topology.edges);
  if (is_soup) kind.words.emplace_back("soup");
  const EdgeAngles angles = edge_angles(mesh);
  kind.flat_edges = angles.flat_share;
  const bool is_cad = kind.flat_edges >= cad_share;
  if (is_cad) kind.words.emplace_back("CAD");
  if (is_cad && angles.n_sharp > 0) {
    kind.suggestions.push_back({"--feature-angle 40", "if sharp edges are to stay exactly where they are"});
  }
  if (!topology.closed) suggest_for_borders(mesh, is_gltf, kind);
  suggest_for_parts(mesh, is_gltf, threads, kind);
  if (topology.nonmanifold_edges > 0) {
    kind.suggestions.push_back({"--topology free", "if the result may get smaller than its topology allows"});
  }
  return kind;
}

}  // namespace

bool is_mostly_flat(const IndexedMesh& mesh) { return edge_angles(without_backs(mesh)).flat_share >= cad_share; }

MeshKind kind_of(const IndexedMesh& mesh, const metrics::Topology& topology, bool is_gltf, unsigned threads) {
  const IndexedMesh one_side = without_backs(mesh);
  if (one_side.faces.size() == mesh.faces.size()) return kind_of_one_side(mesh, topology, is_gltf, threads);
  MeshKind kind = kind_of_one_side(one_side, metrics::topology(one_side), is_gltf, threads);
  kind.words.emplace_back("two-sided");
  return kind;
}

}  // namespace whittle::app
