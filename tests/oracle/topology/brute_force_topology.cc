#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "oracle/brute_force.hh"
#include "support/face_list.hh"
#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle::test {
namespace {

std::set<Index> vertices_of(const std::vector<Triangle>& faces) {
  std::set<Index> vertices;
  for (const Triangle& f : faces) vertices.insert(f.begin(), f.end());
  return vertices;
}

std::size_t count_parts(const std::vector<Triangle>& faces) {
  std::set<Index> left = vertices_of(faces);
  std::size_t n = 0;
  for (; !left.empty(); ++n) {
    std::set<Index> part{*left.begin()};
    for (bool grows = true; grows;) {
      const std::size_t before = part.size();
      for (const Triangle& f : faces) {
        if (std::ranges::any_of(f, [&](Index v) { return part.contains(v); })) part.insert(f.begin(), f.end());
      }
      grows = part.size() > before;
    }
    for (const Index v : part) left.erase(v);
  }
  return n;
}

bool have(const std::vector<Triangle>& faces, std::initializer_list<Index> vertices) {
  return std::ranges::any_of(
      faces, [&](const Triangle& f) { return std::ranges::all_of(vertices, [&](Index v) { return has(f, v); }); });
}

/// Whether edges at the vertices have two faces that run along them in opposite directions, and each has one fan.
bool is_closed_manifold_at(const std::set<Index>& vertices, const std::vector<Triangle>& faces) {
  std::map<Edge, int> upward;  // the faces that run along the edge from its lower vertex
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) upward[edge(f[i], f[(i + 1) % 3])] += f[i] < f[(i + 1) % 3];
  }
  for (const auto& [ends, n] : count_edge_faces(faces)) {
    const bool is_at_any = vertices.contains(ends.first) || vertices.contains(ends.second);
    if (is_at_any && (n != 2 || upward[ends] != 1)) return false;
  }
  return std::ranges::all_of(vertices, [&](Index v) {
    Link link = link_of(v, faces);
    link.vertices.erase(invalid_index);  // the cone vertex
    std::erase_if(link.edges, [](const Edge& e) { return e.second == invalid_index; });
    return n_pieces(link) <= 1;
  });
}

}  // namespace

/// \pre a tetrahedron for each part takes more than a 100th of the faces wanted, as in all small meshes
void BruteForceDecimater::settle_topology(std::size_t n_input_faces) {
  const std::size_t n_parts = count_parts(faces_);
  const bool keeps_parts = n_parts <= 1 || 4 * n_parts > n_input_faces;
  if (options_.topology == Topology::automatic && keeps_parts) options_.topology = Topology::keep;
  stays_closed_ = options_.topology == Topology::automatic && is_closed_manifold_at(vertices_of(faces_), faces_);
}

bool BruteForceDecimater::opens_closed_manifold(Index a, Index b) const {
  std::set<Index> near{a, b};
  for (const Index v : vertices_of(faces_)) {
    if (v != a && v != b && have(faces_, {v, a}) && have(faces_, {v, b})) near.insert(v);
  }
  return is_closed_manifold_at(near, faces_) && !is_closed_manifold_at(near, faces_after(b, a));
}

/// Of the faces that vanish and that none covers: area times the longest side ^ (dimension - 2).
double BruteForceDecimater::vanishing_cost(const Choice& choice) const {
  const Index a = choice.low;
  const Index b = choice.high;
  if (!choice.is_edge || options_.topology != Topology::automatic || keeps_topology(a, b)) return 0;
  const double by_area = cost_traits(*options_.cost).dimension;
  const double of_quadrics = options_.quadric.weights == Weights::uniform ? 2 : by_area;
  const double dimension =
      options_.cost == Cost::quadric ? isotropic_dimension(of_quadrics, options_.isotropy) : by_area;
  const auto cost_of = [dimension](const Vec3& p, const Vec3& q, const Vec3& r) {
    const double longest = std::sqrt(std::max({(p - q).squaredNorm(), (q - r).squaredNorm(), (r - p).squaredNorm()}));
    const double area = 0.5 * (q - p).cross(r - p).norm();
    return area > 0 ? area * std::pow(longest, dimension - 2) : 0;
  };
  const std::vector<Triangle> after = faces_after(b, a);
  const std::vector<bool> is_left = faces_left(a, b);
  double sum = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Triangle& f = faces_[i];
    if (is_left[i]) continue;
    std::vector<Index> others;
    std::ranges::copy_if(f, std::back_inserter(others), [&](Index v) { return v != a && v != b; });
    if (others.size() == 1 && !have(after, {b, others[0]})) {
      sum += cost_of(positions_[a], positions_[b], positions_[others[0]]);
    } else if (others.size() == 2 && !have(after, {b, others[0], others[1]})) {
      sum += cost_of(choice.position, positions_[others[0]], positions_[others[1]]);
    }
  }
  return sum;
}

}  // namespace whittle::test
