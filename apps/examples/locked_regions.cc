// Simplifies a mesh while one region stays exactly as it is, and one line stays on the mesh.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <whittle/simplify/simplify.hh>

#include "torus.hh"

/// An edge names the vertex with the lower number first.
static whittle::VertexPair edge_between(whittle::Index a, whittle::Index b) { return {std::min(a, b), std::max(a, b)}; }

int main() {
  constexpr unsigned n_around = 64;
  constexpr unsigned n_tube = 32;
  const Torus torus(n_around, n_tube);
  whittle::IndexedMesh mesh;
  for (const auto& p : torus.points) mesh.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& face : torus.faces) mesh.faces.push_back({face[0], face[1], face[2]});

  whittle::SimplifyOptions options;
  // The region: locked vertices neither move nor vanish. One entry for each vertex.
  for (const whittle::Vec3& point : mesh.positions) options.decimate.locked.push_back(point.x() > 1);
  // The line: the greatest circle of the torus, edge by edge. Its vertices move along it only.
  for (unsigned i = 0; i < n_around; ++i)
    options.decimate.feature_edges.push_back(edge_between(i * n_tube, (i + 1) % n_around * n_tube));
  options.decimate.feature_tolerance = 0.01;  // of the diagonal of the bounding box

  const whittle::Simplification small =
      whittle::simplify(mesh, whittle::DecimateTarget::faces(1000), whittle::Effort::normal, options);

  // `vertex_map` gives the new number of each vertex of the input.
  std::size_t n_locked = 0;
  std::size_t n_kept = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (options.decimate.locked[v] == 0) continue;
    ++n_locked;
    const whittle::Index now = small.vertex_map[v];
    if (now != whittle::invalid_index && small.mesh.positions[now] == mesh.positions[v]) ++n_kept;
  }

  // The `feature_edges` of the result are the rest of the line. It still lies in the plane z = 0.
  double highest = 0;
  for (const auto& [a, b] : small.feature_edges)
    highest = std::max({highest, std::abs(small.mesh.positions[a].z()), std::abs(small.mesh.positions[b].z())});

  std::printf("%zu faces, %zu of %zu locked vertices kept, a line of %zu edges, at most %.4f off its plane\n",
              small.mesh.faces.size(), n_kept, n_locked, small.feature_edges.size(), highest);
  const bool has_line = small.feature_edges.size() >= 3 && small.feature_edges.size() < n_around && highest < 0.01;
  return small.mesh.faces.size() == 1000 && n_kept == n_locked && has_line ? 0 : 1;
}
