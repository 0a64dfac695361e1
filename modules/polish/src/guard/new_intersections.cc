#include "guard/new_intersections.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "whittle/core/geometry/overlapping_boxes.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/geometry/triangle_intersection.hh"

namespace whittle::polishing {
namespace {

class MovedMesh {
 public:
  MovedMesh(const Surface& before, const FaceLimits& limits, std::vector<Vec3>& positions,
            const detail::Workers& workers)
      : before_(before), limits_(limits), positions_(positions), is_fresh_(before.faces.size(), 1) {
    find_near_pairs(workers);
    does_intersect_.resize(pairs_.size());
    is_crossed_.resize(positions.size());
  }

  /// Faces that newly intersect another face. Pairs without a corner put back since the last call are not checked
  /// again.
  std::vector<Index> intersecting(const detail::Workers& workers) {
    for_each_range(pairs_.size(), workers, [this](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto& [f, g] = pairs_[i];
        does_intersect_[i] = (is_fresh_[f] != 0 || is_fresh_[g] != 0) && intersect_newly(f, g);
      }
    });
    for_each_range(is_crossed_.size(), workers, [this](std::size_t begin, std::size_t end) {
      for (auto v = static_cast<Index>(begin); v < end; ++v) {
        is_crossed_[v] = has_fresh_face(v) && !is_flat(v) && !intersecting_at(v).empty();
      }
    });
    std::vector<Index> faces;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (does_intersect_[i] != 0) faces.insert(faces.end(), pairs_[i].begin(), pairs_[i].end());
    }
    for (Index v = 0; v < is_crossed_.size(); ++v) {
      if (is_crossed_[v] == 0) continue;
      const std::vector<Index> found = intersecting_at(v);
      faces.insert(faces.end(), found.begin(), found.end());
    }
    std::fill(is_fresh_.begin(), is_fresh_.end(), std::uint8_t{0});
    return faces;
  }

  /// The faces that turned too far or are too thin, and neighbours with a forbidden angle to them.
  std::vector<Index> spoiled(std::span<const Index> faces) const {
    std::vector<Index> found;
    for (const Index f : faces) {
      if (is_turned(f) || is_thinned(f)) found.push_back(f);
      for (Index slot = 0; slot < 3; ++slot) {
        if (turns_to_neighbor(f, slot)) found.insert(found.end(), {f, limits_.beyond(f, slot)});
      }
    }
    return found;
  }

  /// Moves the corners of these faces back. \return the corners that had moved
  std::vector<Index> take_back(std::span<const Index> faces) {
    std::vector<Index> vertices;
    for (const Index f : faces) {
      for (const Index v : before_.faces[f]) {
        if (!is_moved(v)) continue;
        positions_[v] = before_.positions[v];
        vertices.push_back(v);
        for (const Corner& corner : before_.corners.of(v)) is_fresh_[corner.face] = 1;
      }
    }
    return vertices;
  }

  std::vector<Index> faces_at(std::span<const Index> vertices) const {
    std::vector<Index> faces;
    for (const Index v : vertices) {
      for (const Corner& corner : before_.corners.of(v)) faces.push_back(corner.face);
    }
    return faces;
  }

 private:
  /// Faces without a common corner that may intersect, wherever each corner is: where it was, or where it is now.
  void find_near_pairs(const detail::Workers& workers) {
    std::vector<FloatBox> boxes(before_.faces.size());
    for_each_range(boxes.size(), workers, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        const Corners was = corners_of(before_.positions, before_.faces[f]);
        boxes[f] = box_of(was).merged(box_of(corners_of(positions_, before_.faces[f]))).cast<float>();
      }
    });
    const auto are_apart = [this](Index f, Index g) {
      return n_common_corners(before_.faces[f], before_.faces[g]) == 0;
    };
    pairs_ = overlapping_boxes(boxes, are_apart, workers);
  }

  bool is_moved(Index v) const { return positions_[v] != before_.positions[v]; }

  bool intersect_newly(Index f, Index g) const {
    const auto both = [&](std::span<const Vec3> at) {
      return std::array{corners_of(at, before_.faces[f]), corners_of(at, before_.faces[g])};
    };
    return detail::intersect_newly(both(before_.positions), both(positions_));
  }

  bool has_fresh_face(Index v) const {
    const std::span<const Corner> corners = before_.corners.of(v);
    return std::any_of(corners.begin(), corners.end(), [this](const Corner& c) { return is_fresh_[c.face] != 0; });
  }

  /// Faces at v that newly intersect another face at v, without a common edge.
  std::vector<Index> intersecting_at(Index v) const {
    const std::span<const Corner> corners = before_.corners.of(v);
    std::vector<Index> faces;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const Index f = corners[i].face;
        const Index g = corners[j].face;
        if (n_common_corners(before_.faces[f], before_.faces[g]) == 1 && intersect_newly(f, g))
          faces.insert(faces.end(), {f, g});
      }
    }
    return faces;
  }

  /// Whether the faces at v, seen from one direction, go once around v and none is turned over. Then no two of them
  /// intersect. This holds at most vertices, and is checked faster than all pairs of faces.
  bool is_flat(Index v) const {
    const std::span<const Corner> corners = before_.corners.of(v);
    if (corners.empty()) return false;
    Vec3 up = Vec3::Zero();
    for (const Corner& corner : corners) up += normal(corner.face, positions_);
    const auto end = [&](const Corner& corner, Index n) {
      return corner_after(before_.faces[corner.face], corner.slot, n);
    };
    const Vec3& center = positions_[v];
    const Vec3 way = up.cross(positions_[end(corners[0], 1)] - center);
    int n_along_way = 0;
    bool is_turned_over = false;
    // Sums over the first ends minus the last ends, and over their squares: zero if the ring is closed.
    std::uint64_t sum = 0;
    std::uint64_t sum_of_squares = 0;
    for (const Corner& corner : corners) {
      const std::uint64_t first = end(corner, 1);
      const std::uint64_t last = end(corner, 2);
      const Vec3 to_first = positions_[first] - center;
      const Vec3 to_last = positions_[last] - center;
      is_turned_over |= !(up.dot(to_first.cross(to_last)) > 0);
      n_along_way += static_cast<int>(way.dot(to_first) <= 0 && way.dot(to_last) > 0);
      sum += first - last;
      sum_of_squares += first * first - last * last;
    }
    return !is_turned_over && n_along_way == 1 && sum == 0 && sum_of_squares == 0;
  }

  Vec3 normal(Index face, std::span<const Vec3> positions) const { return area_normal(positions, before_.faces[face]); }

  bool is_turned(Index face) const {
    return cosine(normal(face, positions_), normal(face, before_.positions)) < least_turn_cosine;
  }
  bool is_thinned(Index face) const {
    const auto& [a, b, c] = before_.faces[face];
    const auto ratio = [&, a = a, b = b, c = c](std::span<const Vec3> at) { return radius_ratio(at[a], at[b], at[c]); };
    return limits_.forbid_thinning(ratio(before_.positions), ratio(positions_));
  }
  bool turns_to_neighbor(Index face, Index slot) const {
    return limits_.forbid(face, slot, [this](Index f, bool is_now) {
      return normal(f, is_now ? std::span<const Vec3>(positions_) : before_.positions);
    });
  }

  const Surface& before_;
  const FaceLimits& limits_;
  std::vector<Vec3>& positions_;
  IndexPairs pairs_;                          ///< near each other, without a common corner
  std::vector<std::uint8_t> is_fresh_;        ///< per face, whether a corner has moved since the last check
  std::vector<std::uint8_t> does_intersect_;  ///< scratch: per pair
  std::vector<std::uint8_t> is_crossed_;      ///< scratch: per vertex
};

}  // namespace

void take_back_intersections(const Surface& before, const FaceLimits& limits, std::vector<Vec3>& positions,
                             std::span<const Index> taken_back, const detail::Workers& workers) {
  MovedMesh mesh(before, limits, positions, workers);
  std::vector<Index> changed = mesh.faces_at(taken_back);
  for (;;) {
    std::vector<Index> wrong = mesh.spoiled(changed);
    const std::vector<Index> intersecting = mesh.intersecting(workers);
    wrong.insert(wrong.end(), intersecting.begin(), intersecting.end());
    if (wrong.empty()) return;
    changed = mesh.faces_at(mesh.take_back(wrong));
  }
}

}  // namespace whittle::polishing
