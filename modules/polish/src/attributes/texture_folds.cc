#include "attributes/texture_folds.hh"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/geometry/segment.hh"

namespace whittle::polishing {
namespace {

using detail::Vec2;

constexpr double least_majority = 0.8;  ///< of the votes for a way round
/// Heights of an unfolded face over the edge that stays: first tried, and finally accepted.
constexpr std::array least_heights{0.01, 0.0};
constexpr int sweeps_a_height = 15;
/// Sweeps for the remaining faces: each vertex around moves to where its worst face is folded least.
/// \cite freitag_2000_untangling
constexpr int relaxing_sweeps = 50;
constexpr double flat = 1e-6;  ///< the height below which a face counts as flat, over its longest edge

/// The points x where normal · x ≥ least.
struct HalfPlane {
  Vec2 normal;
  double least;
};

/// A convex polygon, clipped in place.
class Polygon {
 public:
  explicit Polygon(const Eigen::AlignedBox2d& box)
      : corners_{box.corner(box.BottomLeft), box.corner(box.BottomRight), box.corner(box.TopRight),
                 box.corner(box.TopLeft)} {}

  bool is_empty() const { return corners_.empty(); }

  void clip(const HalfPlane& half) {
    clipped_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2& from = corners_[i];
      const Vec2& to = corners_[(i + 1) % corners_.size()];
      const double in_from = half.normal.dot(from) - half.least;
      const double in_to = half.normal.dot(to) - half.least;
      if (in_from >= 0) clipped_.push_back(from);
      if ((in_from < 0) != (in_to < 0)) clipped_.push_back(from + in_from / (in_from - in_to) * (to - from));
    }
    corners_.swap(clipped_);
  }

  /// \pre not empty, and the point lies outside
  Vec2 nearest_to(const Vec2& point) const {
    Vec2 best = corners_.front();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2& from = corners_[i];
      const Vec2& to = corners_[(i + 1) % corners_.size()];
      const Vec2 candidate = from + nearest_share(point, from, to) * (to - from);
      if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
    }
    return best;
  }

 private:
  std::vector<Vec2> corners_;
  std::vector<Vec2> clipped_;
};

class Unfolder {
 public:
  Unfolder(std::span<const Triangle> faces, std::span<const std::int8_t> turns, std::span<double> texcoords,
           std::size_t n_components, std::span<const std::uint8_t> held)
      : faces_(faces), turns_(turns), texcoords_(texcoords), n_components_(n_components), held_(held) {
    faces_at_ = detail::IndexLists<Index>(texcoords.size() / n_components, [&faces](const auto& emit) {
      for (Index f = 0; f < faces.size(); ++f) {
        for (const Index w : faces[f]) emit(w, f);
      }
    });
  }

  std::size_t run() {
    std::vector<Index> folded = folded_faces();
    for (const double least_height : least_heights) {
      for (int sweep = 0; sweep < sweeps_a_height && !folded.empty(); ++sweep) {
        for (const Index f : folded) unfold(f, least_height);
        folded = folded_faces();
      }
    }
    for (int sweep = 0; sweep < relaxing_sweeps && !folded.empty(); ++sweep) {
      for (const Index w : around(folded)) relax(w);
      folded = folded_faces();
    }
    return folded.size();
  }

 private:
  Vec2 at(Index w) const { return {texcoords_[w * n_components_], texcoords_[w * n_components_ + 1]}; }
  void move(Index w, const Vec2& to) {
    texcoords_[w * n_components_] = to.x();
    texcoords_[w * n_components_ + 1] = to.y();
  }

  bool is_folded(Index f) const {
    const auto& [a, b, c] = faces_[f];
    const double longest_sq =
        std::max({(at(a) - at(b)).squaredNorm(), (at(b) - at(c)).squaredNorm(), (at(c) - at(a)).squaredNorm()});
    return turns_[f] * detail::area_on_image(at(a), at(b), at(c)) < -flat * longest_sq;
  }

  std::vector<Index> folded_faces() const {
    std::vector<Index> folded;
    for (Index f = 0; f < faces_.size(); ++f) {
      if (turns_[f] != 0 && is_folded(f)) folded.push_back(f);
    }
    return folded;
  }

  /// The other corners of a face, in its order.
  std::array<Index, 2> others(Index f, Index w) const {
    const auto& [a, b, c] = faces_[f];
    if (w == a) return {b, c};
    return w == b ? std::array{c, a} : std::array{a, b};
  }

  /// Where w may go so that none of its faces is folded, as near as can be to where it is.
  std::optional<Vec2> place(Index w, double least_height) const {
    if (!held_.empty() && held_[w] != 0) return std::nullopt;
    Eigen::AlignedBox2d box(at(w));
    for (const Index f : faces_at_.of(w)) {
      for (const Index other : others(f, w)) box.extend(at(other));
    }
    Polygon polygon(box);
    for (const Index f : faces_at_.of(w)) {
      if (turns_[f] == 0) continue;
      const auto [x, y] = others(f, w);
      const Vec2 edge = at(y) - at(x);
      const Vec2 inward = turns_[f] * Vec2(-edge.y(), edge.x());
      polygon.clip({inward, inward.dot(at(x)) + least_height * edge.squaredNorm()});
      if (polygon.is_empty()) return std::nullopt;
    }
    return polygon.nearest_to(at(w));
  }

  /// Moves the corner that has the shortest way.
  void unfold(Index f, double least_height) {
    if (!is_folded(f)) return;
    double shortest_sq = std::numeric_limits<double>::infinity();
    std::optional<std::pair<Index, Vec2>> best;
    for (const Index w : faces_[f]) {
      const std::optional<Vec2> to = place(w, least_height);
      if (!to || !((*to - at(w)).squaredNorm() < shortest_sq)) continue;
      shortest_sq = (*to - at(w)).squaredNorm();
      best = {w, *to};
    }
    if (best) move(best->first, best->second);
  }

  /// The corners of faces and of their neighbours, ascending.
  std::vector<Index> around(std::span<const Index> faces) const {
    std::vector<Index> wedges;
    for (const Index f : faces) {
      for (const Index w : faces_[f]) {
        for (const Index neighbour : faces_at_.of(w))
          wedges.insert(wedges.end(), faces_[neighbour].begin(), faces_[neighbour].end());
      }
    }
    std::sort(wedges.begin(), wedges.end());
    wedges.erase(std::unique(wedges.begin(), wedges.end()), wedges.end());
    return wedges;
  }

  /// The least height of the faces at w, over the edges that stay; negative if one is folded.
  double least_height_at(Index w) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Index f : faces_at_.of(w)) {
      const auto [x, y] = others(f, w);
      const double length_sq = (at(y) - at(x)).squaredNorm();
      if (turns_[f] == 0 || !(length_sq > 0)) continue;
      least = std::min(least, turns_[f] * detail::area_on_image(at(x), at(y), at(w)) / length_sq);
    }
    return least;
  }

  /// Where no place unfolds all faces at w: moves it where the worst is folded least.
  void relax(Index w) {
    double low = least_height_at(w);
    if (!(low < 0)) return;
    std::optional<Vec2> best;
    double high = least_heights[0];
    for (int step = 0; step < 20; ++step) {
      const double middle = 0.5 * (low + high);
      const std::optional<Vec2> to = place(w, middle);
      (to ? low : high) = middle;
      if (to) best = to;
    }
    if (best) move(w, *best);
  }

  std::span<const Triangle> faces_;
  std::span<const std::int8_t> turns_;
  std::span<double> texcoords_;
  std::size_t n_components_;
  std::span<const std::uint8_t> held_;
  detail::IndexLists<Index> faces_at_;  ///< of each wedge
};

}  // namespace

std::vector<std::int8_t> turns_on_image(const TexturedFaces& original,
                                        std::span<const AttributeSamples::Sample> samples, std::size_t n_faces) {
  const auto at = [&](Index w) { return Vec2(original.texcoords.data() + w * original.n_components); };
  std::vector<double> votes(n_faces);
  std::vector<double> all(n_faces);
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    const auto& [closest, weight, wedge] = samples[f];
    if (closest.face == invalid_index || !(weight > 0)) continue;
    const auto& [a, b, c] = original.faces[f];
    const double area = detail::area_on_image(at(a), at(b), at(c));
    votes[closest.face] += area > 0 ? weight : area < 0 ? -weight : 0;
    all[closest.face] += weight;
  }
  std::vector<std::int8_t> turns(n_faces);
  for (std::size_t f = 0; f < n_faces; ++f) {
    if (std::abs(votes[f]) > (2 * least_majority - 1) * all[f]) turns[f] = votes[f] > 0 ? 1 : -1;
  }
  return turns;
}

std::size_t unfold(std::span<const Triangle> faces, std::span<const std::int8_t> turns, std::span<double> texcoords,
                   std::size_t n_components, std::span<const std::uint8_t> held) {
  return Unfolder(faces, turns, texcoords, n_components, held).run();
}

}  // namespace whittle::polishing
