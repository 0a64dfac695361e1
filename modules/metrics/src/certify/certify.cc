#include "whittle/metrics/certify.hh"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/arguments.hh"
#include "certify/proof_text.hh"
#include "certify/recorded.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/proof/face_limits.hh"
#include "whittle/core/geometry/proof/prover.hh"
#include "whittle/core/geometry/proof/target_surface.hh"

namespace whittle::metrics {
namespace {

/// Faces per block of a thread, and per chunk of a certificate. Their proofs are independent of other blocks.
constexpr std::size_t most_faces_per_block = 1024;

/// The same of `n` faces where no certificate is written: a few long ones may take as long as a thousand others.
std::size_t faces_per_block(std::size_t n) {
  constexpr std::size_t n_blocks = 64;
  return std::clamp<std::size_t>(n / n_blocks, 16, most_faces_per_block);
}

/// Pieces of a triangle that are looked at, once one of the block is undecided: then a point that is farther is all
/// that counts, and it is found among the first.
constexpr int most_pieces_after_undecided = 64;

/// A surface whose points may be far from another one.
struct OneWay {
  const IndexedMesh& mesh;
  const TargetSurface& target;
  const Frame& frame;
  bool is_first;
  std::span<const double> limits{};  ///< of each face, in the frame; or empty
  std::span<const Index> hints{};    ///< a face of the target that may be near to each face; or empty
  std::size_t block_size = faces_per_block(mesh.faces.size());

  std::size_t n_blocks() const { return (mesh.faces.size() + block_size - 1) / block_size; }
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
    const std::size_t end = std::min(mesh.faces.size(), (block + 1) * block_size);
    for (auto f = static_cast<Index>(block * block_size); f < end && use(f); ++f) {
    }
  }
};

/// Two surfaces in one frame.
class Surfaces {
 public:
  /// \param tolerances of the first surface's vertices, or empty \param most of them counts; model units
  Surfaces(const IndexedMesh& first, const IndexedMesh& second, whittle::detail::ProgressMeter& meter,
           std::span<const double> tolerances = {}, double most = 0)
      : meshes_{first, second},
        frame_(frame_of(bounds_of(first), bounds_of(second))),
        limits_(face_limits(first.faces, tolerances, most)) {
    for (double& of_face : limits_) of_face *= frame_.scale;
    meter.start("preparing", 0.1);
    first_.emplace(first, frame_, limits_, most * frame_.scale);
    second_.emplace(second, frame_);
  }

  void build_trees(whittle::detail::ProgressMeter& meter) const {
    meter.start("preparing", 0.2);
    first_->build_tree(&meter);
    second_->build_tree(&meter);
  }

  const Frame& frame() const { return frame_; }
  OneWay forward() const { return {meshes_.first, *second_, frame_, true, limits_}; }
  OneWay backward() const { return {meshes_.second, *first_, frame_, false}; }

 private:
  static Frame frame_of(const Box& a, const Box& b) { return Frame::of_box(a.merged(b)); }

  std::pair<const IndexedMesh&, const IndexedMesh&> meshes_;
  Frame frame_;
  std::vector<double> limits_;  ///< of the first surface's faces, in the frame
  std::optional<TargetSurface> first_;
  std::optional<TargetSurface> second_;
};

/// A face of another mesh that may be near to each face. \param vertex_map vertices → vertices of the other mesh
std::vector<Index> hints_by(std::span<const Index> vertex_map, const IndexedMesh& mesh, const IndexedMesh& other) {
  const std::vector<Index> at_vertices = face_at_each_vertex(other.faces, other.positions.size());
  std::vector<Index> hints(mesh.faces.size(), invalid_index);
  for (std::size_t f = 0; f < hints.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      if (vertex_map[v] != invalid_index) hints[f] = at_vertices[vertex_map[v]];
    }
  }
  return hints;
}

/// For each vertex of the second mesh, one vertex of the first that became it.
std::vector<Index> inverse(std::span<const Index> vertex_map, std::size_t n_second) {
  std::vector<Index> map(n_second, invalid_index);
  for (Index v = 0; v < vertex_map.size(); ++v) {
    if (vertex_map[v] != invalid_index) map[vertex_map[v]] = v;
  }
  return map;
}

/// The first block with a farther point counts. Later blocks needn't end.
/// \param section the steps of the proof are appended; may be null
Certification certify_one_way(const OneWay& one_way, double distance, const whittle::detail::Workers& workers,
                              std::string* section) {
  std::vector<Certification> of_blocks(one_way.n_blocks());
  std::vector<ProofText> texts(section != nullptr ? of_blocks.size() : 0);
  std::atomic<std::size_t> first_refuted{of_blocks.size()};
  for_each_block(of_blocks.size(), workers, [&](std::size_t block) {
    Certification& found = of_blocks[block];
    found.verdict = Verdict::proven;
    auto prover = std::make_unique<Prover>(one_way.target);
    one_way.for_each_face_of(block, [&](Index face) {
      if (first_refuted < block) return false;
      FarthestPoint farthest;
      const double limit = one_way.limits.empty() ? distance : one_way.limits[face];
      const Index hint = one_way.hints.empty() ? invalid_index : one_way.hints[face];
      const Verdict verdict = prover->prove(one_way.corners(face), limit, hint, farthest);
      if (verdict == Verdict::proven) {
        if (section != nullptr) texts[block].add(prover->steps());
        return true;
      }
      found.verdict = verdict;
      if (verdict == Verdict::undecided) {
        prover = std::make_unique<Prover>(one_way.target, most_pieces_after_undecided);
        return true;
      }
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
  for (const ProofText& text : texts) {
    append_varint(text.bytes().size(), *section);
    *section += text.bytes();
  }
  return result;
}

/// What is nearest to each vertex of the faces. `invalid_index` for others.
std::vector<NearFace> nearest_to_vertices(const OneWay& one_way, const whittle::detail::Workers& workers) {
  std::vector<std::uint8_t> is_corner(one_way.mesh.positions.size());
  for (const Triangle& face : one_way.mesh.faces) {
    for (const Index v : face) is_corner[v] = 1;
  }
  std::vector<NearFace> nearest(is_corner.size());
  const std::size_t size = faces_per_block(nearest.size());
  for_each_block((nearest.size() + size - 1) / size, workers, [&](std::size_t block) {
    Index hint = invalid_index;
    const std::size_t end = std::min(nearest.size(), (block + 1) * size);
    for (std::size_t v = block * size; v < end; ++v) {
      if (is_corner[v] == 0) continue;
      nearest[v] = one_way.target.nearest(one_way.frame.to_frame(one_way.mesh.positions[v]), hint);
      hint = nearest[v].face;
    }
  });
  return nearest;
}

/// The farthest point that was found, and a bound for all points.
struct FoundFarthest {
  FarthestPoint farthest;
  Index face = invalid_index;
  double at_most = 0;

  void take(Index its_face, const FarthestPoint& point) {
    if (point.distance > farthest.distance) farthest = point, face = its_face;
  }
  void add(const FoundFarthest& other) {
    take(other.face, other.farthest);
    at_most = std::max(at_most, other.at_most);
  }
};

/// The first face that has the farthest point counts.
/// \param limit as that of the options, in the frame
LargestDistance largest_one_way(const OneWay& one_way, double accuracy, double limit,
                                const whittle::detail::Workers& workers) {
  const std::vector<NearFace> nearest = nearest_to_vertices(one_way, workers);
  FoundFarthest all;
  const std::vector<Triangle>& faces = one_way.mesh.faces;
  std::vector<double> at_corners(faces.size());
  for (Index f = 0; f < faces.size(); ++f) {
    for (const Index v : faces[f]) {
      at_corners[f] = std::max(at_corners[f], nearest[v].distance);
      all.take(f, {one_way.frame.to_frame(one_way.mesh.positions[v]), nearest[v].distance});
    }
  }
  const double at_vertices = all.farthest.distance;
  std::vector<FoundFarthest> of_blocks(one_way.n_blocks());
  for_each_block(of_blocks.size(), workers, [&](std::size_t block) {
    Prover prover(one_way.target);
    FoundFarthest& found = of_blocks[block];
    one_way.for_each_face_of(block, [&](Index face) {
      FarthestPoint farthest;
      const Index hint = nearest[faces[face][0]].face;
      found.at_most = std::max(
          found.at_most, prover.find_farthest(one_way.corners(face), at_vertices, accuracy, limit, hint, farthest));
      found.take(face, farthest);
      return true;
    });
  });
  for (const FoundFarthest& found : of_blocks) all.add(found);
  const FarPoint where = one_way.far_point(all.face, all.farthest);
  const auto n_far = std::count_if(at_corners.begin(), at_corners.end(),
                                   [&](double distance) { return distance > 0.9 * all.farthest.distance; });
  return {where.distance, all.at_most * one_way.frame.unscale, where, static_cast<std::size_t>(n_far)};
}

}  // namespace

void require_distance(double max_distance) {
  if (!(max_distance >= 0)) throw std::invalid_argument("certify: max_distance is negative, or not a number");
}

void require_tolerances(std::span<const double> tolerances, std::size_t n_vertices, double max_distance) {
  if (!tolerances.empty() && std::isinf(max_distance)) {
    throw std::invalid_argument("certify: there are tolerances, but max_distance is infinite");
  }
  if (!tolerances.empty() && tolerances.size() != n_vertices) {
    throw std::invalid_argument("certify: tolerances has another length than the vertices");
  }
  if (!std::all_of(tolerances.begin(), tolerances.end(), [](double tolerance) { return tolerance > 0; })) {
    throw std::invalid_argument("certify: a tolerance is 0 or less, or not a number");
  }
}

void require_vertex_map(std::span<const Index> vertex_map, std::size_t n_first, std::size_t n_second) {
  const auto is_known = [n_second](Index v) { return v == invalid_index || v < n_second; };
  if (vertex_map.size() == n_first && std::all_of(vertex_map.begin(), vertex_map.end(), is_known)) return;
  throw std::invalid_argument(
      "certify: vertex_map has another length than the vertices, or names one that isn't there");
}

void require_accuracy(double relative_accuracy) {
  constexpr double least = 1e-6;
  if (relative_accuracy >= least && relative_accuracy <= 1) return;
  throw std::invalid_argument("largest_distances: relative_accuracy is not in [1e-6, 1]");
}

Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options) {
  return certify(first, second, max_distance, options, nullptr);
}

Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options, std::string* sections) {
  require_distance(max_distance);
  require_tolerances(options.tolerances, first.positions.size(), max_distance);
  whittle::detail::ProgressMeter meter(options.progress);
  const whittle::detail::Workers workers(options.threads, &meter);
  const Surfaces surfaces(first, second, meter, options.tolerances, max_distance);
  const double distance = max_distance * surfaces.frame().scale;
  OneWay forward_way = surfaces.forward();
  OneWay backward_way = surfaces.backward();
  if (sections != nullptr) forward_way.block_size = backward_way.block_size = most_faces_per_block;
  std::vector<Index> forward_hints;
  std::vector<Index> backward_hints;
  if (options.vertex_map.empty()) {
    surfaces.build_trees(meter);
  } else {
    require_vertex_map(options.vertex_map, first.positions.size(), second.positions.size());
    forward_way.hints = forward_hints = hints_by(options.vertex_map, first, second);
    backward_way.hints = backward_hints = hints_by(inverse(options.vertex_map, second.positions.size()), second, first);
  }
  meter.start("proving, forward", 0.6);
  Certification forward = certify_one_way(forward_way, distance, workers, sections);
  if (forward.verdict == Verdict::refuted) return forward;
  meter.start("proving, backward", 1);
  Certification backward = certify_one_way(backward_way, distance, workers, sections);
  meter.finish();
  return backward.verdict == Verdict::proven ? forward : backward;
}

LargestDistances largest_distances(const IndexedMesh& first, const IndexedMesh& second, double relative_accuracy,
                                   const LargestDistanceOptions& options) {
  require_accuracy(relative_accuracy);
  whittle::detail::ProgressMeter meter(options.progress);
  const whittle::detail::Workers workers(options.threads, &meter);
  const Surfaces surfaces(first, second, meter);
  surfaces.build_trees(meter);
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
