#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "files/input.hh"
#include "terminal/progress_bar.hh"
#include "whittle/gltf/pose.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::app {

/// Mean distances of two surfaces, model units.
struct MeanDistance {
  double both = 0;  ///< the mean of both directions
  double forward = 0;
  double backward = 0;
};

/// The distance between two posed scenes.
struct PosedDistance {
  std::size_t n_poses = 0;
  double diagonal = 0;                              ///< of the reference's scene at rest, model units
  MeanDistance rest;                                ///< without animation
  MeanDistance average;                             ///< mean of the poses
  MeanDistance worst;                               ///< of the pose with the largest one, both ways
  std::size_t worst_pose = 0;                       ///< from 0 on
  std::optional<gltf::AnimationTime> worst_moment;  ///< none if the file has no animation
  std::string worst_animation;                      ///< its name

  /// The average over the distance at rest, both ways. None if that is 0.
  std::optional<double> ratio() const;
};

/// Two glTF scenes that are posed alike: by the animations, or, where there is none, by turning joints and blending
/// morph targets.
class PosedScenes {
 public:
  /// \param reference, test are glTF files, and must outlive the scenes
  /// \throw io::ReadError as `gltf::Poser`
  /// \throw UnsupportedMesh if a file has neither skin nor morph target, or both differ in nodes or animations
  PosedScenes(const Scene& reference, const Scene& test);

  /// Measures in `n_poses` poses, and at rest. \param options but for the progress \param n_poses at least 1
  PosedDistance measure(std::size_t n_poses, metrics::DistanceOptions options, ProgressBar& bar) const;

 private:
  /// \param moment none: the artificial pose of that number
  metrics::SurfaceDistance distance(const std::optional<gltf::AnimationTime>& moment, std::size_t number,
                                    const metrics::DistanceOptions& options) const;

  gltf::Poser reference_;
  gltf::Poser test_;
};

}  // namespace whittle::app
