#include "whittle/metrics/detail/prover.hh"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle::metrics {
namespace {

/// Distances are found to this accuracy where they are smaller: lengths are about 1.
constexpr double least_accuracy = 1e-9;

/// How much less accurately they are found where it takes too many pieces: a thousandth gets about 1.
constexpr double most_coarseness = 1024;

Vec3 center(const Corners& corners) { return (corners[0] + corners[1] + corners[2]) / 3; }

}  // namespace

Verdict Prover::prove(const Corners& triangle, double distance, Index hint, FarthestPoint& farthest) {
  const auto limit = [distance](const FarthestPoint&) { return distance; };
  const auto decide = [distance](const FarthestPoint& point) {
    if (point.distance > distance + slack) return Verdict::refuted;
    return point.distance > distance - 3 * slack ? Verdict::undecided : Verdict::proven;
  };
  begin(triangle, hint);
  return search(limit, decide, farthest);
}

double Prover::find_farthest(const Corners& triangle, double from, double accuracy, double most, Index hint,
                             FarthestPoint& farthest) {
  double coarseness = 1;
  const auto limit = [&](const FarthestPoint& point) {
    const double found = std::max(from, point.distance);
    const double sought = found + coarseness * (accuracy * found + least_accuracy);
    return found < most - 4 * slack ? std::min(sought, most) : sought;
  };
  const auto decide = [](const FarthestPoint&) { return Verdict::proven; };
  begin(triangle, hint);
  // Where it takes too many pieces, those that are left are to be within more.
  while (search(limit, decide, farthest) == Verdict::undecided && coarseness < most_coarseness) {
    if (limit(farthest) == most) most = std::numeric_limits<double>::infinity();
    coarseness *= 4;
  }
  double proven = limit(farthest);
  for (const Piece& left : pieces_) proven = std::max(proven, distance_from_one(left.corners, left.hint) + slack);
  return proven;
}

void Prover::begin(const Corners& triangle, Index hint) {
  surface_ = target_.faces();
  steps_.clear();
  pieces_.assign(1, {triangle, hint == invalid_index ? last_ : hint});
  if (pieces_[0].hint == invalid_index) pieces_[0].hint = target_.nearest(triangle[0], invalid_index).face;
}

/// Proves the pieces that are left, and puts what they are split into in their place.
/// \param limit `limit(farthest)` is the distance that a piece is to be within
/// \param decide `decide(farthest)` ends the search if it isn't `proven`
template <class Limit, class Decide>
Verdict Prover::search(const Limit& limit, const Decide& decide, FarthestPoint& farthest) {
  for (int n_pieces = 0; !pieces_.empty(); ++n_pieces) {
    if (n_pieces >= most_pieces_) return Verdict::undecided;
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (is_proven(piece.corners, piece.hint, limit(farthest))) continue;
    const Vec3 probe = suspect(piece.corners, piece.hint);
    const NearFace near = target_.nearest(probe, piece.hint);
    if (near.distance > farthest.distance) farthest = {probe, near.distance};
    const Verdict verdict = decide(farthest);
    if (verdict != Verdict::proven) return verdict;
    last_ = near.face;
    if (near.face != piece.hint && is_proven(piece.corners, near.face, limit(farthest))) continue;
    last_ = target_.nearest(center(piece.corners), near.face).face;
    if (!is_near(piece.corners, last_, limit(farthest))) split(piece.corners, last_);
  }
  return Verdict::proven;
}

/// Whether a piece is proven to be near to one face, or to the faces around it. If so, that is a step of the proof.
bool Prover::is_proven(const Corners& corners, Index face, double distance) {
  if (is_near(corners, face, distance)) return true;
  const Index over_center = patch_.look_from(surface_, corners, face);
  if (over_center == invalid_index) return false;
  if (over_center != face && is_near(corners, over_center, distance)) return true;
  if (!patch_.covers(distance)) return false;
  steps_.push_back({ProofStep::Kind::patch, over_center});
  return true;
}

bool Prover::is_near(const Corners& corners, Index face, double distance) {
  if (!(distance_from_one(corners, face) <= distance - slack)) return false;
  steps_.push_back({ProofStep::Kind::face, face});
  return true;
}

/// A point of the piece that may be far: where the faces looked at last were too high, or the corner that is farthest
/// from one face.
Vec3 Prover::suspect(const Corners& corners, Index face) const {
  if (patch_.suspect()) return *patch_.suspect();
  const Corners other = surface_.corners(face);
  return *std::max_element(corners.begin(), corners.end(),
                           [&](const Vec3& p, const Vec3& q) { return distance_to(other, p) < distance_to(other, q); });
}

/// The largest distance of a piece's points from one face. It is convex, so it is greatest at a corner.
double Prover::distance_from_one(const Corners& corners, Index face) const {
  const Corners other = surface_.corners(face);
  double most = 0;
  for (const Vec3& p : corners) most = std::max(most, distance_to(other, p));
  return most + surface_.offset(face);
}

/// Halves the longest edge.
void Prover::split(const Corners& c, Index hint) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double square = (c[(i + 1) % 3] - c[i]).squaredNorm();
    if (square > most) {
      most = square;
      longest = i;
    }
  }
  steps_.push_back({ProofStep::Kind::halves, static_cast<Index>(longest)});
  const Vec3& from = c[longest];
  const Vec3& to = c[(longest + 1) % 3];
  const Vec3& opposite = c[(longest + 2) % 3];
  const Vec3 middle = 0.5 * (from + to);
  pieces_.push_back({{middle, to, opposite}, hint});
  pieces_.push_back({{from, middle, opposite}, hint});
}

}  // namespace whittle::metrics
