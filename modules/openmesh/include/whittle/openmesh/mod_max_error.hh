#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "whittle/metrics/certify.hh"
#include "whittle/openmesh/detail/error_guard.hh"
#include "whittle/openmesh/detail/mesh_proof.hh"

// A largest distance as a binary module for OpenMesh's decimaters: all points count, both ways.
//
// Beside OpenMesh's ModHausdorffT, which looks at removed vertices only:
//
//   ModHausdorffT: removed vertices of the input -> surface
//   ModMaxErrorT:  all points of the input       -> surface
//                  all points of the surface     -> input
//                  borders -> borders, both ways
//
// A collapse is refused unless all of that can be proven (certify.hh; docs/dev/certify.md has the proofs).

namespace whittle {

/// Refuses a collapse that takes a point of the surface farther than a limit from the input, or a point of the input
/// farther than the limit from the surface. The input is the mesh as it was at `initialize()`. Without a limit nothing
/// is refused.
///
/// What is promised:
///   - In `PairDecimaterT` each state of the mesh is proven to keep the limit, as the mesh has it: with its rounding.
///   - OpenMesh's own decimaters ask when a collapse is queued, not when it is made. What was asked about may have
///     changed by then, so the limit may be exceeded. `is_proven` tells whether it is kept. In them, tell the module
///     the cost module, if that is one of ours (`FaceGuardT::set_cost_module`).
///   - `certify` proves the mesh as it is, from nothing.
///
/// `PairDecimaterT` takes the limit as a target, `DecimateTarget::max_error`, if the engine driver can run and nothing
/// was contracted since `initialize()`. That is many times faster, and is proven at the end.
///
/// Edges of one face are the border. Where a non-manifold mesh was cut into copies of vertices (`vertex_copies.hh`),
/// the ends of the cuts are neither moved nor removed.
template <class MeshT>
class ModMaxErrorT : public ErrorGuardT<MeshT> {
 public:
  DECIMATING_MODULE(ModMaxErrorT, MeshT, MaxError);

  explicit ModMaxErrorT(MeshT& mesh) : ErrorGuardT<MeshT>(mesh), mesh_(mesh) {}

  /// Model units, (0, inf); empty (default) = no limit. The error tolerance factor of the decimater scales it. May be
  /// set at any time.
  /// \throw std::invalid_argument if not positive or not finite
  void set_max_error(std::optional<double> distance) { max_error_ = checked(distance); }
  std::optional<double> max_error() const override { return scaled(max_error_); }

  /// The same between the open borders of both surfaces. Empty (default) = as `max_error`. No effect without that.
  /// \throw std::invalid_argument if not positive or not finite
  void set_max_border_error(std::optional<double> distance) { max_border_error_ = checked(distance); }
  std::optional<double> max_border_error() const override {
    return max_border_error_ ? scaled(max_border_error_) : max_error();
  }

  /// Proves that the mesh as it is keeps `max_error`, or finds a point that is farther. The first mesh of the result is
  /// the input, the second one `geometry_of(mesh)`.
  /// \throw std::logic_error without a limit, or before `initialize()`. std::invalid_argument if the mesh has no faces.
  ///        Cancelled
  metrics::Certification certify(const metrics::CertifyOptions& options = {}) const {
    require_limit();
    return metrics::certify(input_, geometry_of(mesh_), *max_error(), options);
  }
  /// The same for the borders and `max_border_error`. \throw as above
  metrics::Certification certify_borders(const metrics::CertifyOptions& options = {}) const {
    require_limit();
    return metrics::certify_borders(input_, geometry_of(mesh_), *max_border_error(), options);
  }
  /// Whether the mesh as it is is proven to keep all limits by what was proven collapse by collapse. Takes no time,
  /// unless limits were set since. False doesn't say that they are exceeded. \throw std::logic_error as `certify`
  bool is_proven() override {
    require_limit();
    return proof().is_proven();
  }

  /// The mesh that errors are measured from, in model units.
  const IndexedMesh& input() const { return input_; }

  /// Proves nothing yet: `PairDecimaterT` may not ask.
  void initialize() override {
    proof_.reset();
    input_ = geometry_of(mesh_);
    is_initialized_ = true;
  }
  float collapse_priority(const CollapseInfo& collapse) override {
    const bool is_legal = !max_error_ || proof().allows(collapse, this->merged_point(collapse));
    if (!is_legal) this->count_refused();
    return static_cast<float>(is_legal ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
  }
  void preprocess_collapse(const CollapseInfo& collapse) override {
    is_told_before_ = true;
    if (max_error_) {
      proof().note_before(collapse);
    } else {
      proof_.reset();  // it doesn't follow
    }
  }
  void postprocess_collapse(const CollapseInfo& collapse) override {
    if (proof_) proof_->note_after(collapse);
    if (std::exchange(is_told_before_, false)) this->count_followed();
  }

  void note_new_surface() override { proof_.reset(); }

 private:
  static std::optional<double> checked(std::optional<double> distance) {
    if (!distance || (*distance > 0 && std::isfinite(*distance))) return distance;
    throw std::invalid_argument("ModMaxErrorT: a limit is not positive or not finite");
  }
  std::optional<double> scaled(std::optional<double> distance) const {
    if (distance) *distance *= this->error_tolerance_factor_;
    return distance;
  }
  void require_limit() const {
    if (!max_error_) throw std::logic_error("ModMaxErrorT: no limit was set");
    if (!is_initialized_) throw std::logic_error("ModMaxErrorT: not initialized");
  }
  MeshProofT<MeshT>& proof() {
    const typename MeshProofT<MeshT>::Limits limits{*max_error(), *max_border_error()};
    if (!proof_ || proof_->limits() != limits || !proof_->fits()) {
      proof_ = std::make_unique<MeshProofT<MeshT>>(mesh_, input_, limits);
    }
    return *proof_;
  }

  MeshT& mesh_;
  std::optional<double> max_error_;
  std::optional<double> max_border_error_;
  bool is_initialized_ = false;
  bool is_told_before_ = false;  ///< of a collapse under way
  IndexedMesh input_;
  std::unique_ptr<MeshProofT<MeshT>> proof_;  ///< of the mesh as it is; null before the first question
};

}  // namespace whittle
