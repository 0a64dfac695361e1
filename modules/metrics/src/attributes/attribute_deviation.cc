// Samples, seeds and blocks as in distance.cc.
#include "whittle/metrics/attribute_deviation.hh"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <optional>

#include "attributes/comparison.hh"
#include "attributes/near_sheets.hh"
#include "attributes/surface_attribute.hh"
#include "noise.hh"
#include "sampling/surface_sampler.hh"
#include "sampling/tree_pair.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/bounds.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

struct AttributeSums {
  std::size_t samples = 0;
  double deviation = 0.0, max = 0.0;

  void add(const AttributeSums& other) {
    samples += other.samples;
    deviation += other.deviation;
    max = std::max(max, other.max);
  }
};

/// One direction: from the samples of a surface to the other surface.
struct AttributeDirection {
  const SurfaceSampler& from;
  const SurfaceSampler& to;  ///< for its corners
  const TriangleTree& tree;  ///< of `to`
  const std::vector<SurfaceAttribute>& from_attributes;
  const std::vector<SurfaceAttribute>& to_attributes;
  double noise_sq;
  double sheet_tolerance_sq;
};

std::vector<AttributeSums> measure_block(const AttributeDirection& direction, std::size_t begin, std::size_t end) {
  std::vector<Comparer> comparers;
  for (std::size_t a = 0; a < direction.from_attributes.size(); ++a) {
    comparers.emplace_back(direction.from_attributes[a], direction.to_attributes[a]);
  }
  std::vector<AttributeSums> sums(comparers.size());
  NearSheets sheets;
  Index hint = invalid_index;
  direction.from.for_each(begin, end, [&](std::size_t face, const Vec3& point) {
    const ClosestPoint nearest = direction.tree.nearest_local(point, hint);
    hint = nearest.face;
    sheets.find(direction.tree, point, nearest.distance_sq + direction.sheet_tolerance_sq);
    const auto here = barycentric(direction.from.corners(face), point);
    for (std::size_t a = 0; a < comparers.size(); ++a) {
      if (!comparers[a].set_here(face, here)) continue;
      const double least = least_deviation(sheets, comparers[a], point, direction.noise_sq,
                                           [&](std::size_t f) { return direction.to.corners(f); });
      if (least == std::numeric_limits<double>::infinity()) continue;
      sums[a].add({1, least, least});
    }
  });
  return sums;
}

std::vector<AttributeSums> measure(const AttributeDirection& direction, const detail::Workers& workers) {
  const std::size_t n_samples = direction.from.n_samples();
  std::vector<std::vector<AttributeSums>> blocks((n_samples + samples_per_block - 1) / samples_per_block);
  detail::for_each_block(blocks.size(), workers, [&](std::size_t block) {
    const std::size_t begin = block * samples_per_block;
    blocks[block] = measure_block(direction, begin, std::min(begin + samples_per_block, n_samples));
  });
  std::vector<AttributeSums> total(direction.from_attributes.size());
  for (const std::vector<AttributeSums>& block : blocks) {
    for (std::size_t a = 0; a < total.size(); ++a) total[a].add(block[a]);
  }
  return total;
}

DirectedAttributeDeviation summarize(const AttributeSums& sums) {
  return {sums.deviation / static_cast<double>(sums.samples), sums.max};
}

std::vector<AttributeDeviation> summarize(const std::vector<Shared>& shared, const std::vector<AttributeSums>& forward,
                                          const std::vector<AttributeSums>& backward) {
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
  const Box reference_box = bounds_of(reference), test_box = bounds_of(test);
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
  const Vec3 origin = center_of(reference_box);
  const double diagonal = std::max(diagonal_of(reference_box), diagonal_of(test_box));
  detail::ProgressMeter meter(options.progress);
  const detail::Workers workers(options.threads, &meter);
  meter.start("building the search trees", 0.2);
  std::optional<TriangleTree> tree_of_reference;
  const TreePair trees(reference, test, origin, workers, meter, tree_of_reference);
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
    return AttributeDirection{from, to, tree, of_from, of_to, noise * noise, tolerance * tolerance};
  };
  meter.start("measuring the attributes", 0.6);
  const std::vector<AttributeSums> forward =
      measure(direction(sampled_reference, sampled_test, trees.test(), of_reference, of_test), workers);
  meter.start("measuring the attributes", 1);
  const std::vector<AttributeSums> backward =
      measure(direction(sampled_test, sampled_reference, trees.reference(), of_test, of_reference), workers);
  meter.finish();
  return summarize(shared, forward, backward);
}

}  // namespace whittle::metrics
