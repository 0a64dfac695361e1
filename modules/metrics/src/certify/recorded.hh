#pragma once

#include <string>

#include "whittle/metrics/certify.hh"

namespace whittle::metrics {

/// The functions of certify.hh.
/// \param sections the steps of the proof are appended, as a certificate has them, if there is one; may be null
Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options, std::string* sections);
Certification certify_borders(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                              const CertifyOptions& options, std::string* sections);

}  // namespace whittle::metrics
