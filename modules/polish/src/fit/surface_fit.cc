#include "fit/surface_fit.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "original/closest_point_sums.hh"
#include "whittle/core/detail/compiler.hh"
#include "whittle/core/geometry/radius_ratio.hh"

namespace whittle::polishing {
namespace {

constexpr int n_sweeps = 2;

/// μ: the cost of moving, which holds a vertex along directions in which no point pulls. It is a share of the curvature
/// of the sum of squares along the surface. That curvature comes from the angles θ between the neighbouring normals: it
/// is about θ² of the curvature across the surface, and becomes very small as faces do.
constexpr double stiffness = 0.01;
/// The least μ, as a share of the weight of the points around: for faces in one plane.
constexpr double least_stiffness = 1e-7;

/// A face is uncovered if its closest points have less weight than this share of its area. Uncovered faces are held in
/// their planes; the missing weight is spread evenly.
constexpr double least_cover = 0.25;

/// Weight that holds back a vertex at the distance `most`, as a share of the weight of the points around.
constexpr double backward_weight = 0.01;
/// Largest factor by which that weight grows beyond the distance.
constexpr double most_backward_growth = 100;

/// Weight of a line against the surface: that of a strip this many times as wide as its edges are long. With more,
/// lines come nearer to the original's, but the surface less near.
constexpr double line_weight = 3;

/// Largest squared distance of a vertex from the planes of its faces, over the mean squared distance of the points.
constexpr double most_drift = 4;

/// Largest squared move of a vertex, over the mean area of its faces. In equilateral faces this is about a seventh of
/// an edge. For longer moves the mesh is too coarse: closest points would change.
constexpr double most_area = 0.05;

/// A face needs no check for folds if it has turned by less than this cosine (26°), and its neighbours were less than
/// 90° apart from it. If both faces at an edge have, they are less than 142° apart.
constexpr double wary_cosine = 0.9;

constexpr double always_wary = 2;  ///< more than the square of any cosine

constexpr int most_halvings = 5;

/// m⁻¹ r by the adjugate. \pre m is well-conditioned
Vec3 solve(const SymmetricMatrix& m, const Vec3& r) {
  const Vec3 row0(m.xx, m.xy, m.xz);
  const Vec3 row1(m.xy, m.yy, m.yz);
  const Vec3 row2(m.xz, m.yz, m.zz);
  const Vec3 minor0 = row1.cross(row2);
  return Vec3(minor0.dot(r), row2.cross(row0).dot(r), row0.cross(row1).dot(r)) / row0.dot(minor0);
}

/// The part of x perpendicular to a direction; zero if the direction has no length.
Vec3 across(const Vec3& way, const Vec3& x) {
  const double square = way.squaredNorm();
  return square > 0 ? Vec3(x - way.dot(x) / square * way) : Vec3::Zero();
}

}  // namespace

SurfaceFit::SurfaceFit(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits,
                       const MeshLines& lines, const std::vector<std::uint8_t>& is_fixed,
                       const detail::Workers& workers)
    : mesh_(mesh),
      neighbors_(neighbors),
      limits_(limits),
      lines_(lines),
      is_fixed_(is_fixed),
      blocks_(mesh.positions.size()),
      is_inside_(mesh.positions.size(), 1),
      line_sums_(lines.edges().size()) {
  measure_faces(workers);
  for (const Triangle& face : mesh.faces) {
    if (blocks_.is_in_one(face)) continue;
    for (const Index v : face) is_inside_[v] = 0;
  }
  for (const MeshLines::Edge& edge : lines.edges())
    ways_.push_back(mesh.positions[edge.to] - mesh.positions[edge.from]);
}

void SurfaceFit::measure_faces(const detail::Workers& workers) {
  const std::span<const Triangle> faces = mesh_.faces;
  fits_.resize(faces.size());
  for_each_range(faces.size(), workers, [this, faces](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Vec3 normal = area_normal(mesh_.positions, faces[f]);
      const double length = normal.norm();
      fits_[f] = {{}, length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero()), 0.5 * length, always_wary};
    }
  });
  const auto is_near_folded = [this](Index f, Index slot) {
    const Index other = neighbors_.beyond(f, slot).face;
    return other != invalid_index && !(limits_.along(f, slot, fits_[f].normal, fits_[other].normal) > 0);
  };
  for_each_range(faces.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Index>(begin); f < end; ++f) {
      const bool may_always_turn =
          limits_.only_folds() && !is_near_folded(f, 0) && !is_near_folded(f, 1) && !is_near_folded(f, 2);
      if (may_always_turn) fits_[f].wary_cosine_sq = wary_cosine * wary_cosine;
    }
  });
}

void SurfaceFit::PointSums::add(const ClosestFacePoint& closest, double point_weight) {
  const double b1 = closest.second;
  const double b2 = closest.third;
  const double b0 = 1 - b1 - b2;
  const double d = closest.distance;
  const std::array weighted{point_weight * b0, point_weight * b1, point_weight * b2};
  products[0] += weighted[0] * b0;
  products[1] += weighted[0] * b1;
  products[2] += weighted[0] * b2;
  products[3] += weighted[1] * b1;
  products[4] += weighted[1] * b2;
  products[5] += weighted[2] * b2;
  for (std::size_t j = 0; j < 3; ++j) errors[j] += weighted[j] * d;
  squares += point_weight * d * d;
  weight += point_weight;
}

SurfaceFit::PointSums& SurfaceFit::PointSums::operator+=(const PointSums& other) {
  for (std::size_t i = 0; i < products.size(); ++i) products[i] += other.products[i];
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] += other.errors[i];
  squares += other.squares;
  weight += other.weight;
  return *this;
}

void SurfaceFit::add(const Origins& origins, const FitWeights& weights, const detail::Workers& workers) {
  const auto add_point = [&weights](PointSums& sums, const ClosestFacePoint& closest, double area) {
    sums.add(closest, area * weights.weight(closest.distance));
  };
  const auto of_face = [this](Index f) -> PointSums& { return fits_[f]; };
  sum_over_closest_points<PointSums>(origins, mesh_, add_point, of_face, workers);
  for_each_range(fits_.size(), workers, [this](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) hold_if_uncovered(fits_[f]);
  });
}

void SurfaceFit::add(const ClosestLinePoint& closest, double weight) {
  LineSums& sums = line_sums_[closest.edge];
  const Vec3 d = across(ways_[closest.edge], closest.offset);
  const std::array shares{1 - closest.share, closest.share};
  sums.products[0] += weight * shares[0] * shares[0];
  sums.products[1] += weight * shares[0] * shares[1];
  sums.products[2] += weight * shares[1] * shares[1];
  for (std::size_t j = 0; j < 2; ++j) sums.errors[j] += weight * shares[j] * d;
  sums.squares += weight * d.squaredNorm();
  sums.weight += weight;
}

void SurfaceFit::prefetch_around(Index v) const {
  for (const Corner& corner : mesh_.corners.of(v)) {
    prefetch_line(&fits_[corner.face]);
    prefetch_line(&fits_[corner.face].products[3]);
  }
}

std::vector<Vec3> SurfaceFit::moved(double relaxation, const detail::Workers& workers) {
  relaxation_ = relaxation;
  positions_.assign(mesh_.positions.begin(), mesh_.positions.end());
  moves_.assign(positions_.size(), Vec3::Zero());
  for (int i = 0; i < n_sweeps; ++i) sweep(workers);
  return std::move(positions_);
}

/// A move reads vertices up to two edges away. Vertices inside of blocks are moved first, on all threads: a vertex of
/// another block that such a move reads has a neighbour in this block, and stays. Then the others are moved.
void SurfaceFit::sweep(const detail::Workers& workers) {
  constexpr Index ahead = 4;
  const auto move_all = [this](std::size_t block, bool is_inside) {
    const Index end = blocks_.end(block);
    for (Index v = blocks_.begin(block); v < end; ++v) {
      if (v + ahead < end) prefetch_around(v + ahead);
      if ((is_inside_[v] != 0) == is_inside && is_fixed_[v] == 0) move_to_minimum(v);
    }
  };
  for_each_block(blocks_.size(), workers, [&](std::size_t block) { move_all(block, true); });
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    workers.update(1);
    move_all(block, false);
  }
}

/// Moves a vertex to where its sum is least, or part of the way.
void SurfaceFit::move_to_minimum(Index v) {
  const Pull pull = pull_at(v);
  if (!(pull.weight > 0) || pull.is_held) return;
  Vec3 move = wanted_move(v, pull);
  for (int i = 0; i < most_halvings; ++i) {
    if (!is_too_far(v, moves_[v] + move, pull) && !spoils_a_face(v, positions_[v] + move)) {
      moves_[v] += move;
      positions_[v] += move;
      return;
    }
    move *= 0.5;
  }
}

/// Spreads the missing weight evenly, at distance zero.
void SurfaceFit::hold_if_uncovered(Face& fit) const {
  const double missing = least_cover * fit.area - fit.weight;
  if (!(missing > 0)) return;
  fit.weight += missing;
  for (const std::size_t i : {0U, 3U, 5U}) fit.products[i] += missing / 6;
  for (const std::size_t i : {1U, 2U, 4U}) fit.products[i] += missing / 12;
}

void SurfaceFit::hold_back(std::span<const Vec3> offsets, double most) {
  offsets_ = offsets;
  most_backward_ = most;
}

SurfaceFit::Pull SurfaceFit::pull_at(Index v) const {
  Pull pull;
  Vec3 normal = Vec3::Zero();
  for (const auto& [f, slot] : mesh_.corners.of(v)) {
    const Face& fit = fits_[f];
    const Vec3& n = fit.normal;
    double error = relaxation_ * fit.errors[slot];
    for (Index k = 0; k < 3; ++k) error -= fit.product(slot, k) * n.dot(moves_[mesh_.faces[f][k]]);
    pull.matrix += SymmetricMatrix::outer(n, fit.product(slot, slot));
    pull.force += error * n;
    normal += fit.product(slot, slot) * n;
    pull.weight += fit.weight;
    pull.squares += fit.squares;
    pull.area += fit.area;
  }
  pull.area /= static_cast<double>(mesh_.corners.of(v).size());
  const double square = normal.squaredNorm();
  const double across = square > 0 ? normal.dot(pull.matrix * normal) / square : 0;
  pull.along = 0.5 * std::max(0.0, pull.matrix.trace() - across);
  if (!offsets_.empty()) add_backward(v, pull);
  if (!lines_.empty()) add_lines(v, pull);
  if (shape_weight_ > 0) add_shape(v, pull);
  return pull;
}

/// Pulls along the surface alone, so the distances across it don't change.
void SurfaceFit::add_shape(Index v, Pull& pull) const {
  Vec3 normal = Vec3::Zero();
  for (const Corner& corner : mesh_.corners.of(v)) normal += area_normal(positions_, mesh_.faces[corner.face]);
  const double length = normal.norm();
  if (!(length > 0)) return;
  normal /= length;
  const double weight = shape_weight_ * pull.weight;
  SymmetricMatrix along = SymmetricMatrix::identity(weight);
  along -= SymmetricMatrix::outer(normal, weight);
  pull.matrix += along;
  pull.force += along * (middle_around(v) - positions_[v]);
}

/// Mean position of the neighbours; for a vertex on lines, of its neighbours along the lines.
Vec3 SurfaceFit::middle_around(Index v) const {
  Vec3 sum = Vec3::Zero();
  const std::span<const Index> edges = lines_.empty() ? std::span<const Index>{} : lines_.at(v);
  for (const Index e : edges)
    sum += positions_[lines_.edges()[e].from == v ? lines_.edges()[e].to : lines_.edges()[e].from];
  if (!edges.empty()) return sum / static_cast<double>(edges.size());
  for (const auto& [f, slot] : mesh_.corners.of(v)) {
    sum += positions_[corner_after(mesh_.faces[f], slot, 1)] + positions_[corner_after(mesh_.faces[f], slot, 2)];
  }
  return sum / (2 * static_cast<double>(mesh_.corners.of(v).size()));
}

/// The cost w (h / most)⁸ of a distance h from the original, by its slope and curvature at the vertex' distance.
void SurfaceFit::add_backward(Index v, Pull& pull) const {
  const double square = offsets_[v].squaredNorm();
  if (!(square > 0)) return;
  const double x = square / (most_backward_ * most_backward_);
  const double slope = backward_weight * pull.weight * std::min(x * x * x, most_backward_growth);  // over h
  const double curvature = 7 * slope;
  const Vec3 away = offsets_[v] / std::sqrt(square);
  pull.matrix += SymmetricMatrix::outer(away, curvature);
  pull.force -= slope * offsets_[v] + curvature * away.dot(moves_[v]) * away;
  pull.squares += pull.weight * square;
}

void SurfaceFit::add_lines(Index v, Pull& pull) const {
  double weight = 0;
  for (const Index e : lines_.at(v)) {
    const auto& [from, to, kind] = lines_.edges()[e];
    const LineSums& sums = line_sums_[e];
    const std::size_t slot = v == from ? 0 : 1;
    const Vec3& way = ways_[e];
    const double length = way.norm();
    if (!(length > 0)) continue;
    const double scale = line_weight * length;
    const Vec3 moves = sums.products[slot] * moves_[from] + sums.products[slot + 1] * moves_[to];
    const auto across_way = [&](double factor) {
      SymmetricMatrix matrix = SymmetricMatrix::identity(factor);
      return matrix -= SymmetricMatrix::outer(way / length, factor);
    };
    pull.matrix += across_way(scale * sums.products[2 * slot]);
    pull.lines += across_way(sums.weight);
    pull.force += scale * (sums.errors[slot] - across(way, moves));
    pull.line_squares += sums.squares;
    weight += sums.weight;
  }
  pull.is_held = !lines_.at(v).empty() && !(weight > 0);
}

Vec3 SurfaceFit::wanted_move(Index v, const Pull& pull) const {
  const double holding = stiffness * pull.along + least_stiffness * pull.weight;
  SymmetricMatrix matrix = pull.matrix;
  matrix += SymmetricMatrix::identity(holding);
  return solve(matrix, pull.force - holding * moves_[v]);
}

bool SurfaceFit::is_too_far(Index v, const Vec3& moved, const Pull& pull) const {
  if (moved.squaredNorm() > most_area * pull.area) return true;
  double from_planes = 0;
  for (const Corner& corner : mesh_.corners.of(v)) {
    const double height = fits_[corner.face].normal.dot(moved);
    from_planes += fits_[corner.face].weight * height * height;
  }
  return !(from_planes <= most_drift * pull.squares) ||
         !(moved.dot(pull.lines * moved) <= most_drift * pull.line_squares);
}

/// Whether a face turns too far from where it was at the start, turns too far to a neighbour, or becomes thin.
bool SurfaceFit::spoils_a_face(Index v, const Vec3& to) const {
  for (const auto& [f, slot] : mesh_.corners.of(v)) {
    const Vec3& x = positions_[corner_after(mesh_.faces[f], slot, 1)];
    const Vec3& y = positions_[corner_after(mesh_.faces[f], slot, 2)];
    const Vec3 normal = area_normal(to, x, y);
    const double square = normal.squaredNorm();
    const double along = normal.dot(fits_[f].normal);
    if (!(along > 0 && along * along > least_turn_cosine * least_turn_cosine * square)) return true;
    if (along * along < fits_[f].wary_cosine_sq * square && turns_to_a_neighbor(f, v, to)) return true;
    if (limits_.may_be_thin(square, x - to, y - to) &&
        limits_.forbid_thinning(radius_ratio(positions_[v], x, y), radius_ratio(to, x, y)))
      return true;
  }
  return false;
}

/// Whether the move turns a face of v to a neighbour in a forbidden way.
bool SurfaceFit::turns_to_a_neighbor(Index face, Index v, const Vec3& to) const {
  const auto normal = [&](Index f, bool is_after) { return normal_with(f, v, is_after ? to : positions_[v]); };
  return limits_.forbid(face, 0, normal) || limits_.forbid(face, 1, normal) || limits_.forbid(face, 2, normal);
}

/// A face's normal with v at another position.
Vec3 SurfaceFit::normal_with(Index face, Index v, const Vec3& to) const {
  const auto position = [&](Index u) -> const Vec3& { return u == v ? to : positions_[u]; };
  const auto& [a, b, c] = mesh_.faces[face];
  return area_normal(position(a), position(b), position(c));
}

}  // namespace whittle::polishing
