// Both surfaces are sampled in blocks. The result of a block depends on its number alone: random numbers are a function
// of a counter, and no state is carried from block to block. The blocks are summed in order. So the result is the same
// for any number of threads.
#include "whittle/metrics/distance.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "noise.hh"
#include "triangle_math.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/metrics/bounds.hh"
#include "whittle/metrics/closest_point.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

constexpr std::size_t samples_per_block = 2048;
constexpr std::size_t vertices_per_block = 2048;
constexpr std::size_t max_samples = std::size_t{1} << 40;

/// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Random access to the numbers of a SplitMix64 stream.
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint64_t stream) : key_(mix(mix(seed + step) + stream * step)) {}
  /// Uniform in [0, 1).
  double operator()(std::uint64_t counter) const {
    return static_cast<double>(mix(key_ + (counter + 1) * step) >> 11) * 0x1p-53;
  }

 private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio
  std::uint64_t key_;
};

/// Spreads points evenly over the faces of a mesh. Positions are relative to an origin.
class SurfaceSampler {
 public:
  SurfaceSampler(const IndexedMesh& mesh, const Vec3& origin, std::size_t n_samples, CounterRandom random)
      : mesh_(mesh), origin_(origin), n_samples_(n_samples), random_(random), area_before_(mesh.faces.size() + 1, 0.0) {
    for (const bool by_area : {true, false}) {
      for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto [a, b, c] = corners(f);
        area_before_[f + 1] = area_before_[f] + (by_area ? (b - a).cross(c - a).norm() : 1.0);
      }
      if (area_before_.back() > 0.0) break;
    }
  }

  /// Corners of a face, relative to the origin.
  std::array<Vec3, 3> corners(std::size_t face) const {
    const auto [a, b, c] = mesh_.faces[face];
    return {at(a), at(b), at(c)};
  }

  /// Calls `visit(face, point)` for samples begin … end − 1, in the order of the faces. Sample i is a random point in
  /// the i-th of `n_samples` equal parts of the area.
  template <class Visitor>
  void for_each(std::size_t begin, std::size_t end, const Visitor& visit) const {
    const double part = area_before_.back() / static_cast<double>(n_samples_);
    const std::size_t last = mesh_.faces.size() - 1;
    const auto after = std::upper_bound(area_before_.begin(), area_before_.end(), static_cast<double>(begin) * part);
    std::size_t face =
        std::min(last, static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - area_before_.begin(), 1)) - 1);
    for (std::size_t i = begin; i < end; ++i) {
      const double area = (static_cast<double>(i) + random_(3 * i)) * part;
      while (face < last && area_before_[face + 1] <= area) ++face;
      const double u = std::sqrt(random_(3 * i + 1)), v = random_(3 * i + 2);
      const auto [a, b, c] = corners(face);
      visit(face, in_tree(face, Vec3((1.0 - u) * a + (u * (1.0 - v)) * b + (u * v) * c)));
    }
  }

 private:
  Vec3 at(Index v) const { return mesh_.positions[v] - origin_; }

  /// The point of the face as search trees have it. Of a face too thin for a normal they have the sides alone.
  Vec3 in_tree(std::size_t face, const Vec3& point) const {
    Triangle ascending = mesh_.faces[face];  // as trees have it
    std::sort(ascending.begin(), ascending.end());
    const Vec3 a = at(ascending[0]), b = at(ascending[1]), c = at(ascending[2]);
    if (!trusted_normal(a, b, c).isZero(0.0)) return point;
    Vec3 from = a, to = b;
    for (const auto& [p, q] : {std::pair(b, c), std::pair(c, a)}) {
      if ((q - p).squaredNorm() > (to - from).squaredNorm()) from = p, to = q;
    }
    const Vec3 side = to - from;
    const double length_sq = side.squaredNorm();
    return length_sq > 0.0 ? Vec3(from + std::clamp((point - from).dot(side) / length_sq, 0.0, 1.0) * side) : from;
  }

  const IndexedMesh& mesh_;
  Vec3 origin_;
  std::size_t n_samples_;
  CounterRandom random_;
  std::vector<double> area_before_;  ///< F + 1; for each face twice the area of all faces before it.
};

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
  double noise_sq;

  double distance_sq(const Vec3& point, Index& hint) const {
    const ClosestPoint nearest = tree.nearest_local(point, hint);
    hint = nearest.face;
    return nearest.distance_sq > noise_sq ? nearest.distance_sq : 0.0;
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
      const Vec3 here = unit_normal(from, face), there = unit_normal(to, hint);
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

/// Runs two tasks at the same time if there are threads. The calling thread reports until both are done.
template <class First, class Second>
void build_side_by_side(const detail::Workers& workers, const First& first, const Second& second) {
  std::future<void> other;
  if (workers.threads != 1) {
    try {
      other = std::async(std::launch::async, second);
    } catch (const std::system_error&) {
      // The system has no more threads.
    }
  }
  first();
  if (!other.valid()) return second();
  while (other.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) workers.update(1);
  other.get();
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

SurfaceDistance surface_distance(const IndexedMesh& reference, const IndexedMesh& test,
                                 const DistanceOptions& options) {
  if (options.samples < 1 || options.samples > max_samples) {
    throw std::invalid_argument("number of samples is to be in 1 ... 2^40, not " + std::to_string(options.samples));
  }
  const Bounds reference_box = bounds(reference), test_box = bounds(test);
  if (const double scale = working_scale({reference_box, test_box}); scale != 1.0) {
    return scaled(surface_distance(scaled(reference, scale), scaled(test, scale), options), 1.0 / scale);
  }
  const Vec3 origin = reference_box.center();
  const double noise = noise_rel * std::max(reference_box.diagonal(), test_box.diagonal());
  detail::ProgressMeter meter(options.progress);
  const detail::Workers workers(options.threads, &meter);
  meter.start("building the search trees", 0.2);
  std::optional<TriangleTree> reference_tree, test_tree;
  build_side_by_side(
      workers, [&] { reference_tree.emplace(reference, origin, &meter); },
      [&] { test_tree.emplace(test, origin, &meter); });
  meter.start("measuring", 0.6);
  const Sums forward = measure({reference, test, *test_tree, noise * noise}, options, 0, workers);
  meter.start("measuring", 1);
  const Sums backward = measure({test, reference, *reference_tree, noise * noise}, options, 1, workers);
  meter.finish();

  SurfaceDistance result;
  result.diagonal = reference_box.diagonal();
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
