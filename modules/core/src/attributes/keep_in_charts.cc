#include "whittle/core/keep_in_charts.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "attributes/texture_atlas.hh"
#include "whittle/core/attribute_functions.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/image_triangle.hh"

namespace whittle {
namespace {

using detail::ImageTriangle;
using detail::TextureAtlas;
using detail::Vec2;

constexpr int most_tries = 12;                ///< of a face
constexpr std::array steps{0.01, 0.05, 0.2};  ///< of the way to the middle of the neighbours

/// Points of a face, on the sides of a triangle around its centroid.
struct Ring {
  double size;  ///< over the face's
  int points_a_side;
  bool is_inner;  ///< finds points in holes of a chart; else only sides at borders count, where a face sticks out
};
constexpr std::array rings{Ring{0.99, 16, false}, Ring{0.9, 8, false}, Ring{0.7, 4, true}, Ring{0.4, 2, true}};

class ChartKeeper {
 public:
  ChartKeeper(const MovedTexture& texture, const TextureAtlas& atlas, std::span<double> values)
      : texture_(texture), atlas_(atlas), values_(values) {
    const std::size_t n_wedges = values.size() / texture.n_components;
    find_charts(n_wedges);
    faces_at_ = detail::IndexLists<Index>(n_wedges, [&](const auto& emit) {
      for (Index f = 0; f < texture.faces.size(); ++f) {
        for (const Index w : texture.faces[f]) emit(w, f);
      }
    });
    border_sides_.resize(texture.faces.size());
    for (Index f = 0; f < texture.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        border_sides_[f][k] = is_border(texture.faces[f][k], texture.faces[f][(k + 1) % 3]);
      }
      const auto& [first, second, third] = border_sides_[f];
      if (first || second || third) at_border_.push_back(f);
    }
    border_faces_at_ = detail::IndexLists<Index>(n_wedges, [&](const auto& emit) {
      for (const Index f : at_border_) {
        for (const Index w : texture.faces[f]) emit(w, f);
      }
    });
  }

  std::size_t run() {
    find_shares();
    std::vector<Index> faces = those_over_others();
    for (int i = 0; i < most_tries && !faces.empty(); ++i) {
      bool is_any_moved = false;
      for (const Index f : faces) {
        if (shares_[f] > 0 && !is_stuck_[f]) is_any_moved |= draw_back(f);
      }
      if (!is_any_moved) break;
      faces = those_over_others();
    }
    return faces.size();
  }

 private:
  struct Move {
    Index wedge;
    Vec2 to;
    double length;
    double gain;     ///< of area over others, for its length
    bool is_enough;  ///< no face at the wedge lies over others then

    bool is_better_than(const Move& other) const {
      if (is_enough != other.is_enough) return is_enough;
      return is_enough ? length < other.length : gain > other.gain;
    }
  };

  /// A wedge comes from the chart of the first that became it, a face from that of two of its wedges.
  void find_charts(std::size_t n_wedges) {
    std::vector<Index> of_wedges(n_wedges, invalid_index);
    for (Index w = 0; w < texture_.wedge_map.size(); ++w) {
      const Index become = texture_.wedge_map[w];
      if (become != invalid_index && of_wedges[become] == invalid_index) of_wedges[become] = atlas_.chart_of(w);
    }
    for (const auto& [a, b, c] : texture_.faces) {
      charts_.push_back(of_wedges[b] == of_wedges[c] ? of_wedges[b] : of_wedges[a]);
    }
  }

  Vec2 at(Index w) const { return Vec2(&values_[w * texture_.n_components]); }
  void move(Index w, const Vec2& to) {
    values_[w * texture_.n_components] = to.x();
    values_[w * texture_.n_components + 1] = to.y();
  }

  ImageTriangle triangle(Index f) const {
    const auto& [a, b, c] = texture_.faces[f];
    return {at(a), at(b), at(c)};
  }
  double area(Index f) const {
    const auto& [a, b, c] = triangle(f);
    return detail::area_on_image(a, b, c);
  }
  /// The share of a face's points that lie over others, as they are now.
  double share_over_others(Index f) const {
    const ImageTriangle corners = triangle(f);
    const Vec2 centroid = (corners[0] + corners[1] + corners[2]) / 3;
    int n_points = 0;
    int n_over_others = 0;
    TextureAtlas::Near near;
    for (const auto& [size, points_a_side, is_inner] : rings) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_inner && !border_sides_[f][k]) continue;
        const Vec2 from = centroid + size * (corners[k] - centroid);
        const Vec2 side = size * (corners[(k + 1) % 3] - corners[k]);
        for (int i = 0; i < points_a_side; ++i) {
          n_over_others += atlas_.is_on_another(from + (i + 0.5) / points_a_side * side, charts_[f], near) ? 1 : 0;
        }
        n_points += points_a_side;
      }
    }
    return static_cast<double>(n_over_others) / n_points;
  }

  void find_shares() {
    shares_.resize(texture_.faces.size());
    is_stuck_.resize(texture_.faces.size());
    for_each_range(at_border_.size(), texture_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) shares_[at_border_[i]] = share_over_others(at_border_[i]);
    });
  }
  std::vector<Index> those_over_others() const {
    std::vector<Index> faces;
    std::copy_if(at_border_.begin(), at_border_.end(), std::back_inserter(faces),
                 [this](Index f) { return shares_[f] > 0; });
    return faces;
  }

  bool is_border(Index a, Index b) const {
    const auto has_b = [&](Index f) {
      const Triangle& face = texture_.faces[f];
      return face[0] == b || face[1] == b || face[2] == b;
    };
    const std::span<const Index> faces = faces_at_.of(a);
    return std::count_if(faces.begin(), faces.end(), has_b) == 1;
  }

  Vec2 middle_of_neighbours(Index w) const {
    Vec2 sum = Vec2::Zero();
    for (const Index f : faces_at_.of(w)) {
      for (const Index corner : texture_.faces[f]) sum += at(corner);
    }
    return sum / (3.0 * static_cast<double>(faces_at_.of(w).size()));
  }

  /// The area over others of the faces at w; 0 if there is none; `most` or more if it is so much.
  /// \param share_of a face
  template <class ShareOf>
  double area_over_others(Index w, double most, const ShareOf& share_of) const {
    double sum = 0;
    for (const Index f : border_faces_at_.of(w)) {
      sum += share_of(f) * std::abs(area(f));
      if (sum >= most) break;
    }
    return sum;
  }

  /// The shortest move of a wedge after which none of its faces lies over others; or else the one that gains most for
  /// its length. None turns a face over.
  std::optional<Move> best_move(Index w) {
    std::optional<Move> best;
    const Vec2 from = at(w);
    const Vec2 way = middle_of_neighbours(w) - from;
    constexpr double all = std::numeric_limits<double>::infinity();
    const double before = area_over_others(w, all, [this](Index f) { return shares_[f]; });
    std::vector<double> areas;
    for (const Index f : faces_at_.of(w)) areas.push_back(area(f));
    for (const double step : steps) {
      move(w, from + step * way);
      bool is_any_turned = false;
      for (std::size_t i = 0; i < areas.size(); ++i) is_any_turned |= area(faces_at_.of(w)[i]) * areas[i] < 0;
      if (is_any_turned) continue;
      const double length = step * way.norm();
      const double after = area_over_others(w, before, [this](Index f) { return share_over_others(f); });
      const Move found{w, at(w), length, (before - after) / length, after == 0};
      if (found.gain > 0 && (!best || found.is_better_than(*best))) best = found;
      if (found.is_enough) break;
    }
    move(w, from);
    return best;
  }

  /// \return whether a corner of the face has moved
  bool draw_back(Index f) {
    std::optional<Move> best;
    if (std::abs(area(f)) <= atlas_.area(charts_[f])) {
      for (const Index w : texture_.faces[f]) {
        const std::optional<Move> found = best_move(w);
        if (found && (!best || found->is_better_than(*best))) best = found;
      }
    }
    is_stuck_[f] = !best;
    if (best) make(*best);
    return best.has_value();
  }

  void make(const Move& best) {
    move(best.wedge, best.to);
    for (const Index f : border_faces_at_.of(best.wedge)) shares_[f] = share_over_others(f);
    for (const Index f : faces_at_.of(best.wedge)) {
      for (const Index w : texture_.faces[f]) {
        for (const Index near : border_faces_at_.of(w)) is_stuck_[near] = false;
      }
    }
  }

  const MovedTexture& texture_;
  const TextureAtlas& atlas_;
  std::span<double> values_;
  std::vector<Index> charts_;           ///< of each face
  detail::IndexLists<Index> faces_at_;  ///< of each wedge
  /// Per face, the sides that no other face has. Faces without such a side are inside their charts.
  std::vector<std::array<bool, 3>> border_sides_;
  std::vector<Index> at_border_;               ///< faces with such a side
  detail::IndexLists<Index> border_faces_at_;  ///< per wedge
  std::vector<double> shares_;                 ///< of each face's points that lie over others, if it is at a border
  std::vector<bool> is_stuck_;                 ///< per face: no move of a corner gains, as faces are around it
};

/// Per wedge of the original. Charts of one map are one, unless they have other images.
std::vector<Index> charts_on_image(const MovedTexture& texture) {
  const IndexedMesh& original = texture.original;
  std::vector<Index> charts = attribute_charts(original, texture.original_values, texture.n_components);
  if (texture.maps.empty()) return charts;
  std::vector<Index> become(charts.size(), invalid_index);
  std::map<std::pair<Index, Index>, Index> first;  // chart of a map and a group
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    const Index wedge = original.wedge(f, 0);
    const Index moved = texture.wedge_map[wedge];
    const Index map = moved == invalid_index ? invalid_index : texture.maps[moved];
    if (map == invalid_index || become[charts[wedge]] != invalid_index) continue;
    const Index group = original.face_groups.empty() ? 0 : original.face_groups[f];
    become[charts[wedge]] = first.try_emplace({map, group}, charts[wedge]).first->second;
  }
  for (Index& chart : charts) {
    if (become[chart] != invalid_index) chart = become[chart];
  }
  return charts;
}

bool are_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

std::size_t keep_in_charts(const MovedTexture& texture, std::span<double> values) {
  if (texture.original.faces.empty() || !are_finite(texture.original_values) || !are_finite(values)) return 0;
  const TextureAtlas atlas(texture.original, texture.original_values, texture.n_components, charts_on_image(texture));
  if (!atlas.has_several_charts()) return 0;
  return ChartKeeper(texture, atlas, values).run();
}

}  // namespace whittle
