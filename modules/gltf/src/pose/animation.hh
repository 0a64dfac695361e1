#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "document/json.hh"
#include "model/model.hh"
#include "pose/sampler.hh"
#include "whittle/gltf/pose.hh"

namespace whittle::gltf {

/// What of a node an animation changes.
enum class Path : std::uint8_t { translation, rotation, scale, weights };

/// A channel of an animation.
struct Track {
  std::size_t node = 0;
  Path path = Path::translation;
  Sampler sampler;
};

struct Animation {
  std::string name;
  std::vector<Track> tracks;  ///< those of nodes; what extensions animate is left out
  double begin = 0;           ///< seconds; both are 0 without tracks
  double end = 0;
};

/// \param n_targets morph targets of each mesh. \throw io::ReadError as `Poser`
std::vector<Animation> read_animations(const Model& model, const Part& root, std::span<const std::size_t> n_targets);

/// Changes a pose to that of a moment, but for what the animation doesn't touch.
void animate(const Model& model, const Animation& animation, double seconds, Pose& pose);

/// `Poser::moments`.
std::vector<AnimationTime> moments(std::span<const Animation> animations, std::size_t n);

}  // namespace whittle::gltf
