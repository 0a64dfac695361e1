#include "cost/memoryless/memoryless_cost.hh"

#include <algorithm>
#include <utility>

namespace whittle {

namespace {

/// Guessed from those at rings: a vertex with a border has other planes, too.
MeanFaceArea mean_face_area(const TriangleComplex& complex, double regularization) {
  double area = 0;
  std::uint64_t n_corners = 0;
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    if (!complex.is_ring(v)) continue;
    area += complex.placed(v).quadric.a.trace();
    n_corners += complex.neighbours(v).size();
  }
  return {area / (1 + 3 * regularization), n_corners, complex.n_faces()};
}

}  // namespace

MemorylessCost::MemorylessCost(TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options)
    : complex_(complex),
      options_(options),
      face_area_(mean_face_area(complex, options.regularization)),
      quadric_cost_(complex, restraints, options, face_area_.first()),
      has_planes_of_faces_(complex.n_vertex_slots()) {
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) has_planes_of_faces_[v] = complex.is_ring(v);
}

/// Whether the merged vertex, and its neighbours, get the planes of its faces alone.
bool MemorylessCost::forgets(const Pair& pair, const PairStar& star) const {
  return !star.is_joint && complex_.is_ring(pair.a) && complex_.is_ring(pair.b);
}

Vec3 MemorylessCost::place(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) {
  has_ring_ = forgets(pair, star);
  if (!has_ring_) return evaluation.position;
  ring_origin_ = evaluation.position;
  ring_.assign(complex_, pair, star, ring_origin_);
  if (!evaluation.is_minimum) return evaluation.position;
  const SymmetricMatrix sum = complex_.placed(pair.a).quadric.a + complex_.placed(pair.b).quadric.a;
  return evaluation.position + volume_step(sum, ring_.volume());
}

std::optional<bool> MemorylessCost::turns_a_face(const Vec3& position, const FlipLimit& limit) {
  if (!has_ring_) return std::nullopt;
  return ring_.move_to(position - ring_origin_, limit, options_);
}

double MemorylessCost::final_cost(const PairEvaluation& evaluation) const {
  if (!has_ring_ || !ring_.volume().is_thin()) return evaluation.cost;
  const double displacement_sq = ring_.displacement_sq(evaluation.position - ring_origin_);
  return std::max(evaluation.cost, thin_cost(displacement_sq, face_area_.now(complex_.n_faces())));
}

PlacedQuadric MemorylessCost::merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) {
  has_planes_of_faces_[pair.a] = has_planes_of_faces_[pair.b] = has_ring_;
  if (has_ring_) {
    Quadric quadric;
    quadric.a = ring_.planes();
    change_neighbours_on_ring();
    return {evaluation.position, quadric};
  }
  if (star.is_joint) {
    remember_around(star);
  } else {
    change_neighbours(pair, evaluation.position, star);
  }
  return quadric_cost_.merge(pair, evaluation, star);
}

/// \pre the ring has been moved
void MemorylessCost::change_neighbours_on_ring() {
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Index neighbour = ring_.vertex(i);
    if (has_planes_of_faces_[neighbour]) complex_.change_planes(neighbour, ring_.change(i));
  }
}

/// For a merged vertex without a ring. Each neighbour that is changed has two faces at it, and the order of two doesn't
/// matter; what vanishes comes last.
void MemorylessCost::change_neighbours(const Pair& pair, const Vec3& position, const PairStar& star) {
  changes_.clear();
  const auto add = [this](Index v, const SymmetricMatrix& planes) {
    if (has_planes_of_faces_[v]) changes_.push_back({v, planes});
  };
  for (const auto& [wings, end] : {std::pair(star.first, pair.a), std::pair(star.second, pair.b)}) {
    for (std::size_t i = 0; i < wings.size(); ++i) {
      const Vec3& x = complex_.position(wings[i].x);
      const Vec3& y = complex_.position(wings[i].y);
      SymmetricMatrix change = corner_quadric(position, x, y, options_);
      change -= corner_quadric(complex_.position(end), x, y, options_);
      add(wings[i].x, change);
      add(wings[i].y, change);
    }
  }
  for (const PairStar::Opposite& opposite : star.opposites) {
    SymmetricMatrix change;
    change -= corner_quadric(complex_.position(pair.a), complex_.position(pair.b), complex_.position(opposite.vertex),
                             options_);
    add(opposite.vertex, change);
  }
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change& x, const Change& y) { return x.vertex < y.vertex; });
  for (auto change = changes_.begin(); change != changes_.end();) {
    const Index neighbour = change->vertex;
    SymmetricMatrix sum;
    for (; change != changes_.end() && change->vertex == neighbour; ++change) sum += change->planes;
    complex_.change_planes(neighbour, sum);
  }
}

/// Their faces hang together in another way now.
void MemorylessCost::remember_around(const PairStar& star) {
  for (const Wings& wings : {star.first, star.second}) {
    for (const Spoke& spoke : wings.spokes()) has_planes_of_faces_[spoke.vertex] = false;
  }
  for (const PairStar::Opposite& opposite : star.opposites) has_planes_of_faces_[opposite.vertex] = false;
  for (const auto& [x, y] : star.joint.coincident) has_planes_of_faces_[x] = has_planes_of_faces_[y] = false;
}

}  // namespace whittle
