#include "guard/error_guard.hh"

#include <algorithm>

#include "guard/border_motion.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle {
namespace {

/// Faces that are looked at for points that lose their support, before the contraction is refused. Around vertices of
/// hundreds of edges, as fans have, an edge of the input may lie across all faces; elsewhere it takes some hundred.
constexpr std::size_t most_looks = 1 << 15;

void add_border_edges(std::vector<Index>& ends, std::vector<LinkEdge>& edges) {
  for_each_border_end(ends, [&edges](Index v) { edges.push_back({v, v}); });
}

}  // namespace

ErrorGuard::ErrorGuard(TriangleComplex& complex, const ErrorBound& bound)
    : complex_(complex),
      bound_(bound),
      supports_(bound.points().size(), complex.n_vertex_slots()),
      places_(bound.points().size()),
      has_refused_(bound.points().size()) {
  const std::vector<Index> vertices = complex.vertices_by_origin();
  for (const auto& [point, face] : bound.supports()) {
    supports_.add(point, {vertices[face[0]], vertices[face[1]], vertices[face[2]]});
  }
}

void ErrorGuard::begin(const ContractionProfile& profile, ErrorLook& look) {
  look.number_ = ++n_looks_;
  look.pair_ = profile.pair;
  look.new_faces_.clear();
  list_new_faces(profile, look.new_faces_);
  list_around(profile, look.around_);
}

void ErrorGuard::list_affected(ErrorLook& look) {
  look.affected_.clear();
  const auto list = [&](Index v) {
    supports_.for_each_at(v, [&](Index point) {
      if (!is_at(look.pair_, supports_.support(point))) return;
      places_[point] = {look.number_, static_cast<Index>(look.affected_.size())};
      look.affected_.push_back(point);
    });
  };
  list(look.pair_.a);
  list(look.pair_.b);
  for (const Index v : look.around_) list(v);
}

/// What takes little time is looked at first.
bool ErrorGuard::accepts(const Vec3& position, ErrorLook& look) {
  look.n_looks_left_ = most_looks;
  look.position_ = position;
  look.faces_.clear();
  for (const auto& [x, y] : look.new_faces_) {
    look.faces_.push_back({{invalid_index, x, y}, NearTest({position, complex_.position(x), complex_.position(y)})});
  }
  look.nearest_ = {};
  if (!look.new_faces_.empty()) {
    const Index hint = look.affected_.empty() ? invalid_index : bound_.face_at(look.affected_.front());
    look.nearest_ = bound_.input().nearest(position, hint);
    if (look.nearest_.distance > bound_.limit()) return false;
  }
  return are_affected_near(look) && are_new_faces_near(look);
}

std::vector<Vec3> ErrorGuard::nearer_positions(const ErrorLook& look) const {
  constexpr std::array<double, 4> shares_of_limit{0.9, 0.7, 0.5, 0.3};
  std::vector<Vec3> positions;
  const auto [face, distance] = look.nearest_;
  if (face == invalid_index) return positions;
  const LinkedFaces input = bound_.input().faces();
  const auto& [a, b, c] = input.corners(face);
  const Vec3& from = look.position_;
  const Vec3 nearest = point_at({a, b, c}, nearest_on_triangle(a - from, b - from, c - from));
  for (const double share : shares_of_limit) {
    const double wanted = share * bound_.limit() - input.offset(face);
    if (wanted > 0 && wanted < (from - nearest).norm()) {
      positions.emplace_back(nearest + wanted * (from - nearest).normalized());
    }
  }
  return positions;
}

/// Others may have changed the supports at the other ends of edges.
bool ErrorGuard::still_accepts(ErrorLook& look, const ErrorLook& first) const {
  for (std::size_t i = 0; i < look.affected_.size(); ++i) {
    const Index point = look.affected_[i];
    for (const Index other : bound_.neighbours(point)) {
      const std::uint32_t by = places_[other].look;
      if (by != look.number_ && by >= first.number_ && !is_edge_near(look, point, look.after_[i], other)) return false;
    }
  }
  return true;
}

void ErrorGuard::list_new_faces(const ContractionProfile& profile, Faces& faces) const {
  for (const StarFaces& star : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < star.size(); ++i) faces.push_back(star[i]);
  }
}

void ErrorGuard::list_faces_of(std::span<const Neighbour> star, Faces& faces) const {
  for (std::size_t i = 0; i < star.size(); i += 2) faces.push_back({star[i].vertex, star[i + 1].vertex});
}

/// Adds what is at the merged vertex' neighbours and isn't new.
void ErrorGuard::list_faces_around(ErrorLook& look) const {
  for (const Index v : look.around_) {
    complex_.list_live_pairs(v, look.star_);
    look.at_star_.clear();
    list_faces_of(look.star_, look.at_star_);
    for (const auto& [x, y] : look.at_star_) {
      const Triangle face{v, x, y};
      if (!is_at(look.pair_, face)) look.faces_.push_back({face, NearTest(corners(face))});
    }
  }
}

void ErrorGuard::list_around(const ContractionProfile& profile, std::vector<Index>& around) {
  around.clear();
  profile.for_each_neighbour([&](Index v) { around.push_back(v); });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
}

/// Whether the points whose support changes have a new one, and the edges at them are near. Points that had none once
/// are looked at first: they are likely to have none again.
bool ErrorGuard::are_affected_near(ErrorLook& look) {
  look.after_.clear();
  Index hint = 0;
  const auto is_supported = [&](Index point) {
    return find_support(look, bound_.points()[point], reach(bound_.limit_at(point)), hint);
  };
  for (const Index point : look.affected_) {
    if (has_refused_[point] != 0 && !is_supported(point)) return false;
  }
  for (const Index point : look.affected_) {
    if (!is_supported(point)) {
      has_refused_[point] = 1;
      return false;
    }
    look.after_.push_back(hint);
  }
  for (std::size_t i = 0; i < look.affected_.size(); ++i) {
    if (!are_edges_near(look, look.affected_[i], look.after_[i])) return false;
  }
  return true;
}

/// Of edges between two affected points, those at the lower one are looked at.
bool ErrorGuard::are_edges_near(ErrorLook& look, Index point, Index support) const {
  for (const Index other : bound_.neighbours(point)) {
    const Place& place = places_[other];
    const bool is_affected = place.look == look.number_;
    if (is_affected && (other < point || look.after_[place.place] == support)) continue;
    if (!is_edge_near(look, point, support, other)) return false;
  }
  return true;
}

/// \param support of the point, a face of the look
bool ErrorGuard::is_edge_near(ErrorLook& look, Index point, Index support, Index other) const {
  const Place& place = places_[other];
  const bool is_affected = place.look == look.number_;
  const NearTest of_other = is_affected ? look.faces_[look.after_[place.place]].near
                                        : NearTest::of_corners(corners(supports_.support(other)));
  // The faces at the edge may be farther than either end: so the greater limit will do.
  const double limit = std::max(bound_.limit_at(point), bound_.limit_at(other));
  const NearTest& of_point = look.faces_[support].near;
  const std::array<Vec3, 2> ends{bound_.points()[point], bound_.points()[other]};
  const Vec3 crossing = of_point.last_over(ends[0], ends[1]);  // mostly over an edge of both faces
  if (of_other.is_within(crossing, reach(limit)) && of_point.is_within(crossing, reach(limit))) return true;
  return is_near(look, {ends, {of_point, of_other}, reach(limit)}, 0);
}

/// The distance from a face is convex along the segment. So all of it is near if one point is near to both faces.
bool ErrorGuard::is_near(ErrorLook& look, const Segment& segment, int depth) const {
  constexpr int most_halvings = 20;  // a millionth is left: E may be a small share of the edge
  const auto& [ends, faces, reach] = segment;
  const Vec3 middle = 0.5 * (ends[0] + ends[1]);
  const bool is_near_first = faces[0].is_within(middle, reach);
  const bool is_near_second = faces[1].is_within(middle, reach);
  if (is_near_first && is_near_second) return true;
  if (faces[1].is_within(ends[0], reach) || faces[0].is_within(ends[1], reach)) return true;
  if (depth == most_halvings) return false;
  if (is_near_first) return is_near(look, {{middle, ends[1]}, faces, reach}, depth + 1);
  if (is_near_second) return is_near(look, {{ends[0], middle}, faces, reach}, depth + 1);
  Index support = 0;
  if (!find_support(look, middle, reach, support)) return false;
  const NearTest between = look.faces_[support].near;
  return is_near(look, {{ends[0], middle}, {faces[0], between}, reach}, depth + 1) &&
         is_near(look, {{middle, ends[1]}, {between, faces[1]}, reach}, depth + 1);
}

/// Finds a face that is near to the point, among the new ones and then those around them. \param hint tried first
bool ErrorGuard::find_support(ErrorLook& look, const Vec3& point, double reach, Index& hint) const {
  if (find_support_in_list(look, point, reach, hint)) return true;
  if (look.faces_.size() > look.new_faces_.size()) return false;
  list_faces_around(look);
  return find_support_in_list(look, point, reach, hint);
}

bool ErrorGuard::find_support_in_list(ErrorLook& look, const Vec3& point, double reach, Index& hint) {
  if (hint < look.faces_.size() && look.faces_[hint].near.is_within(point, reach)) return true;
  const std::size_t n_looks = std::min(look.n_looks_left_, look.faces_.size());
  for (Index face = 0; face < n_looks; ++face) {
    --look.n_looks_left_;
    if (!look.faces_[face].near.is_within(point, reach)) continue;
    hint = face;
    return true;
  }
  return false;
}

bool ErrorGuard::are_new_faces_near(ErrorLook& look) const {
  return std::all_of(look.new_faces_.begin(), look.new_faces_.end(), [&](const LinkEdge& face) {
    FarthestPoint farthest;
    const Corners corners{look.position_, complex_.position(face.x), complex_.position(face.y)};
    return look.prover_.prove(corners, bound_.limit(), look.nearest_.face, farthest) == Verdict::proven;
  });
}

void ErrorGuard::note(const Change& change, const ErrorLook& look) {
  const auto remove_at = [&](Index v) {
    supports_.remove_at(v, [&](Index point) { return is_at(look.pair_, supports_.support(point)); });
  };
  remove_at(look.pair_.a);
  remove_at(look.pair_.b);
  for (const Index v : look.around_) remove_at(v);
  for (std::size_t i = 0; i < look.affected_.size(); ++i) {
    Triangle face = look.faces_[look.after_[i]].vertices;
    if (face[0] == invalid_index) face[0] = change.survivor;
    supports_.add(look.affected_[i], face);
  }
}

void BorderErrorGuard::list_new_faces(const ContractionProfile& profile, Faces& faces) const {
  std::vector<Index> ends;
  for (const StarFaces& star : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < star.size(); ++i) ends.insert(ends.end(), {star[i].x, star[i].y});
  }
  add_border_edges(ends, faces);
}

void BorderErrorGuard::list_faces_of(std::span<const Neighbour> star, Faces& faces) const {
  std::vector<Index> ends;
  for (const Neighbour& neighbour : star) ends.push_back(neighbour.vertex);
  add_border_edges(ends, faces);
}

}  // namespace whittle
