#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {

struct PictureOptions {
  std::size_t n_views = 24;
  unsigned threads = 0;
  ProgressCallback progress{};
};

/// How different two meshes look. PSNR is in decibels, infinite for equal pictures; FLIP in [0, 1].
struct PictureErrors {
  std::size_t n_views = 0;
  double mean_psnr = 0;
  double pooled_psnr = 0;  ///< of all views as one picture
  double worst_psnr = 0;
  double mean_flip = 0;
  double worst_flip = 0;
  std::string worst_png;              ///< a PNG file of the worst view: the original, the other mesh, where they differ
  std::vector<std::string> warnings;  ///< textures and materials that aren't drawn
};

/// \throw std::runtime_error if this program or this machine can't draw
void require_pictures();

/// Draws both with their textures from the same views. \pre `require_pictures` \throw std::runtime_error; Cancelled
PictureErrors compare_pictures(const Scene& original, const Scene& simplified, const PictureOptions& options);

}  // namespace whittle::app
