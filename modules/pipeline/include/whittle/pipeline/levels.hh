#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "whittle/scene/format.hh"
#include "whittle/scene/length.hh"
#include "whittle/scene/scene.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// A camera's view, and the largest error that may be seen in it.
struct CameraView {
  double target_pixels = 1;  ///< largest error on the screen, pixels, above 0
  double height = 1080;      ///< of the view, pixels, above 0
  double fov_deg = 60;       ///< vertical field of view, degrees, (0, 180)

  /// The largest error over the distance of the camera: 2 tan(fov / 2) target_pixels / height. So the error in pixels
  /// is error * height / (2 distance tan(fov / 2)), as in Luebke et al.: Level of Detail for 3D Graphics (2003).
  double error_over_distance() const;
  /// The largest error as a share of the view's height.
  double error_rel() const { return target_pixels / height; }
};

/// What the levels of detail of a scene are asked to have: one of these.
struct LevelTargets {
  std::vector<double> ratios{};        ///< shares of the vertices, (0, 1)
  std::vector<double> face_ratios{};   ///< shares of the faces, (0, 1)
  std::vector<std::uint64_t> faces{};  ///< numbers of faces, from 1 on
  std::vector<Length> errors{};        ///< proven distances from the scene, and of the scene from the level; above 0

  /// Distances of the camera, above 0, from which the proven error of a level is at most `view.target_pixels`.
  std::vector<Length> distances{};
  CameraView view{};  ///< of `distances`

  int n_kinds() const {
    return int{!ratios.empty()} + int{!face_ratios.empty()} + int{!faces.empty()} + int{!errors.empty()} +
           int{!distances.empty()};
  }
};

struct Level {
  Simplification simplified;
  std::optional<double> error;     ///< that is proven, model units
  std::optional<double> distance;  ///< of the camera, for which the level was asked, model units
};

struct Levels {
  std::vector<Level> levels;          ///< the finest first: one for each target, fewer if the run can't go on
  std::vector<std::string> warnings;  ///< a line each, with the name of the scene in front
};

/// Makes levels of detail out of one run, the finest first.
/// \param options for all levels; targets and pauses aside
/// \param output of a level: proofs are about the mesh as read from there
/// \param reading with which the scene was read
/// \throw std::invalid_argument unless targets of one kind are given and in range, or if the scene hasn't more faces
///        than a number
/// \throw Cancelled; and as `simplify_to_levels` and `progressive::levels_within`
Levels make_levels(const Scene& scene, const LevelTargets& targets, Effort effort, const SimplifyOptions& options,
                   const SceneOutput& output, const SceneReadOptions& reading);

}  // namespace whittle
