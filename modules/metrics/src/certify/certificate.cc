#include "whittle/metrics/certificate.hh"

#include <cmath>
#include <stdexcept>

#include "certify/proof_text.hh"
#include "certify/recorded.hh"

namespace whittle::metrics {
namespace {

std::string head(const IndexedMesh& first, const IndexedMesh& second, const CertifiedDistances& at_most,
                 std::span<const double> tolerances) {
  std::string bytes = "whittle certificate 1\n";
  append_double(at_most.surface, bytes);
  append_double(at_most.borders, bytes);
  for (const IndexedMesh* mesh : {&first, &second}) {
    append_varint(mesh->positions.size(), bytes);
    append_varint(mesh->faces.size(), bytes);
  }
  append_varint(tolerances.size(), bytes);
  for (const double tolerance : tolerances) append_double(tolerance, bytes);
  return bytes;
}

}  // namespace

std::optional<std::string> make_certificate(const IndexedMesh& first, const IndexedMesh& second,
                                            const CertifiedDistances& at_most, const CertifyOptions& options) {
  if (!(at_most.surface > 0 && at_most.borders > 0)) {
    throw std::invalid_argument("make_certificate: a distance is 0 or less, or not a number");
  }
  std::string bytes = head(first, second, at_most, options.tolerances);
  if (certify(first, second, at_most.surface, options, &bytes).verdict != Verdict::proven) return std::nullopt;
  CertifyOptions of_borders = options;
  of_borders.tolerances = {};
  if (std::isfinite(at_most.borders) &&
      certify_borders(first, second, at_most.borders, of_borders, &bytes).verdict != Verdict::proven) {
    return std::nullopt;
  }
  return bytes;
}

}  // namespace whittle::metrics
