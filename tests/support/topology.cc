#include "support/topology.hh"

#include <Eigen/Geometry>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

namespace whittle::test {
namespace {

using Edge = std::pair<Index, Index>;

/// Connected parts of a graph of vertex pairs.
int count_parts(const std::set<Edge>& edges) {
  std::map<Index, std::vector<Index>> neighbours;
  for (const auto& [a, b] : edges) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::set<Index> seen;
  int parts = 0;
  for (const auto& entry : neighbours) {
    if (!seen.insert(entry.first).second) continue;
    ++parts;
    std::vector<Index> stack = {entry.first};
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      for (const Index next : neighbours[v])
        if (seen.insert(next).second) stack.push_back(next);
    }
  }
  return parts;
}

/// Whether the edges opposite to a vertex form one path or one circle.
bool is_one_fan(const std::vector<Edge>& opposite) {
  std::map<Index, int> degree;
  std::set<Edge> edges;
  for (const auto& [a, b] : opposite) {
    ++degree[a];
    ++degree[b];
    edges.insert(std::minmax(a, b));
  }
  int ends = 0;
  for (const auto& entry : degree) {
    if (entry.second > 2) return false;
    if (entry.second == 1) ++ends;
  }
  return ends <= 2 && count_parts(edges) == 1;
}

}  // namespace

Topology topology(const IndexedMesh& mesh) {
  Topology result;
  result.faces = static_cast<int>(mesh.faces.size());
  std::map<Edge, std::vector<bool>> edges;  // for each face, whether it runs from the lower to the higher vertex
  std::map<Index, std::vector<Edge>> opposite;
  for (const Triangle& face : mesh.faces) {
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
      ++result.degenerate_faces;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      edges[std::minmax(a, b)].push_back(a < b);
      opposite[a].emplace_back(b, face[(i + 2) % 3]);
    }
  }
  std::set<Edge> all;
  std::set<Edge> border;
  for (const auto& [edge, directions] : edges) {
    all.insert(edge);
    if (directions.size() == 1) border.insert(edge);
    if (directions.size() == 2 && directions[0] == directions[1]) ++result.misoriented_edges;
    if (directions.size() > 2) ++result.nonmanifold_edges;
  }
  for (const auto& entry : opposite)
    if (!is_one_fan(entry.second)) ++result.nonmanifold_vertices;
  result.vertices = static_cast<int>(opposite.size());
  result.edges = static_cast<int>(all.size());
  result.components = count_parts(all);
  result.border_edges = static_cast<int>(border.size());
  result.border_loops = count_parts(border);
  return result;
}

std::ostream& operator<<(std::ostream& out, const Topology& t) {
  return out << "{V " << t.vertices << ", E " << t.edges << ", F " << t.faces << ", components " << t.components
             << ", border edges " << t.border_edges << " in " << t.border_loops << " loops, non-manifold edges "
             << t.nonmanifold_edges << " and vertices " << t.nonmanifold_vertices << ", misoriented "
             << t.misoriented_edges << ", degenerate " << t.degenerate_faces << "}";
}

double signed_volume(const IndexedMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.faces)
    volume += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c])) / 6;
  return volume;
}

double surface_area(const IndexedMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& p = mesh.positions[a];
    area += (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm() / 2;
  }
  return area;
}

}  // namespace whittle::test
