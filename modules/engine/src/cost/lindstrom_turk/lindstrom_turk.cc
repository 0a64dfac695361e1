#include "whittle/engine/formula/lindstrom_turk.hh"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>

#include "whittle/core/detail/portable_math.hh"

namespace whittle {
namespace {

Vec3 any_perpendicular(const Vec3& a) {
  const Vec3 size = a.cwiseAbs();
  const bool x_is_least = size.x() <= size.y() && size.x() <= size.z();
  const Vec3 axis = x_is_least ? Vec3::UnitX() : size.y() <= size.z() ? Vec3::UnitY() : Vec3::UnitZ();
  return a.cross(axis).normalized();
}

/// Of unit length, in the columns; that in which the matrix is least first.
Eigen::Matrix3d main_directions(const SymmetricMatrix& m) {
  Eigen::Matrix3d matrix;
  matrix << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors();
}

/// Perpendicular to `normal`, of unit length: where the matrix is greatest, and where it is least.
std::pair<Vec3, Vec3> main_directions_across(const SymmetricMatrix& m, const Vec3& normal) {
  const Vec3 u = any_perpendicular(normal);
  const Vec3 v = normal.cross(u);
  const double half_difference = 0.5 * (u.dot(m * u) - v.dot(m * v));
  const double mixed = u.dot(m * v);
  const double radius = detail::hypotenuse(half_difference, mixed);
  // (cos, sin) of the greatest one's angle to u, not of unit length; of two forms the one without cancellation.
  double along = half_difference >= 0 ? radius + half_difference : mixed;
  double across = half_difference >= 0 ? mixed : radius - half_difference;
  const double length = detail::hypotenuse(along, across);
  if (!(length > 0)) return {u, v};  // the same in all directions
  along /= length;
  across /= length;
  return {along * u + across * v, along * v - across * u};
}

Quadric scaled(const Quadric& q, double s) {
  const SymmetricMatrix& a = q.a;
  return {{s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz}, s * q.b, s * q.c};
}

// With the rounding of lanes, whatever Eigen does.

double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

Quadric squares_of(const VolumeLanes<double>& v) {
  return {{v.xx, v.xy, v.xz, v.yy, v.yz, v.zz}, {v.b.x, v.b.y, v.b.z}, v.c};
}

}  // namespace

/// |p × q − x × e|² = xᵀ (|e|² I − e eᵀ) x − 2 x · (e × (p × q)) + |p × q|², e = q − p.
void BorderSums::add(const Vec3& p, const Vec3& q) {
  const Vec3 e = q - p;
  const Vec3 a = p.cross(q);
  edge += e;
  area += a;
  SymmetricMatrix matrix = SymmetricMatrix::identity(e.squaredNorm());
  matrix += SymmetricMatrix::outer(e, -1);
  squares += Quadric{matrix, -e.cross(a), a.squaredNorm()};
  ++n_edges;
}

void PointConstraints::add(const Vec3& a, double b, double noise) {
  if (n_ == 3) return;
  const double length = a.norm();
  if (!(length > noise)) return;
  const Vec3 unit = a / length;
  if (n_ == 1) {
    const double cosine = rows_[0].dot(unit);
    if (cosine * cosine >= 1 - least_constraint_sine_sq) return;
  }
  if (n_ == 2) {
    const Vec3 fixed = rows_[0].cross(rows_[1]);
    const double sine = fixed.dot(unit);
    if (sine * sine <= least_constraint_sine_sq * fixed.squaredNorm()) return;
  }
  rows_[n_] = unit;
  values_[n_] = b / length;
  ++n_;
}

/// Q (A x + b) = 0, the rows of Q perpendicular to the constraints taken and to one another: where there is a choice,
/// along the directions in which A is greatest and least, so that it does not depend on how the mesh is turned.
void PointConstraints::add_least(const Quadric& quadric) {
  const double noise = constraint_noise_share * quadric.a.trace();
  const auto add_along = [&](const Vec3& way) { add(quadric.a * way, -way.dot(quadric.b), noise); };
  if (n_ == 0) {
    const Eigen::Matrix3d directions = main_directions(quadric.a);
    for (int i = 2; i >= 0; --i) add_along(directions.col(i));
  } else if (n_ == 1) {
    const auto [greatest, least] = main_directions_across(quadric.a, rows_[0]);
    add_along(greatest);
    add_along(least);
  } else if (n_ == 2) {
    add_along(rows_[0].cross(rows_[1]).normalized());
  }
}

/// Cramer's rule.
Vec3 PointConstraints::solve() const {
  const Vec3 c12 = rows_[1].cross(rows_[2]);
  const Vec3 sum = values_[0] * c12 + values_[1] * rows_[2].cross(rows_[0]) + values_[2] * rows_[0].cross(rows_[1]);
  return sum / rows_[0].dot(c12);
}

LindstromTurk::LindstromTurk(const VolumeLanes<double>& volume, const BorderSums& border, const Vec3& first,
                             const Vec3& second)
    : volume_(volume),
      objective_(scaled(squares_of(volume), lindstrom_turk_volume_weight / 36)),
      first_(first),
      second_(second) {
  if (border.n_edges == 0) {
    by_volume_ = volume_constraints(volume_);
    if (by_volume_->has_normal) return;
    by_volume_.reset();
  }
  constraints_.add({volume.normal.x, volume.normal.y, volume.normal.z}, volume.offset,
                   constraint_noise_share * std::sqrt(volume.trace()));
  if (border.n_edges > 0) {
    const double length_sq = (second - first).squaredNorm();
    objective_ += scaled(border.squares, (1 - lindstrom_turk_volume_weight) * length_sq / 4);
    SymmetricMatrix matrix = SymmetricMatrix::identity(border.edge.squaredNorm());
    matrix += SymmetricMatrix::outer(border.edge, -1);
    constraints_.add_least({matrix, -border.edge.cross(border.area), 0});
  }
  constraints_.add_least(objective_);
}

void LindstromTurk::add_neighbours(const NeighbourLanes<double>& neighbours) {
  if (by_volume_) {
    whittle::add_neighbours<double>(*by_volume_, neighbours);
    by_volume_->has_second = by_volume_->has_third = true;
  } else {
    const auto& [x, y, z] = neighbours.position;
    constraints_.add_least({SymmetricMatrix::identity(neighbours.n), -Vec3(x, y, z), 0});
  }
}

PairEvaluation LindstromTurk::at(const Vec3& position) const {
  const PointLanes<double> to_first = point_lanes(Vec3(position - first_));
  const PointLanes<double> to_second = point_lanes(Vec3(position - second_));
  const double spread = spread_cost(volume_.trace(), to_first, to_second);
  const double cost = std::max(0.0, objective_(position)) + (lindstrom_turk_volume_weight / 36) * spread;
  return {cost, cost, position, false};
}

PairEvaluation LindstromTurk::at_better_end() const {
  const PairEvaluation first = at(first_);
  const PairEvaluation second = at(second_);
  return first.cost <= second.cost ? first : second;
}

PairEvaluation LindstromTurk::at_best_candidate() const {
  const PairEvaluation end = at_better_end();
  const PairEvaluation middle = at(0.5 * (first_ + second_));
  return middle.cost <= end.cost ? middle : end;
}

/// Where the constraints put it, if they fix it.
std::optional<PairEvaluation> LindstromTurk::at_constraints() const {
  if (!is_determined()) return std::nullopt;
  if (!by_volume_) return at(constraints_.solve());
  const auto [x, cost] = place_by_volume(*by_volume_, volume_, point_lanes(first_), point_lanes(second_));
  return PairEvaluation{cost, cost, {x.x, x.y, x.z}, false};
}

PairEvaluation LindstromTurk::evaluate(PairConstraint constraint) const {
  if (constraint == PairConstraint::first) return at(first_);
  if (constraint == PairConstraint::second) return at(second_);
  if (constraint == PairConstraint::either) return at_better_end();
  const std::optional<PairEvaluation> evaluation = at_constraints();
  if (!evaluation) return at_best_candidate();
  const Vec3 way = second_ - first_;
  const Vec3 offset = evaluation->position - 0.5 * (first_ + second_);
  const bool is_near = dot(offset, offset) <= (max_placement_reach * max_placement_reach) * dot(way, way);
  return is_near ? *evaluation : at_best_candidate();
}

}  // namespace whittle
