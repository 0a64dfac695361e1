#include "guard/sharp_edge_guard.hh"

#include <algorithm>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {

SharpEdgeGuard::SharpEdgeGuard(TriangleComplex& complex, const Constraints& constraints, double angle_deg)
    : complex_(complex), constraints_(constraints), least_cosine_(detail::cosine_of_deg(angle_deg)) {}

bool SharpEdgeGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  const Pair& pair = profile.pair;
  list_faces(profile, position);
  seen_.clear();
  for (const Face& face : faces_) {
    for (const Index x : {face.x, face.y}) {
      if (std::find(seen_.begin(), seen_.end(), x) != seen_.end()) continue;
      seen_.push_back(x);
      if (would_change_edge(pair, x)) return true;
    }
    if (would_change_link(pair, face)) return true;
  }
  return false;
}

void SharpEdgeGuard::list_faces(const ContractionProfile& profile, const Vec3& position) {
  faces_.clear();
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto [x, y] = faces[i];
      faces_.push_back({x, y, reliable_normal(position, complex_.position(x), complex_.position(y))});
    }
  }
}

/// The edge from the merged vertex to x.
bool SharpEdgeGuard::would_change_edge(const Pair& pair, Index x) {
  const auto is_at_x = [x](const Face& face) { return face.x == x || face.y == x; };
  const auto n_faces = std::count_if(faces_.begin(), faces_.end(), is_at_x);
  if (n_faces > 2) return false;
  bool is_sharp_after = false;
  if (n_faces == 2) {
    const auto first = std::find_if(faces_.begin(), faces_.end(), is_at_x);
    const auto second = std::find_if(first + 1, faces_.end(), is_at_x);
    const bool is_same_way = (first->x == x) != (second->x == x);
    is_sharp_after = is_sharp(first->normal, is_same_way ? second->normal : Vec3(-second->normal));
  }
  const Edge from_a = look_at(pair.a, x);
  const Edge from_b = look_at(pair.b, x);
  const bool was_sharp = from_a.is_sharp || from_b.is_sharp;
  if (is_sharp_after == was_sharp) return false;
  const bool is_feature_after = is_feature(pair.a, x) || is_feature(pair.b, x);
  return is_sharp_after != is_feature_after;
}

/// The edge of the face opposite to the merged vertex.
bool SharpEdgeGuard::would_change_link(const Pair& pair, const Face& face) {
  const Edge before = look_at(face.x, face.y);
  if (!before.is_regular) return false;
  const auto is_beyond = [&](const Face& other) {
    const Index third = other.x == face.y ? other.y : other.x;
    return third != pair.a && third != pair.b;
  };
  const auto beyond = std::find_if(at_edge_.begin(), at_edge_.end(), is_beyond);
  if (beyond == at_edge_.end()) return false;
  const bool is_same_way = beyond->y == face.y;  // there from y to x, here from x to y
  const bool is_sharp_after = is_sharp(face.normal, is_same_way ? beyond->normal : Vec3(-beyond->normal));
  return is_sharp_after != before.is_sharp && is_sharp_after != is_feature(face.x, face.y);
}

/// Not if one of the faces has no area, and so no angle to the other.
bool SharpEdgeGuard::is_sharp(const Vec3& normal, const Vec3& other) const {
  return normal.dot(other) < least_cosine_ * normal.norm() * other.norm();
}

/// The edge as it is now; its faces as v has them, into `at_edge_`.
SharpEdgeGuard::Edge SharpEdgeGuard::look_at(Index v, Index w) {
  at_edge_.clear();
  const std::span<const Neighbour> pairs = complex_.live_pairs(v);
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    const Index x = pairs[i].vertex;
    const Index y = pairs[i + 1].vertex;
    if (x != w && y != w) continue;
    at_edge_.push_back({x, y, reliable_normal(complex_.position(v), complex_.position(x), complex_.position(y))});
  }
  if (at_edge_.size() != 2) return {};
  const bool is_same_way = (at_edge_[0].x == w) != (at_edge_[1].x == w);
  const Vec3& other = at_edge_[1].normal;
  return {true, is_sharp(at_edge_[0].normal, is_same_way ? other : Vec3(-other))};
}

bool SharpEdgeGuard::is_feature(Index v, Index w) {
  const std::span<const Neighbour> pairs = complex_.live_pairs(v);
  const auto neighbour = std::find_if(pairs.begin(), pairs.end(), [w](const Neighbour& s) { return s.vertex == w; });
  return neighbour != pairs.end() && constraints_.is_feature(complex_.live_edge(neighbour->edge));
}

}  // namespace whittle
