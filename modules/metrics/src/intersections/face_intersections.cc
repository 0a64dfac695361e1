// `overlapping_boxes` finds candidates: pairs of faces with overlapping boxes. A candidate is decided by the signs of
// orientation determinants alone, so the result is exact. Two faces intersect if they have
//
//   no common corner:     and an edge of one meets the other; two triangles have no other way to meet
//   one common corner:    and the edge opposite to it, of either face, meets the other face; the intersection is convex
//                         and contains the corner
//   two common corners:   and both are in one plane, on the same side of the common edge
//   three common corners
#include "intersections/face_intersections.hh"

#include <algorithm>
#include <utility>

#include "intersections/predicates.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/overlapping_boxes.hh"
#include "whittle/core/geometry/space_filling_curve.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

constexpr std::array<std::pair<int, int>, 3> coordinate_planes{{{0, 1}, {1, 2}, {2, 0}}};

/// How the corners turn in the first coordinate plane in which they are not on a line. `turn` is 0 if there is none.
struct Projection {
  int x = 0, y = 1, turn = 0;

  explicit Projection(const Corners& t) {
    for (const auto& [px, py] : coordinate_planes) {
      turn = orient2d(t[0], t[1], t[2], px, py);
      x = px, y = py;
      if (turn != 0) return;
    }
  }
};

/// Whether a closed segment and a closed triangle in one plane have a common point. They have none if a line along a
/// side of either one separates them strictly.
bool meet_in_plane(const Vec3& from, const Vec3& to, const Corners& t) {
  const Projection plane(t);
  const auto turn = [&](const Vec3& a, const Vec3& b, const Vec3& c) { return orient2d(a, b, c, plane.x, plane.y); };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    if (turn(a, b, from) * plane.turn < 0 && turn(a, b, to) * plane.turn < 0) return false;
  }
  const int s0 = turn(from, to, t[0]), s1 = turn(from, to, t[1]), s2 = turn(from, to, t[2]);
  return !(s0 * s1 > 0 && s1 * s2 > 0);
}

/// Whether a closed segment and a closed triangle have a common point.
bool meet(const Vec3& from, const Vec3& to, const Corners& t) {
  const int from_side = orient3d(t[0], t[1], t[2], from), to_side = orient3d(t[0], t[1], t[2], to);
  if (from_side * to_side > 0) return false;
  if (from_side == 0 && to_side == 0) return meet_in_plane(from, to, t);
  const int s0 = orient3d(from, to, t[0], t[1]), s1 = orient3d(from, to, t[1], t[2]),
            s2 = orient3d(from, to, t[2], t[0]);
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

/// The corners of a face, rotated so that corner `first` comes first.
Corners turned(const Corners& t, std::size_t first) { return {t[first], t[(first + 1) % 3], t[(first + 2) % 3]}; }

bool meet_apart(const Corners& s, const Corners& t) {
  const auto all_on_one_side = [](const Corners& plane, const Corners& points) {
    const int side = orient3d(plane[0], plane[1], plane[2], points[0]);
    return side != 0 && orient3d(plane[0], plane[1], plane[2], points[1]) == side &&
           orient3d(plane[0], plane[1], plane[2], points[2]) == side;
  };
  if (all_on_one_side(s, t) || all_on_one_side(t, s)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (meet(s[i], s[(i + 1) % 3], t) || meet(t[i], t[(i + 1) % 3], s)) return true;
  }
  return false;
}

/// \pre corner 0 is common
bool meet_beyond_corner(const Corners& s, const Corners& t) { return meet(s[1], s[2], t) || meet(t[1], t[2], s); }

/// \pre corner 0 is the one that is not common
bool meet_beyond_edge(const Corners& s, const Corners& t) {
  if (orient3d(s[0], s[1], s[2], t[0]) != 0) return false;
  const Projection plane(s);
  return orient2d(t[0], s[1], s[2], plane.x, plane.y) == plane.turn;
}

/// \param is_common (i, j): whether corner i of one face is corner j of the other
template <class IsCommon>
bool meet_beyond_common(const Corners& s, const Corners& t, const IsCommon& is_common) {
  std::size_t n_common = 0, s_sum = 0, t_sum = 0, s_corner = 0, t_corner = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!is_common(i, j)) continue;
      ++n_common;
      s_corner = i, t_corner = j;
      s_sum += i, t_sum += j;
    }
  }
  switch (n_common) {
    case 0:
      return meet_apart(s, t);
    case 1:
      return meet_beyond_corner(turned(s, s_corner), turned(t, t_corner));
    case 2:  // 0 + 1 + 2 minus the sum is the corner that is not common
      return meet_beyond_edge(turned(s, 3 - s_sum), turned(t, 3 - t_sum));
    default:
      return true;
  }
}

/// Faces that have an area, along a curve, with their boxes in the frame: there all are small numbers, so that rounding
/// makes no box much larger.
struct Candidates {
  std::vector<Index> faces;
  std::vector<FloatBox> boxes;

  Candidates(const IndexedMesh& mesh, const detail::Workers& workers) {
    const Frame frame = Frame::of_box(bounds_of(mesh));  // a vertex of no face may be anywhere
    std::vector<Vec3> centers;
    std::vector<Index> found;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Corners corners = corners_of(mesh.positions, mesh.faces[f]);
      if (!has_area(corners)) continue;
      found.push_back(static_cast<Index>(f));
      centers.push_back(center_of(box_of(corners)));
    }
    for (const Index i : morton_order(centers, frame, workers.threads)) faces.push_back(found[i]);
    boxes.resize(faces.size());
    for_each_range(boxes.size(), workers, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        boxes[i] = box_of(frame.to_frame(corners_of(mesh.positions, mesh.faces[faces[i]]))).cast<float>();
      }
    });
  }
};

}  // namespace

bool has_area(const Corners& face) { return Projection(face).turn != 0; }

bool do_intersect(const Corners& face, const Corners& other) {
  return meet_beyond_common(face, other, [&](std::size_t i, std::size_t j) { return face[i] == other[j]; });
}

std::vector<std::array<Index, 2>> face_intersections(const IndexedMesh& mesh,
                                                     const std::function<bool(Index, Index)>& is_wanted,
                                                     unsigned threads, const ProgressCallback& progress) {
  const Box box = bounds_of(mesh);
  if (const double scale = working_scale({box}); scale != 1.0) {
    return face_intersections(scaled(mesh, scale), is_wanted, threads, progress);
  }
  detail::ProgressMeter meter(progress);
  const detail::Workers workers(threads, &meter);
  meter.start("building the search tree", 0.3);
  const Candidates candidates(mesh, workers);
  meter.start("comparing faces", 1);
  const auto in_order = [&](Index i, Index j) { return std::minmax({candidates.faces[i], candidates.faces[j]}); };
  const auto is_found = [&](Index i, Index j) {
    const auto [low, high] = in_order(i, j);
    return (!is_wanted || is_wanted(low, high)) &&
           do_intersect(corners_of(mesh.positions, mesh.faces[low]), corners_of(mesh.positions, mesh.faces[high]));
  };
  IndexPairs pairs = overlapping_boxes(candidates.boxes, is_found, workers);
  for (auto& pair : pairs) {
    const auto [low, high] = in_order(pair[0], pair[1]);
    pair = {low, high};
  }
  std::sort(pairs.begin(), pairs.end());
  meter.finish();
  return pairs;
}

}  // namespace whittle::metrics
