#include "cost/memoryless/memoryless_cost.hh"

#include <algorithm>
#include <array>
#include <utility>

namespace whittle {
namespace {

/// Estimated from the faces at rings, because other vertices have the planes of borders and seams, too.
MeanFaceArea mean_face_area(const TriangleComplex& complex, const SparseQuadrics& seams, const VertexQuadrics& quadrics,
                            double regularization) {
  double area = 0;
  std::uint64_t n_corners = 0;
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    if (!complex.is_ring(v) || seams.contains(v)) continue;
    area += quadrics.matrix(v).trace();
    n_corners += complex.neighbours(v).size();
  }
  return {area / (1 + 3 * regularization), n_corners, complex.n_faces()};
}

/// Fills in the ring of a profile. \pre both vertices have rings
void look_at_ring(const TriangleComplex& complex, const Vec3& origin, ContractionProfile& profile) {
  const std::span<const Neighbour> first = profile.first.neighbours();
  const std::span<const Neighbour> second = profile.second.neighbours();
  const std::span<const Neighbour> others = second.subspan(1, second.size() - 2);
  std::vector<Index>& around = profile.ring.around();
  around.resize(first.size() + others.size());
  const auto vertex_of = [](const Neighbour& neighbour) { return neighbour.vertex; };
  std::transform(others.begin(), others.end(), std::transform(first.begin(), first.end(), around.begin(), vertex_of),
                 vertex_of);
  profile.ring.look(complex.position(profile.pair.a), complex.position(profile.pair.b), first.size() - 1, origin,
                    [&complex](Index v) -> const Vec3& { return complex.position(v); });
  profile.has_ring = true;
}

}  // namespace

/// What v has now are not the planes of its faces any more.
void MemorylessCost::remember_all(Index v) {
  has_planes_of_faces_[v] = false;
  seams_.erase(v);
}

void MemorylessCost::start(CostState&& before, unsigned threads) {
  has_planes_of_faces_.assign(complex_.n_vertex_slots(), true);
  for_each_quadric(before.seams, complex_,
                   [this](Index v, const Quadric& sum) { seams_.set(v, sum, complex_.n_vertex_slots()); });
  face_area_ = before.face_area ? *before.face_area
                                : mean_face_area(complex_, seams_, ranks_.quadrics(), options_.regularization);
  ranks_.multiply_by_memoryless_factor(face_area_.first());
  for (Index v = 0; v < complex_.n_vertex_slots(); ++v) {
    if (!complex_.is_ring(v)) remember_all(v);
  }
  for_each_quadric(before.quadrics, complex_, [this](Index v, const Quadric&) { remember_all(v); });
  ranks_.start(std::move(before), threads);
}

CostState MemorylessCost::state(std::span<const Index> vertices) const {
  CostState state;
  state.face_area = face_area_;
  const auto n = std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return !has_planes_of_faces_[v]; });
  reserve_large(state.quadrics, static_cast<std::size_t>(n));
  for (Index i = 0; i < vertices.size(); ++i) {
    const Index v = vertices[i];
    if (!has_planes_of_faces_[v]) state.quadrics.push_back({i, quadric(v)});
    if (const Quadric* const seams = seams_.find(v)) state.seams.push_back({i, *seams});
  }
  state.attributes = ranks_.attributes_at(vertices);
  return state;
}

KeptOfVertices MemorylessCost::kept() const {
  KeptOfVertices kept = ranks_.kept();
  kept.changes_around_merged = true;
  return kept;
}

/// Whether the merged vertex, and its neighbours, get the planes of their faces alone.
bool MemorylessCost::forgets(const ContractionProfile& profile) const {
  return !profile.is_nonmanifold && complex_.is_ring(profile.pair.a) && complex_.is_ring(profile.pair.b);
}

/// Where the volume is kept, else at the minimum.
CandidatePositions MemorylessCost::place(ContractionProfile& profile, const PairEvaluation& ranked) const {
  CandidatePositions candidates;
  if (forgets(profile)) {
    look_at_ring(complex_, ranked.position, profile);
    if (ranked.is_minimum) {
      const VertexQuadrics& quadrics = ranks_.quadrics();
      const SymmetricMatrix sum = quadrics.matrix(profile.pair.a) + quadrics.matrix(profile.pair.b);
      const Vec3 best = ranked.position + volume_step(sum, profile.ring.volume());
      if (best != ranked.position) candidates.add(best);
    }
  }
  candidates.add(ranked.position);
  return candidates;
}

double MemorylessCost::final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                                  const Vec3& position) const {
  if (!profile.has_ring || !profile.ring.volume().is_thin()) return ranked.cost;
  const double displacement_sq = profile.ring.displacement_sq(position);
  return std::max(ranked.cost, thin_cost(displacement_sq, face_area_.now(complex_.n_faces())));
}

void MemorylessCost::merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) {
  const auto& [id, a, b] = change.pair;
  if (profile.has_ring) {
    has_planes_of_faces_[a] = has_planes_of_faces_[b] = true;
    MergedRing& ring = profile.ring;
    if (ring.moved_to() != change.position) ring.move_to(change.position, options_);
    Quadric quadric = seams_.merge(change);
    quadric.a += ring.planes();
    ranks_.quadrics().merge(change, quadric);
    ranks_.merge_attributes(change);
    change_ring(ring);
    return;
  }
  remember_all(a);
  remember_all(b);
  if (profile.is_nonmanifold) {
    remember_around(profile);
  } else {
    change_neighbours(profile, change);
  }
  ranks_.merge(profile, ranked, change);
}

void MemorylessCost::change_ring(const MergedRing& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index neighbour = ring.vertex(i);
    if (has_planes_of_faces_[neighbour]) change_planes(neighbour, ring.change(i));
  }
}

/// For a merged vertex without a ring.
void MemorylessCost::change_neighbours(const ContractionProfile& profile, const Change& change) {
  const auto corner = [this](Index v) { return PlaneChanges::Corner{v, complex_.position(v)}; };
  changes_.clear();
  for (const auto& [faces, end] :
       {std::pair(profile.first, change.before[0]), std::pair(profile.second, change.before[1])}) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      changes_.move_face(end, change.position, corner(faces[i].x), corner(faces[i].y));
    }
  }
  for (const ContractionProfile::Common& opposite : profile.opposites) {
    changes_.remove_face(change.before[0], change.before[1], corner(opposite.vertex));
  }
  for (const auto& [neighbour, planes] : changes_.sum()) {
    if (has_planes_of_faces_[neighbour]) change_planes(neighbour, planes);
  }
}

/// After a non-manifold contraction the faces at these vertices hang together in another way.
void MemorylessCost::remember_around(const ContractionProfile& profile) {
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (const Neighbour& neighbour : faces.neighbours()) remember_all(neighbour.vertex);
  }
  for (const ContractionProfile::Common& opposite : profile.opposites) {
    remember_all(opposite.vertex);
  }
  for (const auto& [x, y] : profile.nonmanifold.coincident) {
    remember_all(x);
    remember_all(y);
  }
}

}  // namespace whittle
