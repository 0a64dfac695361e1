#include "support/brute_force.hh"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

namespace whittle::test {
namespace {

using Edge = std::pair<Index, Index>;

Edge edge(Index a, Index b) { return std::minmax(a, b); }

bool has(const Triangle& face, Index v) { return std::ranges::find(face, v) != face.end(); }

std::size_t corner_of(const Triangle& face, Index v) {
  return static_cast<std::size_t>(std::ranges::find(face, v) - face.begin());
}

std::map<Edge, int> count_edge_faces(const std::vector<Triangle>& faces) {
  std::map<Edge, int> counts;
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) ++counts[edge(f[i], f[(i + 1) % 3])];
  }
  return counts;
}

/// What surrounds a vertex, with the cone vertex `invalid_index` over irregular edges and singular vertices.
struct Link {
  std::set<Index> vertices;
  std::multiset<Edge> edges;
  std::set<Index> irregular;  ///< other ends of irregular edges
  bool is_singular = false;   ///< neither one closed fan nor one open fan
};

/// How many pieces the graph of the link's edges has.
int n_pieces(const Link& link) {
  std::map<Index, Index> piece;
  for (const Index v : link.vertices) piece[v] = v;
  const auto find = [&](Index v) {
    while (piece[v] != v) v = piece[v];
    return v;
  };
  for (const auto& [a, b] : link.edges) piece[find(a)] = find(b);
  return static_cast<int>(std::ranges::count_if(piece, [](const auto& entry) { return entry.first == entry.second; }));
}

Link link_of(Index v, const std::vector<Triangle>& faces) {
  Link link;
  std::map<Index, int> n_faces;
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (f[i] != v) continue;
      const Index x = f[(i + 1) % 3];
      const Index y = f[(i + 2) % 3];
      link.edges.insert(edge(x, y));
      ++n_faces[x];
      ++n_faces[y];
    }
  }
  bool is_line = true;
  for (const auto& [w, n] : n_faces) {
    link.vertices.insert(w);
    if (n != 2) link.irregular.insert(w);
    if (n > 2) is_line = false;
  }
  const bool is_one_fan = n_pieces(link) <= 1;
  const bool is_regular = link.irregular.empty() && is_one_fan;
  link.is_singular = !is_regular && !(is_line && is_one_fan && link.irregular.size() == 2);
  if (!is_regular) {
    link.vertices.insert(invalid_index);
    for (const Index w : link.irregular) link.edges.insert(edge(w, invalid_index));
  }
  return link;
}

template <class T>
bool meet(const std::set<T>& a, const std::set<T>& b) {
  return std::ranges::any_of(a, [&](const T& x) { return b.contains(x); });
}

}  // namespace

BruteForceDecimater::BruteForceDecimater(const IndexedMesh& mesh, const DecimateOptions& options) : options_(options) {
  Vec3 low = mesh.positions.at(0);
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  frame_ = Frame::of_box(low, high);
  for (const Vec3& p : mesh.positions) positions_.push_back(frame_.to_frame(p));
  for (const Triangle& f : mesh.faces) {
    if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) faces_.push_back(f);
  }
  const std::map<Edge, int> n_faces = count_edge_faces(faces_);
  if (options.boundary == Boundary::free) options_.quadric.boundary_weight = 0;

  quadrics_.resize(positions_.size());
  locked_.assign(positions_.size(), false);
  for (Index v = 0; v < positions_.size(); ++v) {
    SymmetricMatrix& sum = quadrics_[v].a;
    for (const Triangle& f : faces_) {
      if (!has(f, v)) continue;
      const std::size_t corner = corner_of(f, v);
      sum += corner_quadric(positions_[v], positions_[f[(corner + 1) % 3]], positions_[f[(corner + 2) % 3]],
                            options_.quadric);
    }
    for (const Triangle& f : faces_) {
      if (!has(f, v)) continue;
      const Index next = f[(corner_of(f, v) + 1) % 3];
      const Index previous = f[(corner_of(f, v) + 2) % 3];
      if (n_faces.at(edge(v, next)) == 1) {
        sum += border_quadric(positions_[v], positions_[next], positions_[previous], options_.quadric);
      }
      if (n_faces.at(edge(previous, v)) == 1) {
        sum += border_quadric(positions_[previous], positions_[v], positions_[next], options_.quadric);
      }
    }
    locked_[v] = (!options.locked.empty() && options.locked[v] != 0) ||
                 (options.boundary == Boundary::locked && link_of(v, faces_).vertices.contains(invalid_index));
  }
}

std::uint64_t BruteForceDecimater::n_vertices() const {
  std::set<Index> used;
  for (const Triangle& f : faces_) used.insert(f.begin(), f.end());
  return used.size();
}

std::vector<BruteForceDecimater::Choice> BruteForceDecimater::choices() const {
  std::vector<Choice> choices;
  for (const auto& [ends, count] : count_edge_faces(faces_)) {
    const auto [a, b] = ends;
    const Pinned pinned = is_locked(a) ? Pinned::first : is_locked(b) ? Pinned::second : Pinned::none;
    const PairEvaluation e = evaluate_pair(placed(a), placed(b), options_.quadric.placement, pinned);
    choices.push_back({e.cost, a, b, e.position, e.is_minimum});
  }
  std::ranges::sort(choices, [](const Choice& a, const Choice& b) {
    return std::tie(a.cost, a.low, a.high) < std::tie(b.cost, b.low, b.high);
  });
  return choices;
}

bool BruteForceDecimater::keeps_topology(Index a, Index b) const {
  const Link link_a = link_of(a, faces_);
  const Link link_b = link_of(b, faces_);
  std::set<Index> link_ab;
  int n_ab = 0;
  for (const Triangle& f : faces_) {
    if (!has(f, a) || !has(f, b)) continue;
    ++n_ab;
    for (const Index v : f) {
      if (v != a && v != b) link_ab.insert(v);
    }
  }
  if (n_ab != 2) link_ab.insert(invalid_index);
  const auto has_one_end = [&](const Triangle& f) { return has(f, a) != has(f, b); };
  if (std::ranges::none_of(faces_, has_one_end)) return false;  // all faces at a and b would vanish

  // Lk a ∩ Lk b = Lk ab, which has no edges as there are no tetrahedra.
  std::set<Index> common;
  std::ranges::set_intersection(link_a.vertices, link_b.vertices, std::inserter(common, common.end()));
  if (common != link_ab) return false;
  const std::set<Edge> edges_a(link_a.edges.begin(), link_a.edges.end());
  const std::set<Edge> edges_b(link_b.edges.begin(), link_b.edges.end());
  if (meet(edges_a, edges_b)) return false;
  // The same among the irregular edges alone, with a cone over singular vertices.
  return !meet(link_a.irregular, link_b.irregular) && !(link_a.is_singular && link_b.is_singular);
}

bool BruteForceDecimater::keeps_normals(Index v, Index other, const Vec3& to) const {
  const double least_cosine = std::cos(options_.max_normal_flip_deg * std::numbers::pi / 180);
  for (const Triangle& f : faces_) {
    if (!has(f, v) || has(f, other)) continue;
    const std::size_t corner = corner_of(f, v);
    const Vec3& x = positions_[f[(corner + 1) % 3]];
    const Vec3& y = positions_[f[(corner + 2) % 3]];
    const Vec3 before = (x - positions_[v]).cross(y - positions_[v]);
    const Vec3 after = (x - to).cross(y - to);
    // No area: a sine of at most 1e-10 at x.
    const auto has_area = [&](const Vec3& normal, const Vec3& apex) {
      return normal.norm() > 1e-10 * (x - apex).norm() * (x - y).norm();
    };
    if (!has_area(before, positions_[v])) continue;
    if (!has_area(after, to) || before.dot(after) < least_cosine * before.norm() * after.norm()) return false;
  }
  return true;
}

void BruteForceDecimater::contract(const Choice& choice, Index survivor, Index removed) {
  quadrics_[survivor] = merged(placed(choice.low), placed(choice.high), choice.position, choice.is_minimum).quadric;
  positions_[survivor] = choice.position;
  std::erase_if(faces_, [&](const Triangle& f) { return has(f, choice.low) && has(f, choice.high); });
  for (Triangle& f : faces_) std::ranges::replace(f, removed, survivor);
}

std::vector<Contraction> BruteForceDecimater::run(const DecimateTarget& target) {
  const bool times_area = options_.quadric.weights != Weights::uniform;
  std::vector<Contraction> done;
  while ((!target.faces || n_faces() > *target.faces) && (!target.vertices || n_vertices() > *target.vertices)) {
    const std::vector<Choice> all = choices();
    const auto choice = std::ranges::find_if(all, [&](const Choice& c) {
      return !(is_locked(c.low) && is_locked(c.high)) && keeps_topology(c.low, c.high) &&
             keeps_normals(c.low, c.high, c.position) && keeps_normals(c.high, c.low, c.position);
    });
    if (choice == all.end()) break;
    const double cost = frame_.cost_to_model(choice->cost, times_area);
    if (target.max_cost && cost > *target.max_cost) break;
    const bool keep_high = !is_locked(choice->low);
    const Index survivor = keep_high ? choice->high : choice->low;
    const Index removed = keep_high ? choice->low : choice->high;
    contract(*choice, survivor, removed);
    done.push_back({survivor, removed, frame_.to_model(choice->position), cost});
  }
  return done;
}

}  // namespace whittle::test
