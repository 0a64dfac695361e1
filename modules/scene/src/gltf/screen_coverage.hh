#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The share of a screen's area down to which each level of detail is to be shown: below it the error of the next
/// coarser one is at most a pixel. The error is the largest distance that is measured between the level and the mesh. A
/// mesh covers the area of its bounding sphere, and a screen has 1920 × 1080 pixels.
/// \param mesh the finest level \param coarser the finer ones first; one without area stands for a mesh that has
/// vanished
/// \return [0, 1] for the mesh and each coarser level, descending; 0 for the last one, which is always shown
std::vector<double> screen_coverages(const IndexedMesh& mesh, std::span<const IndexedMesh> coarser);

}  // namespace whittle
