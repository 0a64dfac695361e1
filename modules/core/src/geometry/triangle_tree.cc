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
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int n_bins = 16;
constexpr double most_extent = 1e70;
/// Of the unit, so that squares of distances of 1e70 are finite in it.
constexpr int least_exponent = -270;

float half_surface(const FloatBox& box) {
  const Eigen::Vector3f side = box.max() - box.min();
  return side.x() * side.y() + side.y() * side.z() + side.z() * side.x();
}

/// The corners by ascending vertex number.
Triangle in_order(Triangle corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// A box of single precision around one of double precision whose coordinates are at most about 1.
FloatBox float_box_around(const Box& box) {
  constexpr float most_rounding = std::numeric_limits<float>::epsilon();  // twice what may be
  constexpr float least = std::numeric_limits<float>::min();
  const Eigen::Array3f low = box.min().cast<float>();
  const Eigen::Array3f high = box.max().cast<float>();
  return {low - (most_rounding * low.abs() + least), high + (most_rounding * high.abs() + least)};
}

}  // namespace

/// Boxes around faces, and around the sums of the two ends of each box: twice their centres.
struct TriangleTree::Bounds {
  FloatBox box;
  FloatBox twice_centers;

  void add(const FloatBox& of_face) {
    box.extend(of_face);
    twice_centers.extend(of_face.min() + of_face.max());
  }
  void add(const Bounds& other) {
    box.extend(other.box);
    twice_centers.extend(other.twice_centers);
  }
};

struct TriangleTree::Reference {
  FloatBox box;
  Index face;

  float twice_center(Eigen::Index axis) const { return box.min()[axis] + box.max()[axis]; }
};

struct TriangleTree::Parts {
  std::size_t n_left;
  Bounds left, right;
};

TriangleTree::TriangleTree(const IndexedMesh& mesh) : TriangleTree(mesh, center_of(bounds_of(mesh))) {}

TriangleTree::TriangleTree(const IndexedMesh& mesh, const Vec3& origin, detail::ProgressMeter* meter)
    : origin_(origin) {
  const Box box = bounds_of(mesh);
  if (box.sizes().maxCoeff() > most_extent) throw std::invalid_argument("mesh is larger than 1e70; scale it");
  if (!origin.allFinite()) throw std::invalid_argument("origin of the hierarchy is not finite");
  const double farthest = (box.min() - origin).cwiseAbs().cwiseMax((box.max() - origin).cwiseAbs()).maxCoeff();
  if (farthest > 0) unit_ = std::ldexp(1.0, std::max(least_exponent, std::ilogb(farthest) + 1));
  const std::size_t n = mesh.faces.size();
  LargeArray<Reference> references(n);
  Bounds bounds;
  for (std::size_t f = 0; f < n; ++f) {
    const Box of_face = box_of(corners_of(mesh.positions, mesh.faces[f]));
    const FloatBox inner = float_box_around({in_units(of_face.min() - origin), in_units(of_face.max() - origin)});
    references[f] = {inner, static_cast<Index>(f)};
    bounds.add(inner);
  }
  if (meter != nullptr) meter->update(0);
  nodes_.reserve(n);
  nodes_.resize(1);
  slot_of_face_.resize(n);
  build(0, references, 0, bounds, 0, meter);
  nodes_.shrink_to_fit();
  list_slots(mesh, references, meter);
}

void TriangleTree::list_slots(const IndexedMesh& mesh, std::span<const Reference> references,
                              detail::ProgressMeter* meter) {
  slots_.reserve(references.size());
  std::vector<Index> new_numbers(mesh.positions.size(), invalid_index);
  for (const Reference& reference : references) {
    if (slots_.size() % (1U << 16) == 0 && meter != nullptr) meter->update(0);
    slot_of_face_[reference.face] = static_cast<std::uint32_t>(slots_.size());
    Triangle corners = in_order(mesh.faces[reference.face]);
    for (Index& v : corners) {
      Index& number = new_numbers[v];
      if (number == invalid_index) {
        number = static_cast<Index>(positions_.size());
        positions_.emplace_back(mesh.positions[v] - origin_);
      }
      v = number;
    }
    slots_.push_back({corners, reference.face});
  }
  positions_.shrink_to_fit();
}

double TriangleTree::distance_sq_to_box(const Vec3& point, const Box& box) {
  return length_sq((box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0));
}

/// \param first number of the first slot
void TriangleTree::build(std::uint32_t node, std::span<Reference> references, std::uint32_t first, const Bounds& bounds,
                         std::size_t depth, detail::ProgressMeter* meter) {
  constexpr std::size_t large = 4096;  // takes about a millisecond
  if (meter != nullptr && references.size() >= large) meter->update(first / static_cast<double>(slot_of_face_.size()));
  nodes_[node].box = bounds.box;
  if (references.size() <= max_leaf) {
    nodes_[node].first = first;
    nodes_[node].count = static_cast<std::uint32_t>(references.size());
    return;
  }
  const auto [n_left, left, right] = split(references, bounds.twice_centers, depth);
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(child + 2);
  nodes_[node].first = child;
  build(child, references.first(n_left), first, left, depth + 1, meter);
  build(child + 1, references.subspan(n_left), first + static_cast<std::uint32_t>(n_left), right, depth + 1, meter);
}

/// Divides the references between the two children.
TriangleTree::Parts TriangleTree::split(std::span<Reference> references, const FloatBox& centers, std::size_t depth) {
  Eigen::Index axis = 0;
  const float width = (centers.max() - centers.min()).maxCoeff(&axis);
  const auto halve = [&] {
    Parts halves{references.size() / 2, {}, {}};
    const auto middle = references.begin() + static_cast<std::ptrdiff_t>(halves.n_left);
    std::nth_element(references.begin(), middle, references.end(), [axis](const Reference& l, const Reference& r) {
      return std::pair(l.twice_center(axis), l.face) < std::pair(r.twice_center(axis), r.face);
    });
    for (const Reference& reference : references.first(halves.n_left)) halves.left.add(reference.box);
    for (const Reference& reference : references.subspan(halves.n_left)) halves.right.add(reference.box);
    return halves;
  };
  const float per_width = n_bins / width;
  if (depth >= max_heuristic_depth || !std::isfinite(per_width)) return halve();

  struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
    void add(const Bin& other) {
      bounds.add(other.bounds);
      count += other.count;
    }
    float cost() const { return count > 0 ? static_cast<float>(count) * half_surface(bounds.box) : 0; }
  };
  const auto bin_of = [&](const Reference& reference) {
    const float at = (reference.twice_center(axis) - centers.min()[axis]) * per_width;
    return std::clamp(static_cast<int>(at), 0, n_bins - 1);
  };
  std::array<Bin, n_bins> bins;
  for (const Reference& reference : references) {
    Bin& bin = bins[static_cast<std::size_t>(bin_of(reference))];
    bin.bounds.add(reference.box);
    ++bin.count;
  }

  std::array<Bin, n_bins> from_right;
  Bin right;
  for (std::size_t k = n_bins - 1; k > 0; --k) {
    right.add(bins[k]);
    from_right[k] = right;
  }
  Bin left;
  float best_cost = std::numeric_limits<float>::infinity();
  int best = 0;
  Parts parts{};
  for (std::size_t k = 1; k < n_bins; ++k) {
    left.add(bins[k - 1]);
    const float cost = left.cost() + from_right[k].cost();
    if (left.count == 0 || left.count == references.size() || !(cost < best_cost)) continue;
    best_cost = cost;
    best = static_cast<int>(k);
    parts = {left.count, left.bounds, from_right[k].bounds};
  }
  if (best == 0) return halve();
  std::partition(references.begin(), references.end(),
                 [&](const Reference& reference) { return bin_of(reference) < best; });
  return parts;
}

Vec3 TriangleTree::nearest_in(const Corners& corners, const Vec3& point) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = trusted_normal(a, b, c);
  const Vec3 from_a = point - a, from_b = point - b;
  const bool flat = normal.isZero(0.0);
  const bool outside_ab = flat || normal.dot((b - a).cross(from_a)) < 0.0;
  const bool outside_bc = flat || normal.dot((c - b).cross(from_b)) < 0.0;
  const bool outside_ca = flat || normal.dot((a - c).cross(from_a)) < 0.0;
  Vec3 nearest;
  if (!outside_ab && !outside_bc && !outside_ca) {
    nearest = point - (normal.dot(from_a) / normal.squaredNorm()) * normal;
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
    if (outside_ab) consider(a, b);
    if (outside_bc) consider(b, c);
    if (outside_ca) consider(a, c);
  }
  // Inside the face's own box, its distance can't round to less than that of any box around the face. So the search
  // finds the nearest face in any order.
  return nearest.cwiseMax(a.cwiseMin(b).cwiseMin(c)).cwiseMin(a.cwiseMax(b).cwiseMax(c));
}

ClosestPoint TriangleTree::nearest(const Vec3& point, Index hint) const {
  ClosestPoint result = nearest_local(point - origin_, hint);
  result.point += origin_;
  return result;
}

ClosestPoint TriangleTree::nearest_local(const Vec3& offset, Index hint) const {
  const Vec3 point = in_units(offset);
  ClosestPoint best;
  best.distance_sq = infinity;
  const auto consider = [&](const Slot& slot) {
    const Corners corners = this->corners(slot);
    if (distance_sq_to_box(offset, box_of(corners)) > best.distance_sq) return;
    const Vec3 candidate = nearest_in(corners, offset);
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
  const auto entry = [&](std::uint32_t node) { return Entry{node, unit_sq() * nodes_[node].distance_sq(point)}; };
  std::array<Entry, max_depth + 2> stack;
  std::size_t size = 0;
  stack[size++] = entry(0);
  while (size > 0) {
    const auto [number, distance_sq] = stack[--size];
    if (distance_sq > best.distance_sq) continue;
    const Node& node = nodes_[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) consider(slots_[i]);
    if (node.count > 0) continue;
    Entry near = entry(node.first);
    Entry far = entry(node.first + 1);
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
    const Corners corners = corners_of(mesh.positions, in_order(mesh.faces[f]));
    if (distance_sq_to_box(point, box_of(corners)) > best.distance_sq) continue;
    const Vec3 candidate = nearest_in(corners, point);
    const double distance_sq = length_sq(point - candidate);
    if (distance_sq < best.distance_sq) best = {f, candidate, distance_sq};
  }
  return best;
}

TriangleTree::OffsetFace TriangleTree::nearest_without_tree(const IndexedMesh& mesh, std::span<const double> offsets,
                                                            const Vec3& point) {
  OffsetFace best{invalid_index, infinity};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Corners corners = corners_of(mesh.positions, in_order(mesh.faces[f]));
    if (std::sqrt(distance_sq_to_box(point, box_of(corners))) + offsets[f] > best.distance) continue;
    const Vec3 candidate = nearest_in(corners, point);
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

TriangleTree::OffsetFace TriangleTree::nearest_by_offsets(const Vec3& offset, Index hint) const {
  const Vec3 point = in_units(offset);
  OffsetFace best{invalid_index, infinity};
  const auto consider = [&](const Slot& slot) {
    const Corners corners = this->corners(slot);
    const double of_face = offsets_[slot.face];
    if (std::sqrt(distance_sq_to_box(offset, box_of(corners))) + of_face > best.distance) return;
    const double distance = std::sqrt(length_sq(offset - nearest_in(corners, offset))) + of_face;
    if (distance < best.distance || (distance == best.distance && slot.face < best.face)) best = {slot.face, distance};
  };
  if (hint < slot_of_face_.size()) consider(slots_[slot_of_face_[hint]]);

  struct Entry {
    std::uint32_t node;
    double distance;
  };
  const auto entry = [&](std::uint32_t node) {
    return Entry{node, unit_ * std::sqrt(nodes_[node].distance_sq(point)) + least_offsets_[node]};
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
