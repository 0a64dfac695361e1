#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "whittle/engine/decimate.hh"

namespace whittle::detail {

/// Fits a decimation to its input: may move vertices of the mesh, and flip edges. No more may change.
/// \return false if the run is cancelled
using Fit = std::function<bool(Decimation& decimation)>;

struct FittedDecimation {
  Decimation decimation;
  bool is_fitted = false;  ///< whether the mesh is as the last call of the fit has left it
};

/// `decimate`, and a fit after the last contraction; none if the run was cancelled. With a limit of the error the mesh
/// is proven to keep it after the fit, too: vertices go as far towards where the fit puts them as the proof allows.
/// What a fit changes is in the last of `RunSteps::pass_ends`.
///
/// It leaves to the caller what comes after the fit (`break_normals`, and to keep texture coordinates in their charts)
/// and two-sided sheets (without_backs.hh).
/// \param fit or empty: there is none, and texture coordinates are kept in their charts
/// \throw as `decimate`
FittedDecimation decimate_and_fit(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                                  const Fit& fit);

}  // namespace whittle::detail
