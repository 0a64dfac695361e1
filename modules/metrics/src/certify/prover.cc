#include "certify/prover.hh"

#include <algorithm>
#include <cmath>

namespace whittle::metrics {
namespace {

/// Pieces of a triangle that are looked at before it is given up.
constexpr int most_pieces = 1 << 16;

/// Distances are found to this accuracy where they are smaller: lengths are about 1.
constexpr double least_accuracy = 1e-9;

}  // namespace

Verdict Prover::prove(const Corners& triangle, double distance, FarthestPoint& farthest) {
  const auto limit = [distance](const FarthestPoint&) { return distance; };
  const auto decide = [distance](const FarthestPoint& point) {
    if (point.distance > distance + slack) return Verdict::refuted;
    return point.distance > distance - 3 * slack ? Verdict::undecided : Verdict::proven;
  };
  return search(triangle, limit, decide, farthest);
}

double Prover::find_farthest(const Corners& triangle, double from, double accuracy, FarthestPoint& farthest) {
  const auto limit = [=](const FarthestPoint& point) {
    return (1 + accuracy) * std::max(from, point.distance) + least_accuracy;
  };
  const auto decide = [](const FarthestPoint&) { return Verdict::proven; };
  search(triangle, limit, decide, farthest);
  double most = limit(farthest);
  for (const Piece& left : pieces_) most = std::max(most, distance_from_one(left.corners, left.hint) + slack);
  return most;
}

/// \param limit `limit(farthest)` is the distance that a piece is to be within
/// \param decide `decide(farthest)` ends the search if it isn't `proven`
template <class Limit, class Decide>
Verdict Prover::search(const Corners& triangle, const Limit& limit, const Decide& decide, FarthestPoint& farthest) {
  pieces_.assign(1, {triangle, hint_});
  for (int n_pieces = 0; !pieces_.empty(); ++n_pieces) {
    if (n_pieces >= most_pieces) return Verdict::undecided;
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (piece.hint != invalid_index && distance_from_one(piece.corners, piece.hint) <= limit(farthest) - slack)
      continue;
    std::array<Index, 3> nearest;
    for (std::size_t i = 0; i < 3; ++i) {
      const ClosestPoint closest = surface_.nearest(piece.corners[i], hint_);
      nearest[i] = hint_ = closest.face;
      const double distance = std::sqrt(closest.distance_sq);
      if (distance > farthest.distance) farthest = {piece.corners[i], distance};
    }
    const Verdict verdict = decide(farthest);
    if (verdict != Verdict::proven) return verdict;
    const double most = limit(farthest);
    const bool is_near = std::any_of(nearest.begin(), nearest.end(), [&](Index face) {
      return distance_from_one(piece.corners, face) <= most - slack;
    });
    if (!is_near && !patch_.covers(piece.corners, nearest[0], most)) split(piece.corners, nearest[0]);
  }
  return Verdict::proven;
}

/// The largest distance of a piece's points from one face. It is convex, so it is greatest at a corner.
double Prover::distance_from_one(const Corners& corners, Index face) const {
  const Corners other = surface_.corners(face);
  double most = 0;
  for (const Vec3& p : corners) most = std::max(most, distance_to(other, p));
  return most;
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
  const Vec3& from = c[longest];
  const Vec3& to = c[(longest + 1) % 3];
  const Vec3& opposite = c[(longest + 2) % 3];
  const Vec3 middle = 0.5 * (from + to);
  pieces_.push_back({{middle, to, opposite}, hint});
  pieces_.push_back({{from, middle, opposite}, hint});
}

}  // namespace whittle::metrics
