#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "whittle/core/progress.hh"
#include "whittle/render/draw.hh"
#include "whittle/render/picture_error.hh"

namespace whittle::render {

struct CompareOptions {
  std::size_t n_views = 24;  ///< [1, 10000].
  DrawOptions draw{};
  double pixels_per_degree = default_pixels_per_degree;  ///< Of FLIP.
  /// Threads to compare pictures with; 0 = all cores. OpenGL has threads of its own. The result is the same for any
  /// number.
  unsigned threads = 0;
  /// Gets the progress; returning false cancels with the exception `Cancelled`.
  ProgressCallback progress{};
};

/// Difference of two scenes seen from one view.
struct ViewComparison {
  View view;
  double psnr = 0;  ///< dB, over the pixels that show the model; infinity for equal pictures.
  double flip = 0;  ///< [0, 1], over the whole picture.
};

/// Difference of two scenes, over all views.
struct Comparison {
  std::vector<ViewComparison> views;

  double mean_psnr = 0;  ///< Mean of the views' `psnr`, dB; infinity if one view is equal.
  /// PSNR of the pixels of all views together, dB: as if they were one picture. Finite unless all views are equal.
  double pooled_psnr = 0;
  double mean_flip = 0;

  double worst_psnr = 0;  ///< The least.
  double worst_flip = 0;  ///< The greatest, perhaps of another view.

  /// A PNG file of the first view with the least PSNR, three pictures wide: original, simplified, FLIP.
  std::string worst_png;
};

/// Draws both scenes from the same views, around the original's bounding sphere, and compares the pictures.
/// \throw as `Renderer`; std::invalid_argument if `options` are out of range; Cancelled
Comparison compare(const Scene& original, const Scene& simplified, const CompareOptions& options = {});

}  // namespace whittle::render
