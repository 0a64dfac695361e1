#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// The share of a screen's area down to which each level of detail is to be shown: below it the error of the next
/// coarser one is at most `SceneOutput::level_error_rel`. The error is the largest distance between the level and the
/// mesh, all points of both
/// (`metrics::largest_distances`). A mesh covers the area of the sphere around its bounding box, and a screen is
/// 16 wide and 9 high.
/// \param mesh the finest level \param coarser the finer ones first; one without area stands for a mesh that has
/// vanished
/// \param places where the mesh is shown; or empty. The shares hold at each of them
/// \param output the file; what it rounds counts
/// \return [0, 1] for the mesh and each coarser level, descending; 0 for the last one, which is always shown
/// \throw as `metrics::largest_distances`
std::vector<double> screen_coverages(const IndexedMesh& mesh, std::span<const IndexedMesh> coarser,
                                     std::span<const Eigen::Affine3d> places, const SceneOutput& output);

}  // namespace whittle
