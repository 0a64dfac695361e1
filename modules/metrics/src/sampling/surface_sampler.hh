#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Samples per block. The sums of the blocks are added in order, so that the result is the same for any number of
/// threads.
inline constexpr std::size_t samples_per_block = 2048;

/// \throw std::invalid_argument unless it is in [1, 2^40]
void check_samples(std::size_t n_samples);

/// Random access to the numbers of a SplitMix64 stream (Steele, Lea, Flood: Fast Splittable Pseudorandom Number
/// Generators, 2014).
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint64_t stream) : key_(mix(mix(seed + step) + stream * step)) {}
  /// Uniform in [0, 1).
  double operator()(std::uint64_t counter) const {
    return static_cast<double>(mix(key_ + (counter + 1) * step) >> 11) * 0x1p-53;
  }

 private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio
  static constexpr std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

  std::uint64_t key_;
};

/// Spreads points evenly over the faces of a mesh. Positions are relative to an origin.
class SurfaceSampler {
 public:
  /// \param mesh must outlive the sampler
  SurfaceSampler(const IndexedMesh& mesh, const Vec3& origin, std::size_t n_samples, CounterRandom random);

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

  std::size_t n_samples() const { return n_samples_; }

 private:
  Vec3 at(Index v) const { return mesh_.positions[v] - origin_; }

  /// The point of the face as search trees have it. Of a face too thin for a normal they have the sides alone.
  Vec3 in_tree(std::size_t face, const Vec3& point) const;

  const IndexedMesh& mesh_;
  Vec3 origin_;
  std::size_t n_samples_;
  CounterRandom random_;
  std::vector<double> area_before_;  ///< F + 1; for each face the area of all faces before it.
};

}  // namespace whittle::metrics
