#include "rounds/merged_star.hh"

#include <algorithm>
#include <limits>

#include "complex/link_condition.hh"
#include "rounds/lane_points.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {

bool MergedStar::gather(const VertexPair& pair, std::array<bool, 2> is_irregular) {
  const auto [a, b] = pair;
  const std::span<const LinkEdge> first = mesh_.star(a);
  const std::span<const LinkEdge> second = mesh_.star(b);
  pair_ = pair;
  if (others_.size() < first.size() + second.size() + n_lanes<Double4>) {
    others_.resize(2 * (first.size() + second.size() + n_lanes<Double4>));
  }
  if (++n_looks_ == 0) {  // all numbers are used up
    std::fill(marks_.begin(), marks_.end(), 0);
    ++n_looks_;
  }
  n_opposite_ = 0;
  std::size_t n = 0;
  for (Index slot = 0; slot < first.size(); ++slot) {
    const LinkEdge& listed = first[slot];
    const Index x = mesh_.now(listed.x);
    const Index y = mesh_.now(listed.y);
    if (x == y) continue;
    marks_[x] = marks_[y] = n_looks_;
    if (x == b) {
      note_vanishing(slot, y, 1);
    } else if (y == b) {
      note_vanishing(slot, x, -1);
    } else {
      others_[n++] = {x, y};
    }
  }
  n_first_ = n;
  const std::size_t n_common_faces = n_opposite_;
  std::size_t n_common_neighbours = 0;
  const auto look_for = [&](Index v) {
    n_common_neighbours += static_cast<std::size_t>(marks_[v] == n_looks_);
    marks_[v] = 0;
  };
  for (const LinkEdge& listed : second) {
    const Index x = mesh_.now(listed.x);
    const Index y = mesh_.now(listed.y);
    if (x == y) continue;
    look_for(x);
    look_for(y);
    if (x != a && y != a) others_[n++] = {x, y};
  }
  n_ = n;
  for (std::size_t i = n; i < n + n_lanes<Double4> && n > 0; ++i) others_[i] = others_[n - 1];  // for lanes
  if (is_irregular[0] || is_irregular[1]) return keeps_topology(is_irregular);
  // With one face each beside the common ones, both would lie over the same edge: a tetrahedron.
  return n_common_faces == 2 && n_common_neighbours == 2 && (n_first_ > 1 || n - n_first_ > 1);
}

/// \pre one of the two vertices is irregular
bool MergedStar::keeps_topology(std::array<bool, 2> is_irregular) {
  if (!link_) link_.emplace(mesh_.n_vertices());
  std::array<VertexKind, 2> kinds{VertexKind::regular, VertexKind::regular};
  for (std::size_t end = 0; end < 2 && is_irregular[0] && is_irregular[1]; ++end) {
    link_->gather(gather_faces(end));
    kinds[end] = link_->kind();
  }
  return link_condition(*link_, {others_at(0), others_at(1), opposites(), kinds});
}

/// The faces of one star of the pair, as they are now.
std::span<const LinkEdge> MergedStar::gather_faces(std::size_t end) {
  const auto [a, b] = pair_;
  const std::span<const LinkEdge> others = others_at(end);
  const std::size_t n = others.size() + n_opposite_;
  make_room(all_, n);
  LinkEdge* next = std::copy(others.begin(), others.end(), all_.data());
  const Index other = end == 0 ? b : a;
  for (std::size_t i = 0; i < n_opposite_; ++i) {
    const bool is_other_first = (turns_[i] > 0) == (end == 0);
    *next++ = is_other_first ? LinkEdge{other, opposites_[i]} : LinkEdge{opposites_[i], other};
  }
  return std::span(all_).first(n);
}

StarPlanes MergedStar::planes(std::size_t end, const QuadricOptions& options) {
  return planes_of_star(end == 0 ? pair_.a : pair_.b, gather_faces(end), mesh_.points(), options);
}

StarVolume MergedStar::volume(const StarPlanes& a, const StarPlanes& b, const Vec3& origin) const {
  const Vec3 first = Vec3(mesh_.point(pair_.a)) - origin;
  const Vec3 second = Vec3(mesh_.point(pair_.b)) - origin;
  StarVolume volume{a.normal() + b.normal(), a.normal().dot(first) + b.normal().dot(second), a.length() + b.length(),
                    farthest_sq(origin)};
  for (std::size_t i = 0; i < n_opposite_; ++i) {  // both stars have the common faces
    const Vec3 arm = Vec3(mesh_.point(opposites_[i])) - origin - first;
    const Vec3 normal = turns_[i] * (second - first).cross(arm);
    volume.normal -= normal;
    volume.offset -= normal.dot(first);
    volume.length -= normal.norm();
  }
  return volume;
}

/// What is done with four faces at a time.
struct MergedStar::Kernels {
  const MergedStar& star;

  WHITTLE_INLINE PointLanes<Double4> next(std::size_t i) const {
    const LinkEdge* const four = &star.others_[i];
    return lane_points(star.mesh_.points().data(),
                       [four](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].x; });
  }
  WHITTLE_INLINE PointLanes<Double4> previous(std::size_t i) const {
    const LinkEdge* const four = &star.others_[i];
    return lane_points(star.mesh_.points().data(),
                       [four](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].y; });
  }

  WHITTLE_INLINE bool exceeds(const FlipLimit& limit, const Vec3& position) const {
    const PointLanes<Double4> to = everywhere(LanePoint(position));
    const PointLanes<Double4> a = everywhere(star.mesh_.point(star.pair_.a));
    const PointLanes<Double4> b = everywhere(star.mesh_.point(star.pair_.b));
    const std::size_t end_of_first = star.n_first_ < star.n_ ? star.n_first_ : star.n_ + n_lanes<Double4>;
    for (std::size_t i = 0; i < star.n_; i += n_lanes<Double4>) {
      const Double4 place = Double4{0, 1, 2, 3} + static_cast<double>(i);
      const auto is_first = place < static_cast<double>(end_of_first);
      const PointLanes<Double4> from{select_lanes(is_first, a.x, b.x), select_lanes(is_first, a.y, b.y),
                                     select_lanes(is_first, a.z, b.z)};
      if (limit.is_exceeded(from, to, next(i), previous(i))) return true;
    }
    return false;
  }
  WHITTLE_AVX2 bool exceeds_in_wide_registers(const FlipLimit& limit, const Vec3& position) const {
    return exceeds(limit, position);
  }

  WHITTLE_INLINE double farthest_sq(const Vec3& from) const {
    const PointLanes<Double4> origin = everywhere(LanePoint(from));
    Double4 farthest{};
    for (std::size_t i = 0; i < star.n_; i += n_lanes<Double4>) {
      const PointLanes<Double4> arm = next(i) - origin;
      const Double4 distance = arm.dot(arm);
      farthest = select_lanes(distance > farthest, distance, farthest);
    }
    return std::max(std::max(farthest[0], farthest[1]), std::max(farthest[2], farthest[3]));
  }
  WHITTLE_AVX2 double farthest_sq_in_wide_registers(const Vec3& from) const { return farthest_sq(from); }
};

bool MergedStar::exceeds(const FlipLimit& limit, const Vec3& position) {
  const Kernels kernels{*this};
  return has_double4 ? kernels.exceeds_in_wide_registers(limit, position) : kernels.exceeds(limit, position);
}

double MergedStar::farthest_sq(const Vec3& from) const {
  const Kernels kernels{*this};
  return has_double4 ? kernels.farthest_sq_in_wide_registers(from) : kernels.farthest_sq(from);
}

double MergedStar::turn_sq(const Vec3& position) const {
  double longest_sq = 0;
  double least_cosine_sq = 1;
  for (std::size_t i = 0; i < n_; ++i) {
    const Vec3 from = mesh_.point(apex(i));
    const Vec3 x = mesh_.point(others_[i].x);
    const Vec3 y = mesh_.point(others_[i].y);
    longest_sq = std::max({longest_sq, (x - position).squaredNorm(), (y - position).squaredNorm()});
    const Vec3 before = reliable_normal(from, x, y);
    const Vec3 after = reliable_normal(position, x, y);
    const double lengths_sq = before.squaredNorm() * after.squaredNorm();
    const double cosine = std::max(0.0, before.dot(after));
    if (lengths_sq > 0) least_cosine_sq = std::min(least_cosine_sq, cosine * cosine / lengths_sq);
  }
  return longest_sq * (1 - least_cosine_sq);
}

double MergedStar::displacement_sq(const Vec3& position) const {
  struct Nearest {
    Vec3 point;
    double distance_sq = std::numeric_limits<double>::infinity();
    void look_at(const Vec3& a, const Vec3& b, const Vec3& c) {
      distance_sq = std::min(distance_sq, distance_sq_to_triangle(a - point, b - point, c - point));
    }
  };
  const Vec3 a = mesh_.point(pair_.a);
  const Vec3 b = mesh_.point(pair_.b);
  Nearest from_first{a};
  Nearest from_second{b};
  Nearest from_apex{position};
  for (std::size_t i = 0; i < n_; ++i) {
    const Vec3 x = mesh_.point(others_[i].x);
    const Vec3 y = mesh_.point(others_[i].y);
    from_first.look_at(position, x, y);
    from_second.look_at(position, x, y);
    from_apex.look_at(i < n_first_ ? a : b, x, y);
  }
  for (const Index v : opposites()) from_apex.look_at(a, b, mesh_.point(v));
  return std::max({from_first.distance_sq, from_second.distance_sq, from_apex.distance_sq});
}

}  // namespace whittle
