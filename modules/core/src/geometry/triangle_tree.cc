// The closest point of a triangle is the projection on its plane if that is inside all three sides. Else it is the
// closest point of the sides that the projection is outside of. Unlike the usual walk through Voronoi regions (Ericson:
// Real-Time Collision Detection, 5.1.5), this divides no barycentric coordinate by an area, so thin triangles lose no
// accuracy.
//
// Nodes are split by the surface area heuristic, in 16 bins along the widest axis of the box centres (Wald: On fast
// Construction of SAH-based Bounding Volume Hierarchies, 2007).
#include "whittle/core/geometry/triangle_tree.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int n_bins = 16;
constexpr double most_extent = 1e70;

double half_surface(const Box& box) {
  const Vec3 side = box.max() - box.min();
  return side.x() * side.y() + side.y() * side.z() + side.z() * side.x();
}

Box box_of_face(const IndexedMesh& mesh, std::size_t face) {
  return box_of(corners_of(mesh.positions, mesh.faces[face]));
}

}  // namespace

struct TriangleTree::Reference {
  Box box;
  Index face;

  double twice_center(Eigen::Index axis) const { return box.min()[axis] + box.max()[axis]; }
};

TriangleTree::TriangleTree(const IndexedMesh& mesh) : TriangleTree(mesh, center_of(bounds_of(mesh))) {}

TriangleTree::TriangleTree(const IndexedMesh& mesh, const Vec3& origin, detail::ProgressMeter* meter)
    : origin_(origin) {
  const Box box = bounds_of(mesh);
  if (box.sizes().maxCoeff() > most_extent) throw std::invalid_argument("mesh is larger than 1e70; scale it");
  if (!origin.allFinite()) throw std::invalid_argument("origin of the hierarchy is not finite");
  const std::size_t n = mesh.faces.size();
  std::vector<Reference> references(n);
  for (std::size_t f = 0; f < n; ++f) {
    const Box of_face = box_of_face(mesh, f);
    references[f] = {{of_face.min() - origin, of_face.max() - origin}, static_cast<Index>(f)};
  }
  const auto check = [meter] {
    if (meter != nullptr) meter->update(0);
  };
  check();
  nodes_.reserve(n);
  nodes_.resize(1);
  build(0, references, 0, static_cast<std::uint32_t>(n), 0, meter);
  check();
  slots_.reserve(n);
  slot_of_face_.resize(n);
  for (const Reference& reference : references) {
    slot_of_face_[reference.face] = static_cast<std::uint32_t>(slots_.size());
    slots_.push_back(slot_of(mesh, reference.face, origin));
    if (slots_.size() % (1U << 16) == 0) check();
  }
}

double TriangleTree::length_sq(const Vec3& v) { return (v.x() * v.x() + v.y() * v.y()) + v.z() * v.z(); }

double TriangleTree::distance_sq_to_box(const Vec3& point, const Box& box) {
  return length_sq((box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0));
}

TriangleTree::Slot TriangleTree::slot_of(const IndexedMesh& mesh, Index face, const Vec3& origin) {
  Triangle corners = mesh.faces[face];
  std::sort(corners.begin(), corners.end());
  const Vec3 a = mesh.positions[corners[0]] - origin;
  const Vec3 b = mesh.positions[corners[1]] - origin;
  const Vec3 c = mesh.positions[corners[2]] - origin;
  return {a, b, c, trusted_normal(a, b, c), face};
}

void TriangleTree::build(std::uint32_t node, std::vector<Reference>& references, std::uint32_t begin, std::uint32_t end,
                         std::size_t depth, detail::ProgressMeter* meter) {
  constexpr std::uint32_t large = 4096;  // takes about a millisecond
  if (meter != nullptr && end - begin >= large) meter->update(begin / static_cast<double>(references.size()));
  Box box, centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.extend(references[i].box);
    centers.extend(references[i].box.min() + references[i].box.max());
  }
  nodes_[node].box = box;
  if (end - begin <= max_leaf) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const std::uint32_t middle = split(references, begin, end, centers, depth);
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(child + 2);
  nodes_[node].first = child;
  build(child, references, begin, middle, depth + 1, meter);
  build(child + 1, references, middle, end, depth + 1, meter);
}

std::uint32_t TriangleTree::split(std::vector<Reference>& references, std::uint32_t begin, std::uint32_t end,
                                  const Box& centers, std::size_t depth) {
  Eigen::Index axis = 0;
  const double width = (centers.max() - centers.min()).maxCoeff(&axis);
  const auto at = [&](std::uint32_t i) { return references.begin() + i; };
  const auto halve = [&] {
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [axis](const Reference& left, const Reference& right) {
      const double l = left.twice_center(axis), r = right.twice_center(axis);
      return l != r ? l < r : left.face < right.face;
    });
    return middle;
  };
  const double per_width = n_bins / width;
  if (depth >= max_heuristic_depth || !(per_width < infinity)) return halve();

  struct Bin {
    Box box;
    std::uint32_t count = 0;
    void add(const Bin& other) {
      box.extend(other.box);
      count += other.count;
    }
    double cost() const { return count > 0 ? count * half_surface(box) : 0.0; }
  };
  const auto bin_of = [&](const Reference& reference) {
    return std::clamp(static_cast<int>((reference.twice_center(axis) - centers.min()[axis]) * per_width), 0,
                      n_bins - 1);
  };
  std::array<Bin, n_bins> bins;
  for (std::uint32_t i = begin; i < end; ++i)
    bins[static_cast<std::size_t>(bin_of(references[i]))].add({references[i].box, 1});

  std::array<double, n_bins> right_cost{};
  Bin right;
  for (std::size_t k = n_bins - 1; k > 0; --k) {
    right.add(bins[k]);
    right_cost[k] = right.cost();
  }
  Bin left;
  double best_cost = infinity;
  int best = 0;
  for (std::size_t k = 1; k < n_bins; ++k) {
    left.add(bins[k - 1]);
    const double cost = left.cost() + right_cost[k];
    if (left.count > 0 && left.count < end - begin && cost < best_cost) {
      best_cost = cost;
      best = static_cast<int>(k);
    }
  }
  if (best == 0) return halve();
  const auto middle =
      std::partition(at(begin), at(end), [&](const Reference& reference) { return bin_of(reference) < best; });
  return static_cast<std::uint32_t>(middle - references.begin());
}

Vec3 TriangleTree::nearest_in(const Slot& slot, const Vec3& point) {
  const Vec3 from_a = point - slot.a, from_b = point - slot.b;
  const bool flat = slot.normal.isZero(0.0);
  const bool outside_ab = flat || slot.normal.dot((slot.b - slot.a).cross(from_a)) < 0.0;
  const bool outside_bc = flat || slot.normal.dot((slot.c - slot.b).cross(from_b)) < 0.0;
  const bool outside_ca = flat || slot.normal.dot((slot.a - slot.c).cross(from_a)) < 0.0;
  Vec3 nearest;
  if (!outside_ab && !outside_bc && !outside_ca) {
    nearest = point - (slot.normal.dot(from_a) / slot.normal.squaredNorm()) * slot.normal;
  } else {
    double best_sq = infinity;
    const auto consider = [&](const Vec3& from, const Vec3& to) {
      const Vec3 candidate = nearest_on_segment(point, from, to);
      const double distance_sq = length_sq(point - candidate);
      if (distance_sq < best_sq) {
        best_sq = distance_sq;
        nearest = candidate;
      }
    };
    if (outside_ab) consider(slot.a, slot.b);
    if (outside_bc) consider(slot.b, slot.c);
    if (outside_ca) consider(slot.a, slot.c);
  }
  // Inside the face's own box, its distance can't round to less than that of any box around the face. So the search
  // finds the nearest face in any order.
  return nearest.cwiseMax(slot.a.cwiseMin(slot.b).cwiseMin(slot.c)).cwiseMin(slot.a.cwiseMax(slot.b).cwiseMax(slot.c));
}

ClosestPoint TriangleTree::nearest(const Vec3& point, Index hint) const {
  ClosestPoint result = nearest_local(point - origin_, hint);
  result.point += origin_;
  return result;
}

ClosestPoint TriangleTree::nearest_local(const Vec3& offset, Index hint) const {
  ClosestPoint best;
  best.distance_sq = infinity;
  const auto consider = [&](const Slot& slot) {
    const Vec3 candidate = nearest_in(slot, offset);
    const double distance_sq = length_sq(offset - candidate);
    if (distance_sq < best.distance_sq || (distance_sq == best.distance_sq && slot.face < best.face)) {
      best = {slot.face, candidate, distance_sq};
    }
  };
  if (hint < slot_of_face_.size()) consider(slots_[slot_of_face_[hint]]);

  struct Entry {
    std::uint32_t node;
    double distance_sq;
  };
  std::array<Entry, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = {0, distance_sq_to_box(offset, nodes_[0].box)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.distance_sq > best.distance_sq) continue;
    const Node& node = nodes_[entry.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) consider(slots_[i]);
    if (node.count > 0) continue;
    Entry near{node.first, distance_sq_to_box(offset, nodes_[node.first].box)};
    Entry far{node.first + 1, distance_sq_to_box(offset, nodes_[node.first + 1].box)};
    if (far.distance_sq < near.distance_sq) std::swap(near, far);
    if (far.distance_sq <= best.distance_sq) stack[size++] = far;
    if (near.distance_sq <= best.distance_sq) stack[size++] = near;
  }
  return best;
}

ClosestPoint TriangleTree::nearest_without_tree(const IndexedMesh& mesh, const Vec3& point) {
  ClosestPoint best;
  best.distance_sq = infinity;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (distance_sq_to_box(point, box_of_face(mesh, f)) > best.distance_sq) continue;
    const Vec3 candidate = nearest_in(slot_of(mesh, f, Vec3::Zero()), point);
    const double distance_sq = length_sq(point - candidate);
    if (distance_sq < best.distance_sq) best = {f, candidate, distance_sq};
  }
  return best;
}

TriangleTree::OffsetFace TriangleTree::nearest_without_tree(const IndexedMesh& mesh, std::span<const double> offsets,
                                                            const Vec3& point) {
  OffsetFace best{invalid_index, infinity};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (std::sqrt(distance_sq_to_box(point, box_of_face(mesh, f))) + offsets[f] > best.distance) continue;
    const Vec3 candidate = nearest_in(slot_of(mesh, f, Vec3::Zero()), point);
    const double distance = std::sqrt(length_sq(point - candidate)) + offsets[f];
    if (distance < best.distance) best = {f, distance};
  }
  return best;
}

void TriangleTree::set_offsets(std::vector<double> offsets) {
  offsets_ = std::move(offsets);
  least_offsets_.assign(nodes_.size(), infinity);
  for (std::size_t n = nodes_.size(); n-- > 0;) {  // children come after their parent
    const Node& node = nodes_[n];
    double& least = least_offsets_[n];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      least = std::min(least, offsets_[slots_[i].face]);
    }
    if (node.count == 0) least = std::min(least_offsets_[node.first], least_offsets_[node.first + 1]);
  }
}

TriangleTree::OffsetFace TriangleTree::nearest_by_offsets(const Vec3& point, Index hint) const {
  OffsetFace best{invalid_index, infinity};
  const auto consider = [&](const Slot& slot) {
    const double distance = std::sqrt(length_sq(point - nearest_in(slot, point))) + offsets_[slot.face];
    if (distance < best.distance || (distance == best.distance && slot.face < best.face)) best = {slot.face, distance};
  };
  if (hint < slot_of_face_.size()) consider(slots_[slot_of_face_[hint]]);

  struct Entry {
    std::uint32_t node;
    double distance;
  };
  const auto entry = [&](std::uint32_t node) {
    return Entry{node, std::sqrt(distance_sq_to_box(point, nodes_[node].box)) + least_offsets_[node]};
  };
  std::array<Entry, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = entry(0);
  while (size > 0) {
    const auto [number, distance] = stack[--size];
    if (distance > best.distance) continue;
    const Node& node = nodes_[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) consider(slots_[i]);
    if (node.count > 0) continue;
    Entry near = entry(node.first);
    Entry far = entry(node.first + 1);
    if (far.distance < near.distance) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  return best;
}

}  // namespace whittle
