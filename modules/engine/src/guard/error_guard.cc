#include "guard/error_guard.hh"

#include <algorithm>

namespace whittle {
namespace {

/// Pieces of a face that are looked at before the contraction is refused.
constexpr int most_pieces_of_new_face = 256;

/// Faces that are looked at for points that lose their support, before the contraction is refused. Around vertices of
/// hundreds of edges, as fans have, an edge of the input may lie across all faces; elsewhere it takes some hundred.
constexpr std::size_t most_looks = 1 << 15;

/// Calls `use` with each vertex that is named once: an edge with one face leads to it.
template <class Use>
void for_each_border_end(std::vector<Index>& ends, const Use& use) {
  std::sort(ends.begin(), ends.end());
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end] == ends[begin]) ++end;
    if (end - begin == 1) use(ends[begin]);
  }
}

}  // namespace

ErrorGuard::ErrorGuard(TriangleComplex& complex, const ErrorBound& bound)
    : complex_(complex),
      bound_(bound),
      supports_(bound.points().size(), complex.n_vertex_slots()),
      prover_(bound.input(), most_pieces_of_new_face),
      places_(bound.points().size()),
      has_refused_(bound.points().size()) {
  const std::vector<Index> vertices = complex.vertices_by_origin();
  for (const auto& [point, face] : bound.supports()) {
    supports_.add(point, {vertices[face[0]], vertices[face[1]], vertices[face[2]]});
  }
}

/// What takes little time is looked at first.
bool ErrorGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  n_looks_left_ = most_looks;
  pair_ = profile.pair;
  position_ = position;
  faces_.clear();
  list_new_faces(profile);
  n_new_ = faces_.size();
  list_around(profile);
  list_affected();
  if (n_new_ > 0) {
    const NearFace near = bound_.input().nearest(position, last_);
    last_ = near.face;
    if (near.distance > bound_.limit()) return true;
  }
  return !are_affected_near() || !are_new_faces_near();
}

void ErrorGuard::list_new_faces(const ContractionProfile& profile) {
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < faces.size(); ++i) add_new(faces[i].x, faces[i].y);
  }
}

void ErrorGuard::list_faces_around() {
  for (const Index v : around_) {
    const std::span<const Neighbour> star = complex_.live_pairs(v);
    for (std::size_t i = 0; i < star.size(); i += 2) add_around({v, star[i].vertex, star[i + 1].vertex});
  }
}

void ErrorGuard::list_around(const ContractionProfile& profile) {
  around_.clear();
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (const Neighbour& neighbour : faces.neighbours()) around_.push_back(neighbour.vertex);
  }
  for (const ContractionProfile::Common& common : profile.merged_neighbours()) around_.push_back(common.vertex);
  std::sort(around_.begin(), around_.end());
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
}

bool ErrorGuard::is_at_pair(const Triangle& face) const {
  return std::any_of(face.begin(), face.end(), [this](Index v) { return v == pair_.a || v == pair_.b; });
}

void ErrorGuard::list_affected() {
  affected_.clear();
  ++n_looks_;
  const auto list = [this](Index v) {
    supports_.for_each_at(v, [this](Index point) {
      if (!is_at_pair(supports_.support(point))) return;
      places_[point] = {n_looks_, static_cast<Index>(affected_.size())};
      affected_.push_back(point);
    });
  };
  list(pair_.a);
  list(pair_.b);
  for (const Index v : around_) list(v);
}

/// Whether the points whose support changes have a new one, and the edges at them are near. Points that had none once
/// are looked at first: they are likely to have none again.
bool ErrorGuard::are_affected_near() {
  after_.clear();
  Index hint = 0;
  const auto is_supported = [&](Index point) {
    return find_support(bound_.points()[point], reach(bound_.limit_at(point)), hint);
  };
  for (const Index point : affected_) {
    if (has_refused_[point] != 0 && !is_supported(point)) return false;
  }
  for (const Index point : affected_) {
    if (!is_supported(point)) {
      has_refused_[point] = 1;
      return false;
    }
    after_.push_back(hint);
  }
  for (std::size_t i = 0; i < affected_.size(); ++i) {
    if (!are_edges_near(affected_[i], after_[i])) return false;
  }
  return true;
}

/// Of edges between two affected points, those at the lower one are looked at.
bool ErrorGuard::are_edges_near(Index point, Index support) {
  const std::span<const Vec3> points = bound_.points();
  for (const Index other : bound_.neighbours(point)) {
    const Place& place = places_[other];
    const bool is_affected = place.look == n_looks_;
    if (is_affected && (other < point || after_[place.place] == support)) continue;
    const Corners of_other = is_affected ? faces_[after_[place.place]].corners : corners(supports_.support(other));
    // The faces at the edge may be farther than either end: so the greater limit will do.
    const double limit = std::max(bound_.limit_at(point), bound_.limit_at(other));
    if (!is_near({{points[point], points[other]}, {faces_[support].corners, of_other}, reach(limit)}, 0)) return false;
  }
  return true;
}

/// The distance from a face is convex along the segment. So all of it is near if one point is near to both faces.
bool ErrorGuard::is_near(const Segment& segment, int depth) {
  constexpr int most_halvings = 20;  // a millionth is left: E may be a small share of the edge
  const auto& [ends, faces, reach] = segment;
  const Vec3 middle = 0.5 * (ends[0] + ends[1]);
  const bool is_near_first = is_within(faces[0], middle, reach);
  const bool is_near_second = is_within(faces[1], middle, reach);
  if (is_near_first && is_near_second) return true;
  if (is_within(faces[1], ends[0], reach) || is_within(faces[0], ends[1], reach)) return true;
  if (depth == most_halvings) return false;
  if (is_near_first) return is_near({{middle, ends[1]}, faces, reach}, depth + 1);
  if (is_near_second) return is_near({{ends[0], middle}, faces, reach}, depth + 1);
  Index support = 0;
  if (!find_support(middle, reach, support)) return false;
  const Corners between = faces_[support].corners;
  return is_near({{ends[0], middle}, {faces[0], between}, reach}, depth + 1) &&
         is_near({{middle, ends[1]}, {between, faces[1]}, reach}, depth + 1);
}

/// Finds a face that is near to the point, among the new ones and then those around them. \param hint tried first
bool ErrorGuard::find_support(const Vec3& point, double reach, Index& hint) {
  if (find_support_in_list(point, reach, hint)) return true;
  if (faces_.size() > n_new_) return false;
  list_faces_around();
  return find_support_in_list(point, reach, hint);
}

bool ErrorGuard::find_support_in_list(const Vec3& point, double reach, Index& hint) {
  if (hint < faces_.size() && is_within(faces_[hint].corners, point, reach)) return true;
  const std::size_t n_looks = std::min(n_looks_left_, faces_.size());
  for (Index face = 0; face < n_looks; ++face) {
    --n_looks_left_;
    const auto& [vertices, corners, box] = faces_[face];
    const bool is_beside = ((point - box.max()).array() > reach).any() || ((box.min() - point).array() > reach).any();
    if (is_beside || !is_within(corners, point, reach)) continue;
    hint = face;
    return true;
  }
  return false;
}

bool ErrorGuard::are_new_faces_near() {
  return std::all_of(faces_.begin(), faces_.begin() + static_cast<std::ptrdiff_t>(n_new_),
                     [this](const FaceAfter& face) {
                       FarthestPoint farthest;
                       return prover_.prove(face.corners, bound_.limit(), last_, farthest) == Verdict::proven;
                     });
}

/// \pre `refuses_at` was false for this contraction, and not asked since
void ErrorGuard::note(const Change& change) {
  const auto remove_at = [this](Index v) {
    supports_.remove_at(v, [this](Index point) { return is_at_pair(supports_.support(point)); });
  };
  remove_at(pair_.a);
  remove_at(pair_.b);
  for (const Index v : around_) remove_at(v);
  for (std::size_t i = 0; i < affected_.size(); ++i) {
    Triangle face = faces_[after_[i]].vertices;
    if (face[0] == invalid_index) face[0] = change.survivor;
    supports_.add(affected_[i], face);
  }
}

void BorderErrorGuard::list_new_faces(const ContractionProfile& profile) {
  ends_.clear();
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < faces.size(); ++i) ends_.insert(ends_.end(), {faces[i].x, faces[i].y});
  }
  for_each_border_end(ends_, [this](Index v) { add_new(v, v); });
}

void BorderErrorGuard::list_faces_around() {
  for (const Index v : around()) {
    ends_.clear();
    for (const Neighbour& neighbour : complex().live_pairs(v)) ends_.push_back(neighbour.vertex);
    for_each_border_end(ends_, [this, v](Index w) { add_around({v, w, w}); });
  }
}

}  // namespace whittle
