#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "pictures/animation.hh"
#include "pictures/draw_meshes.hh"
#include "pictures/frames.hh"
#include "terminal/interruption.hh"
#include "whittle/core/progress.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle::app {

/// Pictures of a run while it goes on, under the names of those that `write_frames` makes in the end. Each shows the
/// moment at which the run passed its place: a share of the faces that are to go, as the number of contractions isn't
/// known yet. Drawing takes an eleventh of the time at most; places that are passed meanwhile get no picture. A file
/// that was there before stays. Signals stay pending meanwhile (`SignalsWait`).
class MomentPictures {
 public:
  /// Draws the first picture, of the input. \param options, plan, since_start must outlive this
  /// \pre `require_frames` \throw std::runtime_error
  MomentPictures(const FrameOptions& options, const Plan& plan, const Stopwatch& since_start);
  /// Removes the pictures, unless they are to be kept.
  ~MomentPictures();
  MomentPictures(const MomentPictures&) = delete;
  MomentPictures& operator=(const MomentPictures&) = delete;

  /// Draws a picture if a place was passed, and if it is time to. \return false, to end the run, if that failed
  bool update(const RunProgress& progress);
  /// Throws again what made `update` fail, if it did.
  void throw_if_failed() const;
  /// For files that those of the end have replaced.
  void keep() { drawn_.clear(); }

 private:
  double share_gone(std::uint64_t n_faces) const;
  void draw(IndexedMesh mesh, std::size_t i);
  void write(const std::string& path, const std::string& bytes);

  SignalsWait signals_wait_;
  const FrameOptions& options_;
  const Plan& plan_;
  const Stopwatch& since_start_;
  ShownMeshes shown_;
  PictureView view_;
  Animation animation_;
  std::vector<std::string> taken_;  ///< files that were there before
  std::vector<std::string> drawn_;
  std::size_t next_picture_ = 0;
  double next_ = 0;  ///< when to draw again, seconds since the start
  std::exception_ptr failure_;
};

}  // namespace whittle::app
