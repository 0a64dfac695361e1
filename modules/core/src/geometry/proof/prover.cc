#include "whittle/core/geometry/proof/prover.hh"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {
namespace {

/// Distances are found to this accuracy where they are smaller: lengths are about 1.
constexpr double least_accuracy = 1e-9;

/// Factor on the accuracy of distances, repeatedly, if a search takes too many pieces.
constexpr double coarsening = 4;

}  // namespace

Verdict Prover::prove(const Corners& triangle, double distance, Index hint, FarthestPoint& farthest) {
  const auto limit = [distance](const FarthestPoint&) { return distance; };
  const auto decide = [distance](const FarthestPoint& point) {
    if (point.distance > distance + distance_slack) return Verdict::refuted;
    return point.distance > distance - 3 * distance_slack ? Verdict::undecided : Verdict::proven;
  };
  begin(triangle, hint, distance);
  return search(limit, decide, farthest);
}

double Prover::find_farthest(const Corners& triangle, double from, double accuracy, double most, Index hint,
                             FarthestPoint& farthest) {
  double coarseness = 1;
  const double of_interest = std::isfinite(most) ? most : 0;
  const auto limit = [&](const FarthestPoint& point) {
    const double found = std::max(from, point.distance);
    const double gap = accuracy * std::max(found, of_interest) + least_accuracy;
    const double sought = std::max(coarse_, found + coarseness * gap);
    return found < most - 4 * distance_slack ? std::min(sought, std::max(coarse_, most)) : sought;
  };
  const auto decide = [](const FarthestPoint&) { return Verdict::proven; };
  begin(triangle, hint, limit(farthest));
  while (search(limit, decide, farthest) == Verdict::undecided) {
    if (limit(farthest) == most) most = std::numeric_limits<double>::infinity();
    coarseness *= coarsening;
  }
  if (coarseness > 1) coarse_ = limit(farthest);
  return limit(farthest);
}

/// Without a hint it begins at the face found last, if that is near.
void Prover::begin(const Corners& triangle, Index hint, double distance) {
  surface_ = target_.faces();
  steps_.clear();
  faces_.clear();
  if (hint == invalid_index) {
    const bool is_last_near = last_ != invalid_index &&
                              distance_to(surface_.corners(last_), triangle[0]) + surface_.offset(last_) <= distance;
    hint = is_last_near ? last_ : target_.nearest(triangle[0], last_).face;
  }
  pieces_.assign(1, {triangle, hint});
}

/// Proves the remaining pieces, or replaces them by their halves.
/// \param limit `limit(farthest)` is the distance to prove for a piece
/// \param decide `decide(farthest)` ends the search if it isn't `proven`
template <class Limit, class Decide>
Verdict Prover::search(const Limit& limit, const Decide& decide, FarthestPoint& farthest) {
  for (int n_pieces = 0; !pieces_.empty(); ++n_pieces) {
    if (n_pieces >= most_pieces_) return Verdict::undecided;
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (is_proven(piece, limit(farthest))) continue;
    list_known(piece.hint);
    const Vec3 suspect = this->suspect(piece.corners);
    const NearFace known = search_near(suspect, nearest_known(suspect), limit(farthest));
    if (known.face != piece.hint) known_.push_back(known.face);
    if (known.distance > limit(farthest) - 4 * distance_slack) {
      const NearFace near = target_.nearest(suspect, known.face);
      if (near.distance > farthest.distance) farthest = {suspect, near.distance};
      const Verdict verdict = decide(farthest);
      if (verdict != Verdict::proven) return verdict;
      if (near.face != known.face) {
        known_.push_back(near.face);
        if (is_proven({piece.corners, near.face}, limit(farthest))) continue;
      }
    }
    split(piece);
  }
  return Verdict::proven;
}

/// Whether a piece is proven to be near to one face, or to the faces around it. If so, that is a step of the proof.
bool Prover::is_proven(const Piece& piece, double distance) {
  if (is_near(piece.corners, piece.hint, distance)) return true;
  last_ = patch_.look_from(surface_, piece.corners, piece.hint);
  if (last_ == invalid_index) {
    last_ = piece.hint;
    return false;
  }
  if (last_ != piece.hint && is_near(piece.corners, last_, distance)) return true;
  if (piece.obstacle != invalid_index) {
    if (is_near(piece.corners, piece.obstacle, distance)) return true;
    if (patch_.is_obstacle(piece.obstacle, distance)) return false;
  }
  if (!patch_.covers(distance)) return false;
  steps_.push_back({ProofStep::Kind::patch, last_});
  faces_.insert(faces_.end(), patch_.faces_over().begin(), patch_.faces_over().end());
  return true;
}

bool Prover::is_near(const Corners& corners, Index face, double distance) {
  const Corners other = surface_.corners(face);
  const double most = distance - surface_.offset(face) - distance_slack;
  if (!std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) { return distance_to(other, p) <= most; })) {
    return false;
  }
  steps_.push_back({ProofStep::Kind::face, face});
  faces_.push_back(face);
  return true;
}

/// Lists the faces that a piece was compared with.
void Prover::list_known(Index hint) {
  known_.assign(1, hint);
  if (last_ != hint) known_.push_back(last_);
  if (patch_.obstacle()) known_.push_back(patch_.obstacle()->face);
}

NearFace Prover::nearest_known(const Vec3& point) const {
  NearFace nearest{invalid_index, std::numeric_limits<double>::infinity()};
  for (const Index face : known_) {
    const double distance = distance_to(surface_.corners(face), point) + surface_.offset(face);
    if (distance < nearest.distance) nearest = {face, distance};
  }
  return nearest;
}

/// Searches from face to face, over edges, for one that is within the distance of a point, beyond the nearest faces
/// first. It ends at a face within the distance that no face around is nearer than.
NearFace Prover::search_near(const Vec3& point, NearFace from, double distance) {
  constexpr int most_steps = 64;
  const auto is_farther = [](const NearFace& one, const NearFace& other) { return one.distance > other.distance; };
  searched_.clear();
  searched_.insert(from.face);
  to_search_.assign(1, from);
  NearFace nearest = from;
  for (int step = 0; step < most_steps && !to_search_.empty(); ++step) {
    std::pop_heap(to_search_.begin(), to_search_.end(), is_farther);
    const Index at = to_search_.back().face;
    to_search_.pop_back();
    if (at != nearest.face && nearest.distance <= distance - 4 * distance_slack) break;
    for (const Index face : surface_.beyond[at]) {
      if (face == invalid_index || !searched_.insert(face)) continue;
      to_search_.push_back({face, distance_to(surface_.corners(face), point) + surface_.offset(face)});
      if (to_search_.back().distance < nearest.distance) nearest = to_search_.back();
      std::push_heap(to_search_.begin(), to_search_.end(), is_farther);
    }
  }
  return nearest;
}

/// That of the corners, and of the point where faces were too high, which is farthest from the faces known.
Vec3 Prover::suspect(const Corners& corners) const {
  FarthestPoint farthest;
  const auto consider = [&](const Vec3& point) {
    const double distance = nearest_known(point).distance;
    if (distance > farthest.distance) farthest = {point, distance};
  };
  for (const Vec3& corner : corners) consider(corner);
  if (patch_.obstacle()) consider(patch_.obstacle()->below);
  return farthest.point;
}

/// Halves the longest edge.
void Prover::split(const Piece& piece) {
  const Corners& c = piece.corners;
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
  const bool is_segment = to == opposite;
  // The face may hinder a half only because it is connected with the other one: so a half of a half is looked at anew.
  const bool was_obstacle = piece.obstacle != invalid_index;
  const Index obstacle = patch_.obstacle() && !was_obstacle ? patch_.obstacle()->face : invalid_index;
  for (const Corners& half : {Corners{middle, to, opposite}, Corners{from, middle, is_segment ? middle : opposite}}) {
    pieces_.push_back({half, nearest_known((half[0] + half[1] + half[2]) / 3).face, obstacle});
  }
}

}  // namespace whittle
