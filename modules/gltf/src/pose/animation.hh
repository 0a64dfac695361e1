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

/// The property of a node that an animation changes.
enum class Path : std::uint8_t { translation, rotation, scale, weights };

/// A channel of an animation.
struct Track {
  std::size_t node = 0;
  Path path = Path::translation;
  Sampler sampler;
};

struct Animation {
  std::string name;
  std::vector<Track> tracks;  ///< of nodes; extensions' tracks are left out
  double begin = 0;           ///< seconds; both are 0 without tracks
  double end = 0;
};

/// \param n_targets morph targets of each mesh. \throw io::ReadError as `Poser`
std::vector<Animation> read_animations(const Model& model, const Part& root, std::span<const std::size_t> n_targets);

/// Sets the animated part of a pose to a moment.
void animate(const Model& model, const Animation& animation, double seconds, Pose& pose);

/// `Poser::moments`.
std::vector<AnimationTime> moments(std::span<const Animation> animations, std::size_t n);

}  // namespace whittle::gltf
