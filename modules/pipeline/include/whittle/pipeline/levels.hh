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

/// What the levels of detail of a scene are asked to have: one of these.
struct LevelTargets {
  std::vector<double> ratios{};        ///< shares of the vertices, (0, 1)
  std::vector<double> face_ratios{};   ///< shares of the faces, (0, 1)
  std::vector<std::uint64_t> faces{};  ///< numbers of faces, from 1 on
  std::vector<Length> errors{};        ///< proven distances from the scene, and of the scene from the level; above 0

  int n_kinds() const {
    return int{!ratios.empty()} + int{!face_ratios.empty()} + int{!faces.empty()} + int{!errors.empty()};
  }
};

struct Level {
  Simplification simplified;
  std::optional<double> error;  ///< that is proven, model units
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
