#include "bench/subdivision.hh"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>

#include "support/random.hh"
#include "support/shapes/shapes.hh"

namespace whittle::bench {
namespace {

struct Edge {
  Index a;
  Index b;
  int n_faces = 0;
  Vec3 opposite = Vec3::Zero();  ///< sum of the opposite corners of its faces

  bool is_border() const { return n_faces != 2; }
};

/// The edges of a mesh, in the order of their first faces.
struct Edges {
  std::vector<Edge> edges;
  std::vector<std::array<std::size_t, 3>> of_face;  ///< edge i runs from corner i to the next one

  explicit Edges(const IndexedMesh& mesh) {
    std::unordered_map<std::uint64_t, std::size_t> known;
    known.reserve(2 * mesh.faces.size());
    of_face.reserve(mesh.faces.size());
    for (const Triangle& face : mesh.faces) {
      std::array<std::size_t, 3> numbers{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
        const auto [it, is_new] = known.try_emplace((std::uint64_t{a} << 32) | b, edges.size());
        if (is_new) edges.push_back({a, b});
        Edge& edge = edges[it->second];
        ++edge.n_faces;
        edge.opposite += mesh.positions[face[(i + 2) % 3]];
        numbers[i] = it->second;
      }
      of_face.push_back(numbers);
    }
  }
};

struct Neighbours {
  int count = 0;
  Vec3 sum = Vec3::Zero();
  void add(const Vec3& p) {
    ++count;
    sum += p;
  }
};

/// The new positions of the old vertices.
std::vector<Vec3> moved_vertices(const IndexedMesh& mesh, const std::vector<Edge>& edges) {
  std::vector<Neighbours> all(mesh.positions.size());
  std::vector<Neighbours> on_border(mesh.positions.size());
  for (const Edge& edge : edges) {
    for (const auto& [v, w] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
      all[v].add(mesh.positions[w]);
      if (edge.is_border()) on_border[v].add(mesh.positions[w]);
    }
  }
  std::vector<Vec3> result;
  result.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (on_border[v].count > 0) {
      result.push_back(0.75 * p + 0.25 / on_border[v].count * on_border[v].sum);
    } else {
      const int n = std::max(all[v].count, 1);
      const double weight = n == 3 ? 3.0 / 16 : 3.0 / (8.0 * n);
      result.push_back((1 - n * weight) * p + weight * all[v].sum);
    }
  }
  return result;
}

Vec3 edge_vertex(const IndexedMesh& mesh, const Edge& edge) {
  const Vec3 ends = mesh.positions[edge.a] + mesh.positions[edge.b];
  return edge.is_border() ? Vec3(0.5 * ends) : Vec3(0.375 * ends + 0.125 * edge.opposite);
}

double mean_edge_length(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      sum += (mesh.positions[v] - mesh.positions[w]).norm();
  return sum / (3 * static_cast<double>(std::max<std::size_t>(mesh.faces.size(), 1)));
}

/// Area-weighted vertex normals, of unit length or zero.
std::vector<Vec3> vertex_normals(const IndexedMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const Index v : {a, b, c}) normals[v] += normal;
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

/// The points of a finely subdivided face, identified by their weights at the corners. So faces share the points on
/// common edges.
class GeodesicVertices {
 public:
  GeodesicVertices(const IndexedMesh& base, IndexedMesh& mesh) : base_(base), mesh_(mesh) {}

  /// \param weights whole numbers, not all of them 0
  Index at(const Triangle& face, const std::array<int, 3>& weights) {
    std::array<std::pair<int, Index>, 3> point{};  // corners of weight 0 are left out
    for (std::size_t i = 0; i < 3; ++i) point[i] = {weights[i], weights[i] > 0 ? face[i] : 0};
    std::ranges::sort(point);
    const auto [it, is_new] = known_.try_emplace(point, static_cast<Index>(mesh_.positions.size()));
    if (is_new) {
      Vec3 position = Vec3::Zero();
      for (const auto& [weight, corner] : point) position += weight * base_.positions[corner];
      mesh_.positions.push_back(position.normalized());
    }
    return it->second;
  }

 private:
  const IndexedMesh& base_;
  IndexedMesh& mesh_;
  std::map<std::array<std::pair<int, Index>, 3>, Index> known_;
};

}  // namespace

IndexedMesh loop_subdivided(const IndexedMesh& mesh) {
  const Edges edges(mesh);
  IndexedMesh result;
  result.positions = moved_vertices(mesh, edges.edges);
  result.positions.reserve(mesh.positions.size() + edges.edges.size());
  for (const Edge& edge : edges.edges) result.positions.push_back(edge_vertex(mesh, edge));
  result.faces.reserve(4 * mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const auto vertex = [&](std::size_t i) { return static_cast<Index>(mesh.positions.size() + edges.of_face[f][i]); };
    const Index ab = vertex(0);
    const Index bc = vertex(1);
    const Index ca = vertex(2);
    result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

IndexedMesh with_noise(IndexedMesh mesh, double amplitude, std::uint64_t seed) {
  test::Random random(seed);
  const double largest = amplitude * mean_edge_length(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) mesh.positions[v] += random.uniform(-largest, largest) * normals[v];
  return mesh;
}

IndexedMesh geodesic_sphere(int frequency) {
  const IndexedMesh base = test::icosahedron();
  IndexedMesh mesh;
  GeodesicVertices vertices(base, mesh);
  for (const Triangle& face : base.faces) {
    const auto vertex = [&](int i, int j) { return vertices.at(face, {i, j, frequency - i - j}); };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        mesh.faces.push_back({vertex(i + 1, j), vertex(i, j + 1), vertex(i, j)});
        if (i + j + 2 > frequency) continue;
        mesh.faces.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
  }
  return mesh;
}

}  // namespace whittle::bench
