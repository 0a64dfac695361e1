// Both surfaces are sampled in blocks. The result of a block depends on its number alone: random numbers are a function
// of a counter, and no state is carried from block to block. The blocks are summed in order. So the result is the same
// for any number of threads.
#include "whittle/metrics/distance.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "noise.hh"
#include "sampling/surface_sampler.hh"
#include "sampling/tree_pair.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/two_sided.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

constexpr std::size_t vertices_per_block = 2048;

/// Sums over the points of a block, or of all blocks.
struct Sums {
  std::size_t samples = 0, vertices = 0, normals = 0, flipped = 0;
  double distance = 0.0, sample_sq = 0.0, vertex_sq = 0.0, max_sq = 0.0, angle = 0.0;

  void add(const Sums& other) {
    samples += other.samples;
    vertices += other.vertices;
    normals += other.normals;
    flipped += other.flipped;
    distance += other.distance;
    sample_sq += other.sample_sq;
    vertex_sq += other.vertex_sq;
    max_sq = std::max(max_sq, other.max_sq);
    angle += other.angle;
  }
};

/// One direction: from the points of `from` to the surface `to`. Both trees have the same origin.
struct Direction {
  const IndexedMesh& from;
  const IndexedMesh& to;
  const TriangleTree& tree;
  const std::vector<bool>& is_two_sided;  ///< of the faces of `to`; or empty
  double noise_sq;

  double distance_sq(const Vec3& point, Index& hint) const {
    const ClosestPoint nearest = tree.nearest_local(point, hint);
    hint = nearest.face;
    return nearest.distance_sq > noise_sq ? nearest.distance_sq : 0.0;
  }

  /// The normal of the nearest face, or of its other side where that is more alike.
  Vec3 normal_there(Index face, const Vec3& here) const {
    const Vec3 normal = unit_normal(to, face);
    return !is_two_sided.empty() && is_two_sided[face] && here.dot(normal) < 0 ? Vec3(-normal) : normal;
  }

  Vec3 unit_normal(const IndexedMesh& mesh, std::size_t face) const {
    const auto [a, b, c] = mesh.faces[face];
    return trusted_normal(mesh.positions[a], mesh.positions[b], mesh.positions[c]).stableNormalized();
  }

  Sums measure_samples(const SurfaceSampler& sampler, std::size_t begin, std::size_t end) const {
    Sums sums;
    Index hint = invalid_index;
    sampler.for_each(begin, end, [&](std::size_t face, const Vec3& point) {
      const double d_sq = distance_sq(point, hint);
      ++sums.samples;
      sums.distance += std::sqrt(d_sq);
      sums.sample_sq += d_sq;
      sums.max_sq = std::max(sums.max_sq, d_sq);
      const Vec3 here = unit_normal(from, face), there = normal_there(hint, here);
      if (here.isZero(0.0) || there.isZero(0.0)) return;
      const double cosine = here.dot(there);
      ++sums.normals;
      sums.angle += std::atan2(here.cross(there).norm(), cosine);
      if (cosine < 0.0) ++sums.flipped;
    });
    return sums;
  }

  Sums measure_vertices(const std::vector<Index>& vertices, std::size_t begin, std::size_t end) const {
    Sums sums;
    Index hint = invalid_index;
    for (std::size_t i = begin; i < end; ++i) {
      const double d_sq = distance_sq(from.positions[vertices[i]] - tree.origin(), hint);
      ++sums.vertices;
      sums.vertex_sq += d_sq;
      sums.max_sq = std::max(sums.max_sq, d_sq);
    }
    return sums;
  }
};

std::vector<Index> used_vertices(const IndexedMesh& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) used[v] = true;
  }
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) vertices.push_back(static_cast<Index>(v));
  }
  return vertices;
}

/// Which faces have another side. Empty if none has.
std::vector<bool> two_sided_faces(const IndexedMesh& mesh) {
  const std::vector<Index> fronts = fronts_of_backs(mesh);
  std::vector<bool> is_two_sided(fronts.size());
  for (std::size_t back = 0; back < fronts.size(); ++back) {
    if (fronts[back] != invalid_index) is_two_sided[back] = is_two_sided[fronts[back]] = true;
  }
  return is_two_sided;
}

Sums measure(const Direction& direction, const DistanceOptions& options, std::uint64_t stream,
             const detail::Workers& workers) {
  const SurfaceSampler sampler(direction.from, direction.tree.origin(), options.samples,
                               CounterRandom(options.seed, stream));
  const std::vector<Index> vertices = used_vertices(direction.from);
  const auto blocks_of = [](std::size_t n, std::size_t size) { return (n + size - 1) / size; };
  const std::size_t sample_blocks = blocks_of(options.samples, samples_per_block);
  std::vector<Sums> blocks(sample_blocks + blocks_of(vertices.size(), vertices_per_block));
  for_each_block(blocks.size(), workers, [&](std::size_t block) {
    if (block < sample_blocks) {
      const std::size_t begin = block * samples_per_block;
      blocks[block] = direction.measure_samples(sampler, begin, std::min(begin + samples_per_block, options.samples));
    } else {
      const std::size_t begin = (block - sample_blocks) * vertices_per_block;
      blocks[block] =
          direction.measure_vertices(vertices, begin, std::min(begin + vertices_per_block, vertices.size()));
    }
  });
  Sums total;
  for (const Sums& block : blocks) total.add(block);
  return total;
}

DirectedDistance summarize(const Sums& sums) {
  DirectedDistance result;
  const auto n = static_cast<double>(sums.samples);
  result.mean = sums.distance / n;
  result.mean_sq = sums.sample_sq / n;
  result.rms = std::sqrt(result.mean_sq);
  result.max = std::sqrt(sums.max_sq);
  if (sums.normals > 0) {
    const auto n_normals = static_cast<double>(sums.normals);
    result.normal_deviation_deg = std::min(180.0, sums.angle / n_normals * (180.0 / std::numbers::pi));
    result.flipped_percent = 100.0 * static_cast<double>(sums.flipped) / n_normals;
  }
  return result;
}

DirectedDistance scaled(DirectedDistance distance, double scale) {
  distance.mean *= scale;
  distance.mean_sq *= scale * scale;
  distance.rms *= scale;
  distance.max *= scale;
  return distance;
}

SurfaceDistance scaled(SurfaceDistance distance, double scale) {
  distance.diagonal *= scale;
  distance.forward = scaled(distance.forward, scale);
  distance.backward = scaled(distance.backward, scale);
  distance.mean *= scale;
  distance.mean_sq *= scale * scale;
  distance.rms *= scale;
  distance.max *= scale;
  distance.garland_heckbert *= scale * scale;
  return distance;
}

}  // namespace

struct DistanceReference::Kept {
  Box box;
  std::optional<TriangleTree> tree;
  std::vector<bool> two_sided;  ///< as `two_sided_faces`
};

SurfaceDistance surface_distance(const IndexedMesh& reference, const IndexedMesh& test,
                                 const DistanceOptions& options) {
  return DistanceReference(reference).to(test, options);
}

SurfaceDistance DistanceReference::to(const IndexedMesh& test, const DistanceOptions& options) {
  check_samples(options.samples);
  const IndexedMesh& reference = *mesh_;
  const Box reference_box = kept_ ? kept_->box : bounds_of(reference), test_box = bounds_of(test);
  if (const double scale = working_scale({reference_box, test_box}); scale != 1.0) {
    return scaled(surface_distance(scaled(reference, scale), scaled(test, scale), options), 1.0 / scale);
  }
  if (!kept_) kept_ = std::make_shared<Kept>(Kept{reference_box, {}, two_sided_faces(reference)});
  const Vec3 origin = center_of(reference_box);
  const double noise = noise_rel * std::max(diagonal_of(reference_box), diagonal_of(test_box));
  detail::ProgressMeter meter(options.progress);
  const detail::Workers workers(options.threads, &meter);
  meter.start("building the search trees", 0.2);
  const TreePair trees(reference, test, origin, workers, meter, kept_->tree);
  const std::vector<bool> sides_of_test = two_sided_faces(test);
  const double noise_sq = noise * noise;
  meter.start("measuring", 0.6);
  const Sums forward = measure({reference, test, trees.test(), sides_of_test, noise_sq}, options, 0, workers);
  meter.start("measuring", 1);
  const Sums backward = measure({test, reference, trees.reference(), kept_->two_sided, noise_sq}, options, 1, workers);
  meter.finish();

  SurfaceDistance result;
  result.diagonal = diagonal_of(reference_box);
  result.forward = summarize(forward);
  result.backward = summarize(backward);
  result.mean = 0.5 * (result.forward.mean + result.backward.mean);
  result.mean_sq = 0.5 * (result.forward.mean_sq + result.backward.mean_sq);
  result.rms = std::sqrt(result.mean_sq);
  result.max = std::max(result.forward.max, result.backward.max);
  result.garland_heckbert =
      (forward.sample_sq + forward.vertex_sq + backward.sample_sq + backward.vertex_sq) /
      static_cast<double>(forward.samples + forward.vertices + backward.samples + backward.vertices);
  result.normal_deviation_deg = 0.5 * (result.forward.normal_deviation_deg + result.backward.normal_deviation_deg);
  result.flipped_percent = 0.5 * (result.forward.flipped_percent + result.backward.flipped_percent);
  return result;
}

}  // namespace whittle::metrics
