#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "fit/fit_weights.hh"
#include "fit/two_sided_error.hh"
#include "guard/face_limits.hh"
#include "original/backward_offsets.hh"
#include "original/origins.hh"
#include "surface/face_neighbors.hh"
#include "surface/line_samples.hh"
#include "surface/mesh_lines.hh"
#include "surface/vertex_corners.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/frame.hh"
#include "whittle/polish/polish.hh"

namespace whittle::polishing {

/// The faces of a mesh, and all that depends on them alone. The members refer to each other.
struct Connectivity {
  std::vector<Triangle> faces;
  VertexCorners corners;
  FaceNeighbors neighbors;
  FaceLimits limits;

  /// \throw Cancelled
  Connectivity(std::vector<Triangle> the_faces, std::size_t n_vertices, const PolishOptions& options,
               const detail::Workers& workers);
  Connectivity(const Connectivity&) = delete;
  Connectivity& operator=(const Connectivity&) = delete;

  Surface at(std::span<const Vec3> positions) const { return {faces, corners, positions}; }
};

/// Fraction of the whole run that is done after the preparations and `n_passes` passes, which may end in a fraction.
double run_fraction(double n_passes, const PolishOptions& options);

/// One run of `polish`, in the frame of the original.
class Polisher {
 public:
  /// Keeps references to all but `mesh`.
  /// \throw Cancelled
  Polisher(const OriginalSurface& original, std::span<const Index> vertex_map, const IndexedMesh& mesh,
           const PolishOptions& options, detail::ProgressMeter& meter);

  /// \return whether it reduced the error; if not, nothing has changed
  /// \throw Cancelled; nothing has changed then
  bool pass();

  /// Root mean square distance between the surfaces, model units.
  double rms() const { return root_mean_square(distances_) * original_.frame().unscale; }

  /// \return number of vertices with a new position
  std::uint64_t write(IndexedMesh& mesh) const;

 private:
  MeshLines original_lines() const;
  /// Begins a stage of the current pass, unless it was begun before. \param until share of the pass at its end
  void start(std::string_view stage, double until);
  std::unique_ptr<Connectivity> flip();
  void take_back(const Connectivity& mesh, const BackwardOffsets& backward, double most, std::vector<Vec3>& moved);

  const PolishOptions& options_;
  detail::ProgressMeter& meter_;
  detail::Workers workers_;
  const OriginalSurface& original_;
  std::vector<Vec3> positions_;
  Origins origins_;
  std::unique_ptr<Connectivity> mesh_;
  MeshLines lines_;
  LineSamples line_samples_;
  std::vector<std::uint8_t> is_fixed_;
  bool can_flip_;
  unsigned n_passes_ = 0;   ///< begun
  double begun_until_ = 0;  ///< share of the pass at the end of the stage begun last
  Distances distances_;
};

}  // namespace whittle::polishing
