#include "oracle/brute_force.hh"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "oracle/brute_force_folds.hh"
#include "support/face_list.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle::test {
namespace {

template <class T>
bool meet(const std::set<T>& a, const std::set<T>& b) {
  return std::ranges::any_of(a, [&](const T& x) { return b.contains(x); });
}

}  // namespace

BruteForceDecimater::BruteForceDecimater(const IndexedMesh& input, const DecimateOptions& options) : options_(options) {
  const auto [mesh, n_sides] = brute_force_without_backs(input);
  options_.cost = options.cost.value_or(Cost::quadric);
  options_.max_normal_flip_deg = options.max_normal_flip_deg.value_or(facts_of(options).max_normal_flip_deg);
  Vec3 low = mesh.positions.at(0);
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  frame_ = Frame::of_box({low, high});
  for (const Vec3& p : mesh.positions) {
    stands_for_.push_back(static_cast<Index>(positions_.size()));
    positions_.push_back(frame_.to_frame(p));
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Triangle& f = mesh.faces[i];
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    faces_.push_back(f);
    sides_.add(f, n_sides[i]);
  }
  settle_topology(mesh.faces.size());
  if (options.boundary == Boundary::free) options_.quadric.boundary_weight = 0;

  std::vector<bool> locked(positions_.size());
  for (Index v = 0; v < positions_.size(); ++v) {
    locked[v] = (!options.locked.empty() && options.locked[v] != 0) ||
                (options.boundary == Boundary::locked && link_of(v, faces_).vertices.contains(invalid_index));
  }
  const double tolerance = options.feature_tolerance * diagonal_of(mesh.positions) * frame_.scale;
  constraints_ = BruteForceConstraints(positions_, faces_, locked, options_, tolerance,
                                       seam_edges(mesh, face_regions(mesh, options_.regions)));
  sum_planes(options.quadric);
  std::vector<bool> is_on_seam(positions_.size());
  for (const auto& [v, w] : constraints_.seams()) is_on_seam[v] = is_on_seam[w] = true;
  for (const auto& [v, w] : brute_force_folds(positions_, faces_, options_)) is_on_seam[v] = is_on_seam[w] = true;
  if (options_.cost == Cost::memoryless) memory_.emplace(positions_, faces_, is_on_seam);
  attributes_ = BruteForceAttributes(mesh, frame_, options_);
  areas_ = BruteForceAreas(mesh, options_);
  if (options.pairs.threshold > 0) find_threshold_pairs(options.pairs);
  had_threshold_pairs_ = !threshold_pairs_.empty();
}

/// Those of faces, seams, folds and borders. \param options whatever becomes of borders
void BruteForceDecimater::sum_planes(const QuadricOptions& options) {
  quadrics_.resize(positions_.size());
  seams_.resize(positions_.size());
  points_.resize(positions_.size());
  const std::map<Edge, int> n_faces = count_edge_faces(faces_);
  const std::set<Edge> folds = brute_force_folds(positions_, faces_, options_);
  QuadricOptions of_seams = options_.quadric;
  of_seams.boundary_weight = options_.attribute_weights.seam;
  for (Index v = 0; v < positions_.size(); ++v) {
    SymmetricMatrix& sum = quadrics_[v].a;
    for (const Triangle& f : faces_) {
      if (!has(f, v)) continue;
      const std::size_t corner = corner_of(f, v);
      sum += corner_quadric(positions_[v], positions_[f[(corner + 1) % 3]], positions_[f[(corner + 2) % 3]],
                            options_.quadric);
    }
    points_[v] = {positions_[v], 1 / (1 + 3 * options.regularization) * sum.trace(), 0};
    const auto add_lines = [&](const auto& is_on_line, const QuadricOptions& of_line, SymmetricMatrix& into) {
      for (const Triangle& f : faces_) {
        if (!has(f, v)) continue;
        const Index next = f[(corner_of(f, v) + 1) % 3];
        const Index previous = f[(corner_of(f, v) + 2) % 3];
        if (is_on_line(v, next)) into += border_quadric(positions_[v], positions_[next], positions_[previous], of_line);
        if (is_on_line(previous, v)) {
          into += border_quadric(positions_[previous], positions_[v], positions_[next], of_line);
        }
      }
    };
    add_lines([&](Index a, Index b) { return constraints_.is_seam(a, b); }, of_seams, seams_[v].a);
    add_lines([&](Index a, Index b) { return folds.contains(edge(a, b)); }, options_.quadric, seams_[v].a);
    sum += seams_[v].a;
    add_lines([&](Index a, Index b) { return n_faces.at(edge(a, b)) == 1; }, options_.quadric, sum);
  }
}

PlacedQuadric BruteForceDecimater::placed(Index v, bool is_edge) const {
  const PlacedQuadric result{positions_[v], quadrics_[v]};
  return is_edge ? result : with_points(result, points_[v], options_.quadric.point_weight);
}

std::uint64_t BruteForceDecimater::n_vertices() const {
  std::set<Index> used;
  for (const Triangle& f : faces_) used.insert(f.begin(), f.end());
  return used.size();
}

std::uint64_t BruteForceDecimater::n_faces() const { return sides_.faces_left(faces_).size(); }

std::vector<Triangle> BruteForceDecimater::faces() const {
  std::vector<Triangle> faces = sides_.faces_left(faces_);
  for (Triangle& corners : faces) {
    for (Index& v : corners) v = stands_for_[v];
  }
  return faces;
}

std::vector<std::pair<Index, Index>> BruteForceDecimater::feature_edges() const {
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& [a, b] : constraints_.feature_edges()) edges.push_back(edge(stands_for_[a], stands_for_[b]));
  std::ranges::sort(edges);
  return edges;
}

std::vector<BruteForceDecimater::Choice> BruteForceDecimater::choices() const {
  std::vector<Choice> choices;
  const std::map<Edge, int> edges = count_edge_faces(faces_);
  const bool is_looked_at = options_.cost == Cost::lindstrom_turk || options_.valence_weight > 0;
  const SurfaceNow surface = is_looked_at ? SurfaceNow(positions_, faces_) : SurfaceNow({}, {});
  for (const auto& [ends, count] : edges) choices.push_back(choice(ends.first, ends.second, true, surface));
  const auto is_used = [&](Index v) {
    return std::ranges::any_of(faces_, [v](const Triangle& f) { return has(f, v); });
  };
  for (const auto& [a, b] : threshold_pairs_) {
    if (!edges.contains(edge(a, b)) && is_used(a) && is_used(b)) choices.push_back(choice(a, b, false, surface));
  }
  std::ranges::sort(choices, [](const Choice& a, const Choice& b) { return a.is_before(b); });
  return choices;
}

BruteForceDecimater::Choice BruteForceDecimater::choice(Index a, Index b, bool is_edge,
                                                        const SurfaceNow& surface) const {
  PairEvaluation e = evaluate(a, b, is_edge, surface);
  if (memory_) {
    const double weight = quadrics_[a].a.trace() + quadrics_[b].a.trace();
    e.cost *= memoryless_factor(weight, memory_->face_area().first());
  }
  if (options_.valence_weight > 0) e.cost = surface.valence_change(a, b).penalize(e.cost, options_.valence_weight);
  return {e.cost, a, b, is_edge, e.position, e.is_minimum, e.position};
}

PairEvaluation BruteForceDecimater::evaluate(Index a, Index b, bool is_edge, const SurfaceNow& surface) const {
  const PairConstraint constraint =
      constraints_.of(a, b).value_or(PairConstraint::first);  // if not allowed, any value will do
  if (options_.cost == Cost::lindstrom_turk) return surface.lindstrom_turk(a, b, constraint);
  if (options_.cost == Cost::midpoint) return evaluate_midpoint(positions_[a], positions_[b], constraint);
  const PlacedQuadric first = placed(a, is_edge);
  const PlacedQuadric second = placed(b, is_edge);
  const Placement placement = options_.quadric.placement;
  if (options_.isotropy > 0) return evaluate_isotropic(first, second, options_.isotropy, placement, constraint);
  if (!attributes_.any()) return evaluate_pair(first, second, placement, constraint);
  const BruteForceAttributes::PairCost attributes = attributes_.of(a, b, is_edge, positions_[b] - positions_[a]);
  PlacedQuadric with_attributes = first;
  with_attributes.quadric += attributes.quadric;
  PairEvaluation evaluation = evaluate_pair(with_attributes, second, placement, constraint);
  if (attributes.quadric(evaluation.position - first.position) <= attributes.most) return evaluation;
  evaluation = evaluate_pair(first, second, placement, constraint);
  evaluation.cost += attributes.most;
  return evaluation;
}

/// The first in order of the allowed pairs, with final costs.
std::optional<BruteForceDecimater::Choice> BruteForceDecimater::next_choice() const {
  std::optional<Choice> first;
  for (const Choice& choice : choices()) {
    if (first && first->is_before(choice)) break;
    const std::optional<Choice> resolved = resolve(choice);
    if (resolved && (!first || resolved->is_before(*first))) first = resolved;
  }
  return first;
}

/// Finds the position and the final cost: the better position if it is allowed, else the cheapest one. nullopt if
/// neither is.
std::optional<BruteForceDecimater::Choice> BruteForceDecimater::resolve(Choice choice) const {
  if (!forgets(choice)) {
    choice.cost += vanishing_cost(choice);
    return is_allowed(choice) ? std::optional(choice) : std::nullopt;
  }
  const FacesAroundPair around(positions_, faces_, choice.low, choice.high, choice.cheapest);
  const StarVolume volume = around.volume();
  if (choice.is_minimum) choice.position += volume_step(quadrics_[choice.low].a + quadrics_[choice.high].a, volume);
  if (!is_allowed(choice)) {
    choice.position = choice.cheapest;
    if (!is_allowed(choice)) return std::nullopt;
  }
  if (!volume.is_thin()) return choice;
  const double displacement_sq = around.displacement_sq(choice.position - choice.cheapest);
  choice.cost = std::max(choice.cost, thin_cost(displacement_sq, memory_->face_area().now(n_faces())));
  return choice;
}

bool BruteForceDecimater::forgets(const Choice& choice) const {
  return memory_ && memory_->forgets(choice.low, choice.high, is_nonmanifold(choice.low, choice.high, choice.is_edge));
}

bool BruteForceDecimater::is_allowed(const Choice& choice) const {
  const auto& [cost, a, b, is_edge, cheapest, is_minimum, position] = choice;
  if (!constraints_.of(a, b) || !constraints_.keeps_lines(positions_, faces_, a, b, position)) return false;
  if (!areas_.keep_faces_without(a, b)) return false;
  if (is_edge && options_.topology == Topology::keep && !keeps_topology(a, b)) {
    const bool is_manifold = !link_of(a, faces_).is_singular && !link_of(b, faces_).is_singular;
    if (is_manifold || !is_no_less_manifold(a, b)) return false;
  }
  const std::vector<bool> is_left = faces_left(a, b);
  if (std::ranges::count(is_left, true) == 0) return false;
  if (stays_closed_ && is_edge && !keeps_topology(a, b) && opens_closed_manifold(a, b)) return false;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (!is_left[f]) continue;
    for (const Index v : {a, b}) {
      if (!has(faces_[f], v)) continue;
      if (!keeps_normals(faces_[f], v, position) || !keeps_shape(faces_[f], v, position)) return false;
    }
  }
  const std::vector<Triangle> after = faces_after(a, b);
  return constraints_.keeps_edges(after, a, b) &&
         constraints_.keeps_sharpness(positions_, faces_, after, a, b, position);
}

/// Which faces remain if a and b become one vertex. Faces with both a and b vanish. Faces of a and faces of b may then
/// have the same three vertices. If such a pile has as many faces of one orientation as of the other, all of them
/// vanish. Otherwise one face of the more frequent orientation remains: one at a, if there is one.
std::vector<bool> BruteForceDecimater::faces_left(Index a, Index b) const {
  struct Pile {
    std::array<std::vector<std::size_t>, 2> faces;  ///< by orientation
    bool is_at_a = false;
    bool is_at_b = false;
  };
  std::vector<bool> is_left(faces_.size(), true);
  std::map<Edge, Pile> piles;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Triangle& f = faces_[i];
    if (!has(f, a) && !has(f, b)) continue;
    is_left[i] = !(has(f, a) && has(f, b));
    if (!is_left[i]) continue;
    const std::size_t corner = corner_of(f, has(f, a) ? a : b);
    const Index x = f[(corner + 1) % 3];
    const Index y = f[(corner + 2) % 3];
    Pile& pile = piles[edge(x, y)];
    pile.faces[x < y].push_back(i);
    pile.is_at_a |= has(f, a);
    pile.is_at_b |= has(f, b);
  }
  for (const auto& [opposite_edge, pile] : piles) {
    if (!pile.is_at_a || !pile.is_at_b) continue;
    const auto& [backward, forward] = pile.faces;
    for (const std::size_t i : backward) is_left[i] = false;
    for (const std::size_t i : forward) is_left[i] = false;
    if (backward.size() == forward.size()) continue;
    const std::vector<std::size_t>& more = backward.size() > forward.size() ? backward : forward;
    const auto of_a = std::ranges::find_if(more, [&](std::size_t i) { return has(faces_[i], a); });
    is_left[of_a != more.end() ? *of_a : more.front()] = true;
  }
  return is_left;
}

std::vector<Triangle> BruteForceDecimater::faces_after(Index survivor, Index removed) const {
  const std::vector<bool> is_left = faces_left(std::min(survivor, removed), std::max(survivor, removed));
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (is_left[i]) faces.push_back(faces_[i]);
  }
  for (Triangle& f : faces) std::ranges::replace(f, removed, survivor);
  return faces;
}

/// Whether contracting (a, b) adds no border edges, misoriented edges, non-manifold edges or vertices of several fans,
/// and keeps the Euler number, unless threshold pairs were there at the start. All neighbours of
/// the two must also be neighbours of the merged vertex, or of one of its neighbours.
bool BruteForceDecimater::is_no_less_manifold(Index a, Index b) const {
  struct Defects {
    int border_edges = 0, misoriented = 0, edges = 0, vertices = 0, euler = 0;
  };
  const auto count = [](const std::vector<Triangle>& faces) {
    Defects defects;
    for (const auto& [ends, n] : count_edge_faces(faces)) {
      defects.border_edges += n == 1;
      defects.edges += n > 2;
      defects.euler -= 1;
    }
    std::map<Edge, int> upward;  // the faces that run along the edge from its lower vertex
    for (const Triangle& f : faces) {
      for (std::size_t i = 0; i < 3; ++i) upward[edge(f[i], f[(i + 1) % 3])] += f[i] < f[(i + 1) % 3];
    }
    for (const auto& [ends, n] : count_edge_faces(faces)) defects.misoriented += n == 2 && upward[ends] != 1;
    std::set<Index> used;
    for (const Triangle& f : faces) used.insert(f.begin(), f.end());
    defects.euler += static_cast<int>(used.size() + faces.size());
    for (const Index v : used) {
      Link link = link_of(v, faces);
      link.vertices.erase(invalid_index);  // the cone vertex
      std::erase_if(link.edges, [](const Edge& e) { return e.second == invalid_index; });
      defects.vertices += n_pieces(link) > 1;
    }
    return defects;
  };
  const Defects before = count(faces_);
  const std::vector<Triangle> faces = faces_after(b, a);
  const Defects after = count(faces);
  const auto neighbours_of = [](Index v, const std::vector<Triangle>& in) {
    std::set<Index> vertices = link_of(v, in).vertices;
    vertices.erase(invalid_index);
    return vertices;
  };
  std::set<Index> near = neighbours_of(b, faces);
  near.insert(b);
  for (const Index v : {a, b}) {
    for (const Index neighbour : neighbours_of(v, faces_)) {
      if (neighbour != a && neighbour != b && !meet(neighbours_of(neighbour, faces), near)) return false;
    }
  }
  return (had_threshold_pairs_ || after.euler == before.euler) && after.border_edges <= before.border_edges &&
         after.misoriented <= before.misoriented && after.edges <= before.edges && after.vertices <= before.vertices;
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
  if (static_cast<int>(link_ab.size()) < n_ab) return false;  // faces on the same three corners
  if (n_ab != 2) link_ab.insert(invalid_index);
  const auto has_one_end = [&](const Triangle& f) { return has(f, a) != has(f, b); };
  if (std::ranges::none_of(faces_, has_one_end)) return false;  // all faces at a and b would vanish

  // Lk a ∩ Lk b = Lk ab. Lk ab has no edges, because there are no tetrahedra.
  std::set<Index> common;
  std::ranges::set_intersection(link_a.vertices, link_b.vertices, std::inserter(common, common.end()));
  if (common != link_ab) return false;
  const std::set<Edge> edges_a(link_a.edges.begin(), link_a.edges.end());
  const std::set<Edge> edges_b(link_b.edges.begin(), link_b.edges.end());
  if (meet(edges_a, edges_b)) return false;
  // The same condition for the irregular edges alone, with a cone over singular vertices.
  return !meet(link_a.irregular, link_b.irregular) && !(link_a.is_singular && link_b.is_singular);
}

/// Whether the flip guard allows moving corner v of the face.
bool BruteForceDecimater::keeps_normals(const Triangle& face, Index v, const Vec3& to) const {
  const double least_cosine = std::cos(*options_.max_normal_flip_deg * std::numbers::pi / 180);
  const std::size_t corner = corner_of(face, v);
  const Vec3& x = positions_[face[(corner + 1) % 3]];
  const Vec3& y = positions_[face[(corner + 2) % 3]];
  const Vec3 before = (x - positions_[v]).cross(y - x);
  const Vec3 after = (x - to).cross(y - x);
  // A face has area if the sine at x is above 1e-10.
  const auto has_area = [&](const Vec3& normal, const Vec3& apex) {
    return normal.norm() > 1e-10 * (x - apex).norm() * (x - y).norm();
  };
  if (!has_area(before, positions_[v])) return true;
  const bool may_turn = options_.max_normal_flip_deg == 180;
  return has_area(after, to) && (may_turn || before.dot(after) >= least_cosine * before.norm() * after.norm());
}

bool BruteForceDecimater::keeps_shape(const Triangle& face, Index v, const Vec3& to) const {
  const std::size_t corner = corner_of(face, v);
  const Vec3& x = positions_[face[(corner + 1) % 3]];
  const Vec3& y = positions_[face[(corner + 2) % 3]];
  const double after = radius_ratio(to, x, y);
  return after >= options_.min_radius_ratio.value_or(0) || after >= radius_ratio(positions_[v], x, y);
}

void BruteForceDecimater::contract(const Choice& choice, Index survivor, Index removed) {
  sides_.contract(survivor, removed);
  std::vector<Triangle> faces = faces_after(survivor, removed);
  areas_.contract(survivor, removed);
  constraints_.contract(positions_, faces, survivor, removed, choice.position);
  quadrics_[survivor] = merge_quadrics(choice);
  if (attributes_.any()) {
    attributes_.contract(choice.low, choice.high, survivor, choice.is_edge, positions_, choice.position);
  }
  if (memory_) {
    memory_->contract(survivor, removed, is_nonmanifold(choice.low, choice.high, choice.is_edge), faces_, faces);
  }
  points_[survivor] = choice.is_edge ? points_[choice.low] + points_[choice.high] : PointQuadric{};
  positions_[survivor] = choice.position;
  faces_ = std::move(faces);
  std::set<Edge> pairs;
  for (const auto& [a, b] : threshold_pairs_) {
    const Edge pair = edge(a == removed ? survivor : a, b == removed ? survivor : b);
    if (pair.first != pair.second) pairs.insert(pair);
  }
  threshold_pairs_ = std::move(pairs);
}

/// The planes of seams of both ends, about the merged vertex. Vertices that remember all from now on lose theirs.
Quadric BruteForceDecimater::merge_seams(const Choice& choice) {
  const auto& [cost, a, b, is_edge, cheapest, is_minimum, position] = choice;
  Quadric sum = seams_[a].about(position - positions_[a]);
  sum += seams_[b].about(position - positions_[b]);
  seams_[a] = seams_[b] = {};
  if (!is_nonmanifold(a, b, is_edge)) return sum;
  for (const Triangle& f : faces_) {
    if (!has(f, a) && !has(f, b)) continue;
    for (const Index v : f) seams_[v] = {};
  }
  return sum;
}

/// Returns the merged vertex's quadric. For memoryless costs it also updates the quadrics of neighbours.
Quadric BruteForceDecimater::merge_quadrics(const Choice& choice) {
  const auto& [cost, a, b, is_edge, cheapest, is_minimum, position] = choice;
  if (options_.cost != Cost::quadric && options_.cost != Cost::memoryless) return {};
  Quadric quadric = merged(placed(a, is_edge), placed(b, is_edge), position, is_minimum && !attributes_.any()).quadric;
  if (!memory_) return quadric;
  const Vec3 origin = forgets(choice) ? cheapest : Vec3::Zero();
  const Quadric seams = merge_seams(choice);
  for (const Index v : memory_->forgetful_neighbours(a, b, is_nonmanifold(a, b, is_edge), faces_)) {
    quadrics_[v].a += change_of_planes(positions_, faces_, a, b, v, position, origin, options_.quadric);
  }
  if (!forgets(choice)) return quadric;
  seams_[a] = seams_[b] = quadric = seams;
  quadric.a += FacesAroundPair(positions_, faces_, a, b, origin).planes(position - origin, options_.quadric);
  return quadric;
}

/// Input vertices of the survivor and of the removed vertex. Under endpoint placement the input vertex at the merged
/// vertex's position survives; if both lie there, the survivor's.
std::pair<Index, Index> BruteForceDecimater::stand_ins(const Choice& choice, Index survivor, Index removed) const {
  const std::pair as_they_are(stands_for_[survivor], stands_for_[removed]);
  const bool has_quadrics = options_.cost == Cost::quadric || options_.cost == Cost::memoryless;
  if (!has_quadrics || options_.quadric.placement != Placement::endpoint) return as_they_are;
  for (const Index v : {survivor, removed}) {
    if (choice.position == positions_[v]) return {stands_for_[v], stands_for_[v == survivor ? removed : survivor]};
  }
  return as_they_are;
}

std::vector<Contraction> BruteForceDecimater::run(const DecimateTarget& target) {
  const double dimension = facts_of(options_).dimension;
  std::vector<Contraction> done;
  while (n_faces() > target.n_faces().value_or(0) && n_vertices() > target.n_vertices().value_or(0)) {
    const std::optional<Choice> choice = next_choice();
    if (!choice && areas_.give_up()) continue;
    if (!choice) break;
    const double cost = frame_.cost_to_model(choice->cost, dimension);
    if (target.cost_limit() && cost > *target.cost_limit()) break;
    const bool keep_high = constraints_.of(choice->low, choice->high) != PairConstraint::first;
    const Index survivor = keep_high ? choice->high : choice->low;
    const Index removed = keep_high ? choice->low : choice->high;
    const auto [lives_on, gone] = stand_ins(*choice, survivor, removed);
    contract(*choice, survivor, removed);
    stands_for_[survivor] = lives_on;
    done.push_back({lives_on, gone, frame_.to_model(choice->position), cost, !choice->is_edge, false});
  }
  return done;
}

}  // namespace whittle::test
