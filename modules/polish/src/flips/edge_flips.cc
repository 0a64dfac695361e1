#include "flips/edge_flips.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "whittle/core/geometry/overlapping_boxes.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/geometry/triangle_intersection.hh"

namespace whittle::polishing {
namespace {

/// Largest share of the squared distances that may be left after a flip. Smaller gains are noise of a few points.
constexpr double most_left = 0.95;

/// Root mean square distance below which faces already fit, in lengths of the edge.
constexpr double least_rms = 1e-5;

constexpr std::size_t least_valence = 4;
constexpr std::size_t most_valence = 9;

using Faces = std::array<Triangle, 2>;

/// The flip of an edge, which is named by one of its two sides.
struct Flip {
  Index face, slot;
  double gain;  ///< by which it lowers the sum of squared distances
};

class EdgeFlips {
 public:
  EdgeFlips(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits, const MeshLines& lines,
            const FlipLimits& flip_limits, const Origins& origins)
      : mesh_(mesh),
        neighbors_(neighbors),
        limits_(limits),
        lines_(lines),
        flip_limits_(flip_limits),
        origins_(origins),
        faces_(mesh.faces.begin(), mesh.faces.end()),
        partner_(mesh.faces.size(), invalid_index),
        valences_(mesh.corners.size()) {
    for (Index v = 0; v < valences_.size(); ++v) valences_[v] = mesh.corners.of(v).size();
    if (!flip_limits.keeps_shape) return;
    for (Index v = 0; v < valences_.size(); ++v) regular_.push_back(neighbors.fan(v) == Fan::open ? 3 : 6);
  }

  /// Profitable flips, largest gain first.
  std::vector<Flip> find(const detail::Workers& workers) {
    const std::vector<FaceFit> fits = fit(workers);
    std::vector<std::array<double, 3>> gains(faces_.size(), {0, 0, 0});
    for_each_range(faces_.size(), workers, [&](std::size_t begin, std::size_t end) {
      for (auto f = static_cast<Index>(begin); f < end; ++f) {
        for (Index slot = 0; slot < 3; ++slot) {
          if (fits[f].tents[slot].height == 0) continue;
          const auto [other, other_slot] = neighbors_.beyond(f, slot);
          if (other < f) continue;
          const double now = fits[f].squares + fits[other].squares;
          const double gain = fits[f].gains[slot] + fits[other].gains[other_slot];
          if (gain < (1 - most_left) * now || now < least_squares(f, slot)) continue;
          if (turns_little(f, slot) && !makes_thin(f, slot)) gains[f][slot] = gain;
        }
      }
    });
    std::vector<Flip> flips;
    for (Index f = 0; f < faces_.size(); ++f) {
      for (Index slot = 0; slot < 3; ++slot) {
        if (gains[f][slot] > 0) flips.push_back({f, slot, gains[f][slot]});
      }
    }
    std::stable_sort(flips.begin(), flips.end(), [](const Flip& a, const Flip& b) { return a.gain > b.gain; });
    return flips;
  }

  /// Makes the flips in turn, if the flips before them still allow it.
  void make(const std::vector<Flip>& flips) {
    std::set<VertexPair> made;
    for (const auto& [f, slot, gain] : flips) {
      const Index other = neighbors_.beyond(f, slot).face;
      const auto [u, v, a, b] = corners_of(f, slot);
      if (touches_a_flip(f) || touches_a_flip(other) || !keeps_valences(u, v, a, b)) continue;
      if (!made.insert({std::min(a, b), std::max(a, b)}).second) continue;
      const Faces flipped = faces_after(f, slot);
      faces_[f] = flipped[0];
      faces_[other] = flipped[1];
      partner_[f] = other;
      partner_[other] = f;
      --valences_[u], --valences_[v];
      ++valences_[a], ++valences_[b];
    }
  }

  /// Undoes flips until no flipped face intersects another.
  void undo_intersecting(const detail::Workers& workers) {
    std::vector<FloatBox> boxes;
    boxes.reserve(faces_.size());
    for (Index f = 0; f < faces_.size(); ++f) {
      const Box after = box_of(whittle::corners_of(mesh_.positions, faces_[f]));
      boxes.push_back(after.merged(box_of(whittle::corners_of(mesh_.positions, mesh_.faces[f]))).cast<float>());
    }
    const IndexPairs pairs = overlapping_boxes(
        boxes, [](Index, Index) { return true; }, workers);
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (const auto& [f, g] : pairs) {
        if ((!is_flipped(f) && !is_flipped(g)) || !do_intersect(f, g)) continue;
        undo(f);
        undo(g);
        is_done = false;
      }
    }
  }

  std::vector<Triangle> take_faces() { return std::move(faces_); }

 private:
  /// The space between two faces and their flip, seen from one of the two faces. It is highest where the old and the
  /// new edge are nearest to each other, and zero at the four corners.
  struct Tent {
    double share = 0;   ///< where the tip is on the old edge, 0 … 1
    double height = 0;  ///< of the new edge over the face there; 0 if the edge can't be flipped
  };
  /// How well a face fits its points, and how well it would after a flip of each side.
  struct FitSums {
    double squares = 0;             ///< sum of the points' squared distances
    std::array<double, 3> gains{};  ///< by which a flip would lower it

    FitSums& operator+=(const FitSums& other) {
      squares += other.squares;
      for (std::size_t slot = 0; slot < 3; ++slot) gains[slot] += other.gains[slot];
      return *this;
    }
  };
  struct FaceFit : FitSums {
    std::array<Tent, 3> tents;
  };

  bool is_flipped(Index f) const { return partner_[f] != invalid_index; }

  /// Sum of squared distances below which an edge fits well enough.
  double least_squares(Index f, Index slot) const {
    double weight = 0;
    for (const Index g : {f, neighbors_.beyond(f, slot).face}) weight += 0.5 * normal(mesh_.faces[g]).norm();
    const Vec3 way = mesh_.positions[corner_after(mesh_.faces[f], slot, 1)] - mesh_.positions[mesh_.faces[f][slot]];
    return weight * least_rms * least_rms * way.squaredNorm();
  }
  std::vector<FaceFit> fit(const detail::Workers& workers) const {
    std::vector<FaceFit> fits(faces_.size());
    for_each_range(faces_.size(), workers, [&](std::size_t begin, std::size_t end) {
      for (auto f = static_cast<Index>(begin); f < end; ++f) {
        for (Index slot = 0; slot < 3; ++slot) {
          if (neighbors_.beyond(f, slot).face != invalid_index && keeps_surface(f, slot))
            fits[f].tents[slot] = tent(f, slot);
        }
      }
    });
    const auto add_point = [&fits](FitSums& sums, const ClosestFacePoint& closest, double weight) {
      add(sums, fits[closest.face].tents, closest, weight);
    };
    sum_over_closest_points<FitSums>(
        origins_, mesh_, add_point, [&fits](Index f) -> FitSums& { return fits[f]; }, workers);
    return fits;
  }

  Tent tent(Index f, Index slot) const {
    const auto [u, v, a, b] = corners_of(f, slot);
    const Vec3 edge = mesh_.positions[v] - mesh_.positions[u];
    const Vec3 other_edge = mesh_.positions[b] - mesh_.positions[a];
    const Vec3 between = mesh_.positions[a] - mesh_.positions[u];
    // Where the two edges are nearest to each other. \cite ericson_2005_collision (section 5.1.9)
    const double e = edge.squaredNorm();
    const double o = other_edge.squaredNorm();
    const double eo = edge.dot(other_edge);
    const double determinant = e * o - eo * eo;
    const double share = (o * edge.dot(between) - eo * other_edge.dot(between)) / determinant;
    const double other_share = (eo * edge.dot(between) - e * other_edge.dot(between)) / determinant;
    const auto is_inside = [](double x) { return x > 0 && x < 1; };
    if (!is_inside(share) || !is_inside(other_share)) return {};
    const Vec3 up = normal(mesh_.faces[f]);
    return {share, up.dot(other_share * other_edge) / up.norm()};
  }

  /// A flip lowers a point's distance by the tent's height at its closest point.
  static void add(FitSums& sums, const std::array<Tent, 3>& tents, const ClosestFacePoint& closest, double weight) {
    const std::array<double, 3> at{1.0 - closest.second - closest.third, closest.second, closest.third};
    sums.squares += weight * closest.distance * closest.distance;
    for (std::size_t slot = 0; slot < 3; ++slot) {
      const auto& [share, height] = tents[slot];
      if (height == 0) continue;
      const double x = height * std::max(0.0, std::min(at[slot] / (1 - share), at[(slot + 1) % 3] / share));
      sums.gains[slot] += weight * x * (2 * closest.distance - x);
    }
  }

  /// The ends of an edge in the order of the face, then the third corner of the face and of its neighbour.
  std::array<Index, 4> corners_of(Index f, Index slot) const {
    const auto [other, other_slot] = neighbors_.beyond(f, slot);
    return {mesh_.faces[f][slot], corner_after(mesh_.faces[f], slot, 1), corner_after(mesh_.faces[f], slot, 2),
            corner_after(mesh_.faces[other], other_slot, 2)};
  }
  Faces faces_after(Index f, Index slot) const {
    const auto [u, v, a, b] = corners_of(f, slot);
    return {Triangle{a, u, b}, Triangle{b, v, a}};
  }

  bool keeps_surface(Index f, Index slot) const {
    const auto [u, v, a, b] = corners_of(f, slot);
    const Index other = neighbors_.beyond(f, slot).face;
    if (neighbors_.is_twisted(f, slot) || is_on_line(u, v)) return false;
    const std::span<const Index> regions = flip_limits_.regions;
    if (!regions.empty() && regions[f] != regions[other]) return false;
    return a != b && keeps_valences(u, v, a, b) && !is_edge(a, b);
  }
  bool is_on_line(Index u, Index v) const {
    if (lines_.empty()) return false;
    const std::span<const Index> edges = lines_.at(u);
    return std::any_of(edges.begin(), edges.end(),
                       [&](Index e) { return lines_.edges()[e].from == v || lines_.edges()[e].to == v; });
  }
  bool is_edge(Index a, Index b) const {
    const std::span<const Corner> corners = mesh_.corners.of(a);
    return std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
      const Triangle& face = mesh_.faces[corner.face];
      return face[0] == b || face[1] == b || face[2] == b;
    });
  }
  bool keeps_valences(Index u, Index v, Index a, Index b) const {
    if (!(std::min(valences_[u], valences_[v]) > least_valence &&
          std::max(valences_[a], valences_[b]) < most_valence)) {
      return false;
    }
    if (!flip_limits_.keeps_shape) return true;
    return change_at(u, -1) + change_at(v, -1) + change_at(a, 1) + change_at(b, 1) <= 0;
  }
  /// Change of a vertex' irregularity with one face more or less. One face more or less than regular costs nothing.
  int change_at(Index v, int more) const {
    const auto irregularity = [this, v](int n_faces) { return std::max(0, std::abs(n_faces - regular_[v]) - 1); };
    const auto now = static_cast<int>(valences_[v]);
    return irregularity(now + more) - irregularity(now);
  }

  Vec3 normal(const Triangle& face) const { return area_normal(mesh_.positions, face); }
  bool makes_thin(Index f, Index slot) const {
    const auto ratios = [this](const Faces& faces) {
      const auto ratio = [this](const Triangle& face) {
        return radius_ratio(mesh_.positions[face[0]], mesh_.positions[face[1]], mesh_.positions[face[2]]);
      };
      return std::array{ratio(faces[0]), ratio(faces[1])};
    };
    const auto before = ratios({mesh_.faces[f], mesh_.faces[neighbors_.beyond(f, slot).face]});
    const auto after = ratios(faces_after(f, slot));
    if (flip_limits_.keeps_shape && after[0] + after[1] < before[0] + before[1]) return true;
    return limits_.forbid_thinning(std::min(before[0], before[1]), std::min(after[0], after[1]));
  }
  bool turns_little(Index f, Index slot) const {
    const Index other = neighbors_.beyond(f, slot).face;
    const Faces after = faces_after(f, slot);
    const std::array<Vec3, 2> normals{normal(after[0]), normal(after[1])};
    const Vec3 sum = normal(mesh_.faces[f]) + normal(mesh_.faces[other]);
    for (const Vec3& n : normals) {
      if (!(cosine(n, sum) > least_turn_cosine)) return false;
    }
    if (!(cosine(normals[0], normals[1]) > limits_.least_cosine())) return false;
    // The four outer sides: from v to a, from a to u, from u to b, and from b to v.
    const auto [g, g_slot] = neighbors_.beyond(f, slot);
    return is_allowed_beside(f, (slot + 2) % 3, normals[0]) && is_allowed_beside(f, (slot + 1) % 3, normals[1]) &&
           is_allowed_beside(g, (g_slot + 1) % 3, normals[0]) && is_allowed_beside(g, (g_slot + 2) % 3, normals[1]);
  }
  /// Whether a side may have the angle that it would have if the face had another normal.
  bool is_allowed_beside(Index f, Index slot, const Vec3& normal_after) const {
    return !limits_.forbid(
        f, slot, [&](Index g, bool is_after) { return g == f && is_after ? normal_after : normal(mesh_.faces[g]); });
  }

  bool touches_a_flip(Index f) const {
    if (is_flipped(f)) return true;
    for (Index slot = 0; slot < 3; ++slot) {
      const Index other = neighbors_.beyond(f, slot).face;
      if (other != invalid_index && is_flipped(other)) return true;
    }
    return false;
  }

  bool do_intersect(Index f, Index g) const {
    return n_common_corners(faces_[f], faces_[g]) < 2 && detail::intersect(faces_[f], faces_[g], mesh_.positions);
  }
  void undo(Index f) {
    if (!is_flipped(f)) return;
    const Index other = partner_[f];
    for (const Index g : {f, other}) {
      faces_[g] = mesh_.faces[g];
      partner_[g] = invalid_index;
    }
  }

  const Surface& mesh_;
  const FaceNeighbors& neighbors_;
  const FaceLimits& limits_;
  const MeshLines& lines_;
  FlipLimits flip_limits_;
  const Origins& origins_;
  std::vector<Triangle> faces_;
  std::vector<Index> partner_;  ///< per face, the face it was flipped with, or `invalid_index`
  std::vector<std::size_t> valences_;
  std::vector<int> regular_;  ///< per vertex, its regular number of faces; empty if shape isn't kept
};

}  // namespace

std::vector<Triangle> flip_edges(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits,
                                 const MeshLines& lines, const FlipLimits& flip_limits, const Origins& origins,
                                 const detail::Workers& workers) {
  EdgeFlips flips(mesh, neighbors, limits, lines, flip_limits, origins);
  flips.make(flips.find(workers));
  flips.undo_intersecting(workers);
  return flips.take_faces();
}

}  // namespace whittle::polishing
