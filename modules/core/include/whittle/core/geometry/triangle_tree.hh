#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
/// The tree holds copies; the mesh may be destroyed. Building takes O(F log F) time and about 200 bytes a face, a query
/// O(log F) time if the point is near the surface. Extents and distances must be within 1e-70 … 1e70, as their fourth
/// powers are taken; larger extents are refused. Any number of threads may query at the same time.
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
  /// \param point, hint as for `nearest_local`
  OffsetFace nearest_by_offsets(const Vec3& point, Index hint) const;

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
    Box box;
    std::uint32_t first = 0;  ///< Index of a leaf's first slot, or of a node's first child; the second child is next.
    std::uint32_t count = 0;  ///< A leaf's number of slots; 0 if not a leaf.
  };
  /// A face with its corners by ascending vertex number, so that faces with a common edge get the same distance to it.
  struct Slot {
    Vec3 a, b, c;
    Vec3 normal;  ///< (b − a) × (c − a); zero if the face is too thin for a reliable normal.
    Index face;
  };
  struct Reference;

  /// Below this depth nodes are split at the median, which needs at most 32 levels more.
  static constexpr std::size_t max_heuristic_depth = 48;
  static constexpr std::size_t max_depth = max_heuristic_depth + 32;
  static constexpr std::uint32_t max_leaf = 4;

  void build(std::uint32_t node, std::vector<Reference>& references, std::uint32_t begin, std::uint32_t end,
             std::size_t depth, detail::ProgressMeter* meter);
  /// Partitions the references between the two children. Returns the start of the second part.
  static std::uint32_t split(std::vector<Reference>& references, std::uint32_t begin, std::uint32_t end,
                             const Box& centers, std::size_t depth);
  static Slot slot_of(const IndexedMesh& mesh, Index face, const Vec3& origin);
  static Vec3 nearest_in(const Slot& slot, const Vec3& point);
  /// Always summed in the same order: a vector that is smaller in each component never gets a greater length.
  static double length_sq(const Vec3& v);
  static double distance_sq_to_box(const Vec3& point, const Box& box);

  Vec3 origin_;
  std::vector<Node> nodes_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> slot_of_face_;
  std::vector<double> offsets_;        ///< Of each face; or empty.
  std::vector<double> least_offsets_;  ///< Of the faces in each node.
};

template <class Visitor>
void TriangleTree::visit_near(const Vec3& offset, double most_sq, Visitor&& visit) const {
  const auto box_distance_sq = [&](std::uint32_t node) { return distance_sq_to_box(offset, nodes_[node].box); };
  std::array<std::uint32_t, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t number = stack[--size];
    if (box_distance_sq(number) > most_sq) continue;
    const Node& node = nodes_[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Vec3 point = nearest_in(slots_[i], offset);
      const double distance_sq = length_sq(offset - point);
      if (distance_sq <= most_sq) most_sq = visit(ClosestPoint{slots_[i].face, point, distance_sq});
    }
    if (node.count > 0) continue;
    const bool first_is_nearer = box_distance_sq(node.first) <= box_distance_sq(node.first + 1);
    stack[size++] = first_is_nearer ? node.first + 1 : node.first;
    stack[size++] = first_is_nearer ? node.first : node.first + 1;
  }
}

template <class Visitor>
void TriangleTree::visit_boxes(const Box& local, Visitor&& visit) const {
  std::array<std::uint32_t, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (!node.box.intersects(local)) continue;
    if (node.count == 0) {
      stack[size++] = node.first + 1;
      stack[size++] = node.first;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Slot& slot = slots_[i];
      if (box_of({slot.a, slot.b, slot.c}).intersects(local)) visit(slot.face);
    }
  }
}

}  // namespace whittle
