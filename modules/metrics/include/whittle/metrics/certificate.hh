#pragma once

#include <limits>
#include <optional>
#include <string>

#include "whittle/metrics/certify.hh"

// The steps of a proof of the largest distance, for whoever wants to follow them: see docs/dev/certificate.md.
// `verify::verify` does so, with `flat_positions` and `flat_faces` of both meshes.

namespace whittle::metrics {

struct CertifiedDistances {
  double surface = 0;  ///< model units, positive
  /// Of open borders, likewise. Infinite if nothing is to be proven of them.
  double borders = std::numeric_limits<double>::infinity();
};

/// Proves that two surfaces are within a distance of each other, as `certify` does, and their open borders, as
/// `certify_borders` does.
/// \return the steps of the proof, the same for any number of threads; nothing if there is none
/// \throw as `certify`; std::invalid_argument if a distance is 0
std::optional<std::string> make_certificate(const IndexedMesh& first, const IndexedMesh& second,
                                            const CertifiedDistances& at_most, const CertifyOptions& options = {});

}  // namespace whittle::metrics
