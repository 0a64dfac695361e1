#include "surface_fit.hh"

#include <cmath>

#include "turn_limits.hh"

namespace whittle {
namespace {

/// μ: how much moving costs, of the weight of the points around. Holds a vertex along directions that no point cares
/// about.
constexpr double stiffness = 5e-4;

/// How far a vertex may leave the planes of its faces, as a multiple of how far the points are off: their squares.
constexpr double most_drift = 4;

/// How far a vertex may move at all: the square of that, in areas of its faces. Of an equilateral one 0.05 are about a
/// seventh of an edge. Where more is wanted, the mesh is too coarse for feet to say what is best.
constexpr double most_area = 0.05;

/// A face that has turned by less than this cosine, and whose neighbours are at less than 90°, needs no look: if both
/// faces at an edge have, they are at less than 142°.
constexpr double wary_cosine = 0.9;

constexpr double always_wary = 2;

constexpr int most_halvings = 5;

/// m⁻¹ r by the adjugate. \pre m is well-conditioned
Vec3 solve(const SymmetricMatrix& m, const Vec3& r) {
  const Vec3 row0(m.xx, m.xy, m.xz);
  const Vec3 row1(m.xy, m.yy, m.yz);
  const Vec3 row2(m.xz, m.yz, m.zz);
  const Vec3 minor0 = row1.cross(row2);
  return Vec3(minor0.dot(r), row2.cross(row0).dot(r), row0.cross(row1).dot(r)) / row0.dot(minor0);
}

}  // namespace

SurfaceFit::SurfaceFit(const std::vector<Triangle>& faces, const VertexCorners& corners, const FaceNeighbors& neighbors,
                       const std::vector<std::uint8_t>& is_fixed)
    : faces_(faces), corners_(corners), neighbors_(neighbors), is_fixed_(is_fixed) {}

void SurfaceFit::start(std::vector<Vec3>& positions) {
  positions_ = &positions;
  sums_.assign(faces_.size(), {});
  moves_.assign(positions.size(), Vec3::Zero());
  normals_.clear();
  areas_.clear();
  for (const auto& [a, b, c] : faces_) {
    const Vec3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    const double length = normal.norm();
    areas_.push_back(0.5 * length);
    normals_.push_back(length > 0 ? Vec3(normal / length) : Vec3::Zero());
  }
  wary_.assign(faces_.size(), wary_cosine);
  for (Index f = 0; f < faces_.size(); ++f) {
    for (Index place = 0; place < 3; ++place) {
      const Index other = neighbors_.beyond(f, place).face;
      if (other == invalid_index) continue;
      const double cosine = normals_[f].dot(normals_[other]);
      if (!((neighbors_.is_twisted(f, place) ? -cosine : cosine) > 0)) wary_[f] = always_wary;
    }
  }
}

void SurfaceFit::add(const Foot& foot, double weight) {
  Sums& sums = sums_[foot.face];
  const double b1 = foot.second;
  const double b2 = foot.third;
  const double b0 = 1 - b1 - b2;
  const double d = foot.distance;
  const std::array weighted{weight * b0, weight * b1, weight * b2};
  sums.products[0] += weighted[0] * b0;
  sums.products[1] += weighted[0] * b1;
  sums.products[2] += weighted[0] * b2;
  sums.products[3] += weighted[1] * b1;
  sums.products[4] += weighted[1] * b2;
  sums.products[5] += weighted[2] * b2;
  for (std::size_t j = 0; j < 3; ++j) sums.errors[j] += weighted[j] * d;
  sums.squares += weight * d * d;
  sums.weight += weight;
}

void SurfaceFit::sweep() {
  for (Index v = 0; v < corners_.n_vertices(); ++v) {
    if (is_fixed_[v] != 0) continue;
    const Pull pull = pull_at(v);
    if (!(pull.weight > 0)) continue;
    Vec3 move = wanted_move(v, pull);
    int n_halvings = 0;
    while (n_halvings < most_halvings &&
           (is_too_far(moves_[v] + move, pull) || turns_a_face(v, (*positions_)[v] + move))) {
      move *= 0.5;
      ++n_halvings;
    }
    if (n_halvings == most_halvings) continue;
    moves_[v] += move;
    (*positions_)[v] += move;
  }
}

SurfaceFit::Pull SurfaceFit::pull_at(Index v) const {
  Pull pull;
  for (const auto& [f, place] : corners_.of(v)) {
    const Sums& sums = sums_[f];
    const Vec3& n = normals_[f];
    double error = sums.errors[place];
    for (Index k = 0; k < 3; ++k) error -= sums.product(place, k) * n.dot(moves_[faces_[f][k]]);
    pull.matrix += SymmetricMatrix::outer(n, sums.product(place, place));
    pull.force += error * n;
    pull.planes += SymmetricMatrix::outer(n, sums.weight);
    pull.weight += sums.weight;
    pull.squares += sums.squares;
    pull.area += areas_[f];
  }
  pull.area /= static_cast<double>(corners_.of(v).size());
  return pull;
}

Vec3 SurfaceFit::wanted_move(Index v, const Pull& pull) const {
  const double holding = stiffness * pull.weight;
  SymmetricMatrix matrix = pull.matrix;
  matrix += SymmetricMatrix::identity(holding);
  return solve(matrix, pull.force - holding * moves_[v]);
}

bool SurfaceFit::is_too_far(const Vec3& moved, const Pull& pull) const {
  return !(moved.dot(pull.planes * moved) <= most_drift * pull.squares) || moved.squaredNorm() > most_area * pull.area;
}

/// Against how the faces are now, and how they were at the start; and whether it folds two.
bool SurfaceFit::turns_a_face(Index v, const Vec3& to) const {
  const std::vector<Vec3>& positions = *positions_;
  for (const auto& [f, place] : corners_.of(v)) {
    const Vec3& x = positions[corner_after(faces_[f], place, 1)];
    const Vec3& y = positions[corner_after(faces_[f], place, 2)];
    const Vec3 after = (x - to).cross(y - to);
    const double length = after.norm();
    const double along = after.dot(normals_[f]);
    const Vec3 before = (x - positions[v]).cross(y - positions[v]);
    if (!(along > least_turn_cosine * length) || !(after.dot(before) > least_turn_cosine * length * before.norm()))
      return true;
    if (along < wary_[f] * length && folds(f, v, to)) return true;
  }
  return false;
}

/// Whether the move takes a face of v too near to lying on a neighbour, and nearer than it did.
bool SurfaceFit::folds(Index face, Index v, const Vec3& to) const {
  const auto cosine = [](const Vec3& a, const Vec3& b) {
    return a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm());
  };
  const Vec3& from = (*positions_)[v];
  for (Index place = 0; place < 3; ++place) {
    const Index other = neighbors_.beyond(face, place).face;
    if (other == invalid_index) continue;
    const double sign = neighbors_.is_twisted(face, place) ? -1 : 1;
    const double after = sign * cosine(area_normal(face, v, to), area_normal(other, v, to));
    if (!(after < least_fold_cosine)) continue;
    if (!(after >= sign * cosine(area_normal(face, v, from), area_normal(other, v, from)))) return true;
  }
  return false;
}

/// A face's normal if v were elsewhere.
Vec3 SurfaceFit::area_normal(Index face, Index v, const Vec3& to) const {
  const auto position = [&](Index u) -> const Vec3& { return u == v ? to : (*positions_)[u]; };
  const auto& [a, b, c] = faces_[face];
  return (position(b) - position(a)).cross(position(c) - position(a));
}

}  // namespace whittle
