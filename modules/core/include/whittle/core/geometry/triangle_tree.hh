#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {
class ProgressMeter;
}

namespace whittle {

/// The closest point of a surface to a point.
struct ClosestPoint {
  Index face = invalid_index;
  Vec3 point = Vec3::Zero();  ///< On the face, model units.
  double distance_sq = 0.0;   ///< Model units squared.
};

/// A bounding volume hierarchy over the faces of a mesh, for exact closest points.
///
/// Any triangles are allowed. Degenerate triangles count as segments or points. Of coincident faces the lowest number
/// is returned. Coordinates are relative to an origin near the mesh, so that a mesh far from zero loses no precision.
/// The tree holds copies; the mesh may be destroyed. Building takes O(F log F) time and about 90 bytes a face, of which
/// 50 stay; a query takes O(log F) time if the point is near the surface. Extents and distances must be within
/// 1e-70 … 1e70, as their fourth powers are taken; larger extents are refused. Any number of threads may query at the
/// same time.
class TriangleTree {
 public:
  /// \throw std::invalid_argument as `bounds`, and for extents above 1e70.
  explicit TriangleTree(const IndexedMesh& mesh);
  /// With a given origin, for queries against several trees in the same local coordinates.
  /// \param meter gets the progress, and may cancel; internal
  TriangleTree(const IndexedMesh& mesh, const Vec3& origin, detail::ProgressMeter* meter = nullptr);

  /// The closest point of the surface; of faces at exactly the same distance, on the face with the lowest number.
  /// \param point finite, model units.
  /// \param hint a face that may be near, such as the result for a neighbouring point, or `invalid_index`. Only the
  ///        time depends on it.
  ClosestPoint nearest(const Vec3& point, Index hint = invalid_index) const;

  /// The same, with argument and result in coordinates relative to `origin()`.
  ClosestPoint nearest_local(const Vec3& offset, Index hint = invalid_index) const;

  /// Calls `visit(closest)` with the closest point of each face within a distance of a point, roughly nearest first.
  /// Coordinates are relative to `origin()`. \param most_sq squared distance; each call of `visit` returns the new one
  template <class Visitor>
  void visit_near(const Vec3& offset, double most_sq, Visitor&& visit) const;

  /// Sets offsets that `nearest_by_offsets` adds to distances. \param offsets per face, not negative
  void set_offsets(std::vector<double> offsets);

  struct OffsetFace {
    Index face = invalid_index;
    double distance = 0.0;  ///< With the face's offset, model units.
  };
  /// The face with the least sum of distance and offset.
  /// \pre offsets are set
  /// \param offset, hint as for `nearest_local`
  OffsetFace nearest_by_offsets(const Vec3& offset, Index hint) const;

  /// The same result as `nearest_local` of a tree with its origin at zero, to the bit, by a search of all faces. Faster
  /// for a few points. \param mesh with faces
  static ClosestPoint nearest_without_tree(const IndexedMesh& mesh, const Vec3& point);
  /// The same for `nearest_by_offsets`. \param offsets per face, not negative
  static OffsetFace nearest_without_tree(const IndexedMesh& mesh, std::span<const double> offsets, const Vec3& point);

  const Vec3& origin() const { return origin_; }

  /// Calls `visit(face)` for each face whose own box meets the closed box `local` (relative to `origin()`), in no
  /// particular order.
  template <class Visitor>
  void visit_boxes(const Box& local, Visitor&& visit) const;

 private:
  struct Node {
    FloatBox box;             ///< In `unit_`s.
    std::uint32_t first = 0;  ///< Index of a leaf's first slot, or of a node's first child; the second child is next.
    std::uint32_t count = 0;  ///< A leaf's number of slots; 0 if not a leaf.

    /// Of a point from the box, squared, all in `unit_`s.
    double distance_sq(const Vec3& point) const;
  };
  /// A face with its corners by ascending vertex number, so that faces with a common edge get the same distance to it.
  struct Slot {
    Triangle corners;  ///< In `positions_`.
    Index face;
  };
  struct Bounds;
  struct Reference;
  struct Parts;

  /// Below this depth nodes are split at the median, which needs at most 32 levels more.
  static constexpr std::size_t max_heuristic_depth = 48;
  static constexpr std::size_t max_depth = max_heuristic_depth + 32;
  static constexpr std::uint32_t max_leaf = 4;

  void build(std::uint32_t node, std::span<Reference> references, std::uint32_t first, const Bounds& bounds,
             std::size_t depth, detail::ProgressMeter* meter);
  static Parts split(std::span<Reference> references, const FloatBox& centers, std::size_t depth);
  void list_slots(const IndexedMesh& mesh, std::span<const Reference> references, detail::ProgressMeter* meter);

  Vec3 in_units(const Vec3& offset) const { return offset / unit_; }
  double unit_sq() const { return unit_ * unit_; }
  Corners corners(const Slot& slot) const { return corners_of(positions_, slot.corners); }
  static Vec3 nearest_in(const Corners& corners, const Vec3& point);
  /// Always summed in the same order: a vector that is smaller in each component never gets a greater length.
  static double length_sq(const Vec3& v) { return (v.x() * v.x() + v.y() * v.y()) + v.z() * v.z(); }
  static double distance_sq_to_box(const Vec3& point, const Box& box);

  Vec3 origin_;
  double unit_ = 1;  ///< A power of two, at least as large as all offsets from the origin.
  LargeArray<Node> nodes_;
  LargeArray<Slot> slots_;
  LargeArray<Vec3> positions_;  ///< Relative to the origin, in the order in which slots use them.
  LargeArray<std::uint32_t> slot_of_face_;
  std::vector<double> offsets_;        ///< Of each face, model units; or empty.
  std::vector<double> least_offsets_;  ///< Of the faces in each node.
};

inline double TriangleTree::Node::distance_sq(const Vec3& point) const {
  const Vec3 low = box.min().cast<double>();
  const Vec3 high = box.max().cast<double>();
  return length_sq((low - point).cwiseMax(point - high).cwiseMax(0.0));
}

template <class Visitor>
void TriangleTree::visit_near(const Vec3& offset, double most_sq, Visitor&& visit) const {
  const Vec3 center = in_units(offset);
  std::array<std::uint32_t, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (unit_sq() * node.distance_sq(center) > most_sq) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Vec3 point = nearest_in(corners(slots_[i]), offset);
      const double distance_sq = length_sq(offset - point);
      if (distance_sq <= most_sq) most_sq = visit(ClosestPoint{slots_[i].face, point, distance_sq});
    }
    if (node.count > 0) continue;
    const bool first_is_nearer = nodes_[node.first].distance_sq(center) <= nodes_[node.first + 1].distance_sq(center);
    stack[size++] = first_is_nearer ? node.first + 1 : node.first;
    stack[size++] = first_is_nearer ? node.first : node.first + 1;
  }
}

template <class Visitor>
void TriangleTree::visit_boxes(const Box& local, Visitor&& visit) const {
  const Box wanted(in_units(local.min()), in_units(local.max()));
  std::array<std::uint32_t, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (!node.box.cast<double>().intersects(wanted)) continue;
    if (node.count == 0) {
      stack[size++] = node.first + 1;
      stack[size++] = node.first;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (box_of(corners(slots_[i])).intersects(local)) visit(slots_[i].face);
    }
  }
}

}  // namespace whittle
