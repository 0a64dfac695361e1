#include "guard/intersection_guard.hh"

#include <algorithm>

#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle_intersection.hh"

namespace whittle {

bool IntersectionGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  list_faces(profile, position);
  if (do_cross_each_other()) return true;
  FloatBox all;
  for (const Face& face : faces_) all.extend(face.box);
  bool is_refused = false;
  boxes_.visit(all, [&](Index v) {
    is_refused = cross_faces_at(v, profile.pair);
    return !is_refused;
  });
  return is_refused;
}

void IntersectionGuard::note(const Change& change) {
  around_.assign({change.survivor, change.removed});
  for (const Neighbour& neighbour : complex_.live_pairs(change.survivor)) around_.push_back(neighbour.vertex);
  std::sort(around_.begin(), around_.end());
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  for (const Index v : around_) boxes_.update(v);
}

void IntersectionGuard::list_faces(const ContractionProfile& profile, const Vec3& position) {
  faces_.clear();
  const auto add = [&](const StarFaces& faces, Index v) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto [x, y] = faces[i];
      const Vec3& p = complex_.position(x);
      const Vec3& q = complex_.position(y);
      faces_.push_back({x, y, {complex_.position(v), p, q}, {position, p, q}, {}});
      faces_.back().box = box_of(faces_.back().then).cast<float>();
    }
  };
  add(profile.first, profile.pair.a);
  add(profile.second, profile.pair.b);
}

/// Whether two faces at the merged vertex, without another common corner, would newly intersect.
bool IntersectionGuard::do_cross_each_other() const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Face& f = faces_[i];
      const Face& g = faces_[j];
      if (f.x == g.x || f.x == g.y || f.y == g.x || f.y == g.y) continue;
      if (detail::intersect_newly({f.now, g.now}, {f.then, g.then})) return true;
    }
  }
  return false;
}

/// Whether a face at the merged vertex would newly intersect one of v's own faces.
bool IntersectionGuard::cross_faces_at(Index v, const Pair& pair) {
  if (v == pair.a || v == pair.b) return false;
  crossed_.clear();
  const std::span<const Neighbour> star = complex_.live_pairs(v);
  for (std::size_t i = 0; i < star.size(); i += 2) {
    const Index p = star[i].vertex;
    const Index q = star[i + 1].vertex;
    const bool is_in_star = p == pair.a || p == pair.b || q == pair.a || q == pair.b;
    if (is_in_star || p < v || q < v) continue;
    const Corners other{complex_.position(v), complex_.position(p), complex_.position(q)};
    const FloatBox box = box_of(other).cast<float>();
    const auto is_corner = [&](Index w) { return w == v || w == p || w == q; };
    const bool is_crossed = std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
      return face.box.intersects(box) && !(is_corner(face.x) && is_corner(face.y)) &&
             detail::intersect(face.then, other);
    });
    if (is_crossed) crossed_.push_back({{v, p, q}, other});
  }
  return std::any_of(crossed_.begin(), crossed_.end(),
                     [&](const Crossed& other) { return !is_crossed_already(pair, other); });
}

/// Whether some face at the pair, without a common edge, intersects this face now.
bool IntersectionGuard::is_crossed_already(const Pair& pair, const Crossed& face) {
  for (const Index v : {pair.a, pair.b}) {
    const std::span<const Neighbour> star = complex_.live_pairs(v);
    for (std::size_t i = 0; i < star.size(); i += 2) {
      const Triangle own{v, star[i].vertex, star[i + 1].vertex};
      if (n_common_corners(own, face.face) > 1) continue;
      if (detail::intersect({complex_.position(own[0]), complex_.position(own[1]), complex_.position(own[2])},
                            face.corners))
        return true;
    }
  }
  return false;
}

}  // namespace whittle
