// Samples, seeds and blocks are those of distance.cc.
#include "whittle/metrics/attribute_deviation.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <tuple>

#include "attributes/near_sheets.hh"
#include "attributes/surface_attribute.hh"
#include "noise.hh"
#include "sampling/surface_sampler.hh"
#include "sampling/tree_pair.hh"
#include "triangle_math.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/metrics/bounds.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

/// Sheets that are no farther than the nearest one by this share of the diagonal, at a right angle, may be the right
/// ones: about as far as seams move when meshes are simplified to a tenth.
constexpr double sheet_tolerance_rel = 1e-3;

/// An attribute that both meshes have. Normals and colours are copied.
struct Shared {
  const Attribute* reference;
  const Attribute* test;
};

template <class Value>
Attribute copied(const char* name, AttributeKind kind, const std::vector<Value>& values) {
  Attribute attribute{.name = name, .kind = kind, .n_components = std::tuple_size_v<Value>, .values = {}};
  attribute.values.reserve(values.size() * attribute.n_components);
  for (const Value& value : values) attribute.values.insert(attribute.values.end(), value.begin(), value.end());
  return attribute;
}

bool are_comparable(const Attribute& a, const Attribute& b) {
  return a.name == b.name && a.kind == b.kind &&
         (a.n_components == b.n_components || a.kind == AttributeKind::joint_weights);
}

std::vector<Shared> shared_attributes(const IndexedMesh& reference, const IndexedMesh& test,
                                      std::deque<Attribute>& copies) {
  std::vector<Shared> shared;
  const auto add_copies = [&](const char* name, AttributeKind kind, const auto& of_reference, const auto& of_test) {
    if (of_reference.empty() || of_test.empty()) return;
    const Attribute& first = copies.emplace_back(copied(name, kind, of_reference));
    shared.push_back({&first, &copies.emplace_back(copied(name, kind, of_test))});
  };
  add_copies("NORMAL", AttributeKind::normal, reference.normals, test.normals);
  add_copies("COLOR_0", AttributeKind::color, reference.colors, test.colors);
  for (const Attribute& attribute : reference.attributes) {
    const auto other = std::find_if(test.attributes.begin(), test.attributes.end(),
                                    [&](const Attribute& a) { return are_comparable(attribute, a); });
    if (other != test.attributes.end()) shared.push_back({&attribute, &*other});
  }
  return shared;
}

/// Weights of the corners of a triangle, with sum 1, for a point in it. A triangle too thin counts as its longest side.
std::array<double, 3> barycentric(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = trusted_normal(a, b, c);
  std::array<double, 3> weights{};
  if (normal.isZero(0.0)) {
    std::size_t from = 0;
    for (const std::size_t k : {1U, 2U}) {
      if ((corners[(k + 1) % 3] - corners[k]).squaredNorm() > (corners[(from + 1) % 3] - corners[from]).squaredNorm()) {
        from = k;
      }
    }
    const Vec3 side = corners[(from + 1) % 3] - corners[from];
    const double length_sq = side.squaredNorm();
    const double t = length_sq > 0.0 ? std::clamp((point - corners[from]).dot(side) / length_sq, 0.0, 1.0) : 0.0;
    weights[from] = 1.0 - t;
    weights[(from + 1) % 3] = t;
    return weights;
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &next = corners[(k + 1) % 3], &last = corners[(k + 2) % 3];
    weights[k] = std::max(0.0, normal.dot((last - next).cross(point - next)));
    sum += weights[k];
  }
  if (!(sum > 0.0)) return {1.0, 0.0, 0.0};
  for (double& weight : weights) weight /= sum;
  return weights;
}

struct Sums {
  std::size_t samples = 0;
  double deviation = 0.0, max = 0.0;

  void add(const Sums& other) {
    samples += other.samples;
    deviation += other.deviation;
    max = std::max(max, other.max);
  }
};

/// One direction: from the samples of a surface to the other surface.
struct Direction {
  const SurfaceSampler& from;
  const SurfaceSampler& to;  ///< for its corners
  const TriangleTree& tree;  ///< of `to`
  const std::vector<SurfaceAttribute>& from_attributes;
  const std::vector<SurfaceAttribute>& to_attributes;
  double noise_sq;
  double sheet_tolerance_sq;
};

/// Compares one attribute at points of both surfaces.
class Comparer {
 public:
  Comparer(const SurfaceAttribute& from, const SurfaceAttribute& to)
      : from_(from),
        to_(to),
        from_blend_(from.blend()),
        to_blend_(to.blend()),
        here_(from.n_components()),
        there_(to.n_components()) {}

  const SurfaceAttribute& other() const { return to_; }

  /// \return false if the attribute isn't defined there
  bool set_here(std::size_t face, const std::array<double, 3>& weights) {
    return from_.value(face, weights, from_blend_, here_);
  }
  /// Infinite if the attribute isn't defined there.
  double deviation_at(std::size_t face, const std::array<double, 3>& weights) {
    if (!to_.value(face, weights, to_blend_, there_)) return std::numeric_limits<double>::infinity();
    return deviation(from_.kind(), here_, there_);
  }

 private:
  const SurfaceAttribute& from_;
  const SurfaceAttribute& to_;
  AttributeBlend from_blend_, to_blend_;
  std::vector<double> here_, there_;
};

std::vector<Sums> measure_block(const Direction& direction, std::size_t begin, std::size_t end) {
  std::vector<Comparer> comparers;
  for (std::size_t a = 0; a < direction.from_attributes.size(); ++a) {
    comparers.emplace_back(direction.from_attributes[a], direction.to_attributes[a]);
  }
  std::vector<Sums> sums(comparers.size());
  NearSheets sheets;
  Index hint = invalid_index;
  direction.from.for_each(begin, end, [&](std::size_t face, const Vec3& point) {
    const ClosestPoint nearest = direction.tree.nearest_local(point, hint);
    hint = nearest.face;
    sheets.find(direction.tree, point, nearest.distance_sq + direction.sheet_tolerance_sq);
    const auto here = barycentric(direction.from.corners(face), point);
    for (std::size_t a = 0; a < comparers.size(); ++a) {
      if (!comparers[a].set_here(face, here)) continue;
      double least = std::numeric_limits<double>::infinity();
      sheets.for_each_sheet(comparers[a].other(), [&](const ClosestPoint& there) {
        const Vec3& at = there.distance_sq > direction.noise_sq ? there.point : point;
        const auto weights = barycentric(direction.to.corners(there.face), at);
        least = std::min(least, comparers[a].deviation_at(there.face, weights));
      });
      if (least == std::numeric_limits<double>::infinity()) continue;
      sums[a].add({1, least, least});
    }
  });
  return sums;
}

std::vector<Sums> measure(const Direction& direction, const detail::Workers& workers) {
  const std::size_t n_samples = direction.from.n_samples();
  std::vector<std::vector<Sums>> blocks((n_samples + samples_per_block - 1) / samples_per_block);
  detail::for_each_block(blocks.size(), workers, [&](std::size_t block) {
    const std::size_t begin = block * samples_per_block;
    blocks[block] = measure_block(direction, begin, std::min(begin + samples_per_block, n_samples));
  });
  std::vector<Sums> total(direction.from_attributes.size());
  for (const std::vector<Sums>& block : blocks) {
    for (std::size_t a = 0; a < total.size(); ++a) total[a].add(block[a]);
  }
  return total;
}

DirectedAttributeDeviation summarize(const Sums& sums) {
  return {sums.deviation / static_cast<double>(sums.samples), sums.max};
}

std::vector<AttributeDeviation> summarize(const std::vector<Shared>& shared, const std::vector<Sums>& forward,
                                          const std::vector<Sums>& backward) {
  std::vector<AttributeDeviation> deviations;
  for (std::size_t a = 0; a < shared.size(); ++a) {
    if (forward[a].samples == 0 || backward[a].samples == 0) continue;
    AttributeDeviation& d = deviations.emplace_back();
    d.name = shared[a].reference->name;
    d.kind = shared[a].reference->kind;
    d.forward = summarize(forward[a]);
    d.backward = summarize(backward[a]);
    d.mean = 0.5 * (d.forward.mean + d.backward.mean);
    d.max = std::max(d.forward.max, d.backward.max);
  }
  return deviations;
}

}  // namespace

std::vector<AttributeDeviation> attribute_deviations(const IndexedMesh& reference, const IndexedMesh& test,
                                                     const DistanceOptions& options) {
  check_samples(options.samples);
  const Bounds reference_box = bounds(reference), test_box = bounds(test);
  if (const double scale = working_scale({reference_box, test_box}); scale != 1.0) {
    const auto rescaled = [scale](IndexedMesh mesh) {
      for (Vec3& p : mesh.positions) p *= scale;
      return mesh;
    };
    return attribute_deviations(rescaled(reference), rescaled(test), options);
  }
  std::deque<Attribute> copies;
  const std::vector<Shared> shared = shared_attributes(reference, test, copies);
  if (shared.empty()) return {};
  const Vec3 origin = reference_box.center();
  const double diagonal = std::max(reference_box.diagonal(), test_box.diagonal());
  detail::ProgressMeter meter(options.progress);
  const detail::Workers workers(options.threads, &meter);
  meter.start("building the search trees", 0.2);
  const TreePair trees(reference, test, origin, workers, meter);
  std::vector<SurfaceAttribute> of_reference, of_test;
  for (const Shared& attribute : shared) {
    of_reference.emplace_back(reference, *attribute.reference);
    of_test.emplace_back(test, *attribute.test);
  }
  const SurfaceSampler sampled_reference(reference, origin, options.samples, CounterRandom(options.seed, 0));
  const SurfaceSampler sampled_test(test, origin, options.samples, CounterRandom(options.seed, 1));
  const double noise = noise_rel * diagonal, tolerance = sheet_tolerance_rel * diagonal;
  const auto direction = [&](const auto& from, const auto& to, const TriangleTree& tree, const auto& of_from,
                             const auto& of_to) {
    return Direction{from, to, tree, of_from, of_to, noise * noise, tolerance * tolerance};
  };
  meter.start("measuring the attributes", 0.6);
  const std::vector<Sums> forward =
      measure(direction(sampled_reference, sampled_test, trees.test(), of_reference, of_test), workers);
  meter.start("measuring the attributes", 1);
  const std::vector<Sums> backward =
      measure(direction(sampled_test, sampled_reference, trees.reference(), of_test, of_reference), workers);
  meter.finish();
  return summarize(shared, forward, backward);
}

}  // namespace whittle::metrics
