#pragma once

#include <cstddef>
#include <optional>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"
#include "whittle/render/picture.hh"
#include "whittle/render/scene.hh"

// Bakes the look of a surface: colours and normals of a detailed mesh onto a coarse one, by new texture coordinates.

namespace whittle::bake {

inline constexpr std::size_t least_texture_size = 16;
inline constexpr std::size_t largest_texture_size = 8192;

struct BakeOptions {
  /// Texels along a side of the images: a power of two from `least_texture_size` to `largest_texture_size`. Default:
  /// as many texels on the coarse mesh as the detailed one has, or as it has faces if only vertices have colours, at
  /// most 4096.
  std::optional<std::size_t> texture_size{};
  bool makes_normal_map = true;
  /// Farthest place to take a colour from, a share of the diagonal of the detailed mesh's bounding box, above 0.
  double reach_rel = 0.02;
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
  ProgressCallback progress{};
};

struct Baked {
  /// Positions and faces of the coarse mesh, in its order, with its normals, or those of vertices; and the attributes
  /// TEXCOORD_0, and TANGENT if there is a normal map (glTF 2.0, section 3.7.2). No other attributes, no groups.
  IndexedMesh mesh;
  render::Picture base_color;
  std::optional<render::Picture> normal_map;  ///< in tangent space, of the detailed mesh's normals (section 3.9.3)
  std::size_t n_charts = 0;
  std::size_t n_samples = 0;  ///< places on the coarse mesh that were looked up
  std::size_t n_missed = 0;   ///< of these, places without a surface that faces the same way within reach
};

/// Bakes the base colours of a scene onto a mesh: texture times factor times vertex colour, opacity aside. Each place
/// of the mesh gets the look of the nearest place of the scene that faces the same way, within reach; of the nearest
/// one at all if there is none. A texel is the mean, in linear light, of 1 to 16 places, about one for each texel of
/// the scene. Texels between the charts get the colours of their neighbours.
/// \param detailed with images, at least one face
/// \param coarse placed like the scene
/// \throw std::invalid_argument for a size that isn't allowed, or as `unwrap`; Cancelled
Baked bake(const render::Scene& detailed, const IndexedMesh& coarse, const BakeOptions& options = {});

}  // namespace whittle::bake
