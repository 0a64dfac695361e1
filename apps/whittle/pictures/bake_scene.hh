#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/core/progress.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::app {

/// The range of `BakeSettings::texture_size`.
inline constexpr std::size_t least_texture_size = 16;
inline constexpr std::size_t largest_texture_size = 8192;

/// The options of `bake::bake`.
struct BakeSettings {
  std::optional<std::size_t> texture_size;  ///< a power of two
  bool makes_normal_map = true;
  unsigned threads = 0;
  ProgressCallback progress{};
};

struct BakedScene {
  gltf::Asset asset;
  std::size_t n_vertices = 0, n_faces = 0;
  std::size_t texture_size = 0, n_charts = 0;
  bool has_normal_map = false;
  double missed_share = 0;  ///< of the places that were looked up, [0, 1]
  std::vector<std::string> warnings;
};

/// Bakes the colours of a file onto the surface of another one.
/// \param coarse with at least one face \pre `require_pictures`
/// \throw UnsupportedMesh for a detailed file without colours, or with a look that isn't baked, and if it is elsewhere
///        than the coarse one; io::ReadError for an invalid material; Cancelled
BakedScene bake_scene(const Scene& detailed, const Scene& coarse, const BakeSettings& settings);

}  // namespace whittle::app
