#pragma once

#include <limits>
#include <optional>
#include <string>

#include "whittle/metrics/certify.hh"

// Writes the steps of a proof of the largest distance (docs/dev/certificate.md). `verify::verify` checks them, with
// `flat_positions` and `flat_faces` of both meshes.

namespace whittle::metrics {

struct CertifiedDistances {
  double surface = 0;  ///< model units, positive
  /// Between open borders, model units, positive. Infinite: not proven.
  double borders = std::numeric_limits<double>::infinity();
};

/// Proves that two surfaces are within a distance of each other (`certify`), and their open borders
/// (`certify_borders`).
/// \return the steps of the proof, the same for any number of threads; empty if it fails
/// \throw as `certify`; std::invalid_argument if a distance is 0
std::optional<std::string> make_certificate(const IndexedMesh& first, const IndexedMesh& second,
                                            const CertifiedDistances& at_most, const CertifyOptions& options = {});

}  // namespace whittle::metrics
