#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "look.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bake {

/// What was found on a texel.
struct Texel {
  Eigen::Vector3f light = Eigen::Vector3f::Zero();   ///< sum of base colours, linear
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< sum of unit vectors, in tangent space
  std::uint32_t n_samples = 0;
};

struct Texels {
  std::vector<Texel> texels;  ///< rows from the top
  std::size_t n_samples = 0;
  std::size_t n_missed = 0;  ///< samples whose `Place::faces_same_way` is false
};

/// An image of a mesh, and the samples to take for it.
struct ImageGrid {
  std::size_t size;           ///< texels along a side, a multiple of 16
  std::size_t texel_samples;  ///< along a side of a texel
};

/// Looks up all places of a mesh at the samples of an image, and the middle of each face.
/// \param mesh from `unwrapped_mesh`
Texels look_up_texels(const Look& look, const IndexedMesh& mesh, const ImageGrid& grid, const detail::Workers& workers);

}  // namespace whittle::bake
