#pragma once

#include "error/error_bounds.hh"
#include "whittle/engine/detail/decimate_and_fit.hh"

namespace whittle {

/// Fits a decimation that keeps bounds, so that it keeps them afterwards: vertices go as far as the proof allows, all
/// the way, a third of it or nowhere. If that doesn't help, or the fit is cancelled, the decimation
/// stays as it was. \return whether it is fitted
bool fit_within(ErrorBounds& bounds, const IndexedMesh& input, const detail::Fit& fit, Decimation& decimation);

}  // namespace whittle
