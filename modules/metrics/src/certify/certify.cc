#include "whittle/metrics/certify.hh"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "certify/arguments.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/metrics/bounds.hh"
#include "whittle/metrics/detail/prover.hh"
#include "whittle/metrics/detail/target_surface.hh"

namespace whittle::metrics {
namespace {

/// Faces that a thread takes at a time. What is found for them depends on no others.
constexpr std::size_t faces_per_block = 1024;

/// A surface whose points may be far from another one.
struct OneWay {
  const IndexedMesh& mesh;
  const TargetSurface& target;
  const Frame& frame;
  bool is_first;

  std::size_t n_blocks() const { return (mesh.faces.size() + faces_per_block - 1) / faces_per_block; }
  Corners corners(Index face) const {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = frame.to_frame(mesh.positions[mesh.faces[face][i]]);
    return corners;
  }
  FarPoint far_point(Index face, const FarthestPoint& farthest) const {
    return {is_first, face, frame.to_model(farthest.point), farthest.distance * frame.unscale};
  }
  template <class Use>
  void for_each_face_of(std::size_t block, const Use& use) const {
    const std::size_t end = std::min(mesh.faces.size(), (block + 1) * faces_per_block);
    for (auto f = static_cast<Index>(block * faces_per_block); f < end && use(f); ++f) {
    }
  }
};

/// Two surfaces in one frame.
class Surfaces {
 public:
  Surfaces(const IndexedMesh& first, const IndexedMesh& second, whittle::detail::ProgressMeter& meter)
      : meshes_{first, second}, frame_(frame_of(bounds(first), bounds(second))) {
    meter.start("preparing", 0.1);
    first_.emplace(first, frame_);
    first_->build_tree(&meter);
    meter.start("preparing", 0.2);
    second_.emplace(second, frame_);
    second_->build_tree(&meter);
  }

  const Frame& frame() const { return frame_; }
  OneWay forward() const { return {meshes_.first, *second_, frame_, true}; }
  OneWay backward() const { return {meshes_.second, *first_, frame_, false}; }

 private:
  static Frame frame_of(const Bounds& a, const Bounds& b) {
    return Frame::of_box(a.min.cwiseMin(b.min), a.max.cwiseMax(b.max));
  }

  std::pair<const IndexedMesh&, const IndexedMesh&> meshes_;
  Frame frame_;
  std::optional<TargetSurface> first_;
  std::optional<TargetSurface> second_;
};

/// Of the blocks in which a point is farther, the first one counts. Those after it needn't end.
Certification certify_one_way(const OneWay& one_way, double distance, const whittle::detail::Workers& workers) {
  std::vector<Certification> of_blocks(one_way.n_blocks());
  std::atomic<std::size_t> first_refuted{of_blocks.size()};
  for_each_block(of_blocks.size(), workers, [&](std::size_t block) {
    Certification& found = of_blocks[block];
    found.verdict = Verdict::proven;
    Prover prover(one_way.target);
    one_way.for_each_face_of(block, [&](Index face) {
      if (first_refuted < block) return false;
      FarthestPoint farthest;
      const Verdict verdict = prover.prove(one_way.corners(face), distance, invalid_index, farthest);
      if (verdict == Verdict::proven) return true;
      found.verdict = verdict;
      if (verdict == Verdict::undecided) return true;
      found.farther = one_way.far_point(face, farthest);
      std::size_t before = first_refuted;
      while (block < before && !first_refuted.compare_exchange_weak(before, block)) {
      }
      return false;
    });
  });
  Certification result{Verdict::proven, {}};
  for (const Certification& found : of_blocks) {
    if (found.verdict == Verdict::refuted) return found;
    if (found.verdict == Verdict::undecided) result.verdict = Verdict::undecided;
  }
  return result;
}

/// The distance of the farthest vertex, and the first face that has it.
/// \param limit as that of the options, in the frame
LargestDistance largest_one_way(const OneWay& one_way, double accuracy, double limit,
                                const whittle::detail::Workers& workers) {
  struct Found {
    FarthestPoint farthest;
    Index face = invalid_index;
    double at_most = 0;
  };
  std::vector<Found> of_blocks(one_way.n_blocks());
  const auto take = [](Found& found, Index face, const FarthestPoint& farthest) {
    if (farthest.distance > found.farthest.distance) found = {farthest, face, found.at_most};
  };
  const auto farthest_of_all = [&] {
    Found all;
    for (const Found& found : of_blocks) {
      take(all, found.face, found.farthest);
      all.at_most = std::max(all.at_most, found.at_most);
    }
    return all;
  };
  for_each_block(of_blocks.size(), workers, [&](std::size_t block) {
    Index hint = invalid_index;
    one_way.for_each_face_of(block, [&](Index face) {
      for (const Vec3& corner : one_way.corners(face)) {
        const NearFace near = one_way.target.nearest(corner, hint);
        hint = near.face;
        take(of_blocks[block], face, {corner, near.distance});
      }
      return true;
    });
  });
  const double at_vertices = farthest_of_all().farthest.distance;
  for_each_block(of_blocks.size(), workers, [&](std::size_t block) {
    Prover prover(one_way.target);
    one_way.for_each_face_of(block, [&](Index face) {
      FarthestPoint farthest;
      const double at_most =
          prover.find_farthest(one_way.corners(face), at_vertices, accuracy, limit, invalid_index, farthest);
      of_blocks[block].at_most = std::max(of_blocks[block].at_most, at_most);
      take(of_blocks[block], face, farthest);
      return true;
    });
  });
  const Found all = farthest_of_all();
  const FarPoint where = one_way.far_point(all.face, all.farthest);
  return {where.distance, all.at_most * one_way.frame.unscale, where};
}

}  // namespace

void require_distance(double max_distance) {
  if (!(max_distance >= 0)) throw std::invalid_argument("certify: max_distance is negative, or not a number");
}

void require_accuracy(double relative_accuracy) {
  constexpr double least = 1e-6;
  if (relative_accuracy >= least && relative_accuracy <= 1) return;
  throw std::invalid_argument("largest_distances: relative_accuracy is not in [1e-6, 1]");
}

Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options) {
  require_distance(max_distance);
  whittle::detail::ProgressMeter meter(options.progress);
  const whittle::detail::Workers workers(options.threads, &meter);
  const Surfaces surfaces(first, second, meter);
  const double distance = max_distance * surfaces.frame().scale;
  meter.start("proving, forward", 0.6);
  Certification forward = certify_one_way(surfaces.forward(), distance, workers);
  if (forward.verdict == Verdict::refuted) return forward;
  meter.start("proving, backward", 1);
  Certification backward = certify_one_way(surfaces.backward(), distance, workers);
  meter.finish();
  return backward.verdict == Verdict::proven ? forward : backward;
}

LargestDistances largest_distances(const IndexedMesh& first, const IndexedMesh& second, double relative_accuracy,
                                   const LargestDistanceOptions& options) {
  require_accuracy(relative_accuracy);
  whittle::detail::ProgressMeter meter(options.progress);
  const whittle::detail::Workers workers(options.threads, &meter);
  const Surfaces surfaces(first, second, meter);
  const double limit = options.limit * surfaces.frame().scale;
  LargestDistances result;
  meter.start("measuring, forward", 0.6);
  result.forward = largest_one_way(surfaces.forward(), relative_accuracy, limit, workers);
  meter.start("measuring, backward", 1);
  result.backward = largest_one_way(surfaces.backward(), relative_accuracy, limit, workers);
  meter.finish();
  return result;
}

}  // namespace whittle::metrics
