#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::verify {

/// A view of a set of triangles; the arrays must outlive it.
struct Triangles {
  std::span<const double> coordinates;     ///< x, y, z of each vertex, model units
  std::span<const std::uint32_t> corners;  ///< three vertices per face, from 0
};

/// The distances that a certificate proves, or the reason why it doesn't hold.
struct Verification {
  bool holds = false;

  /// Each point of either surface is within this distance of the other surface. Model units, (0, inf]; 0 unless the
  /// certificate holds.
  double max_error = 0;
  /// The same for the borders, the edges that occur once; infinite without a proof for them.
  double max_error_borders = 0;
  /// Per vertex of `in`, model units, (0, inf]; or empty. Each point of a face of `in` is also within the least
  /// tolerance of its corners of `out`, and each point of `out` is within that tolerance of some face of `in`.
  std::vector<double> tolerances{};

  /// If it doesn't hold: the first reason in the order of the file, such as "face 17 of IN: a corner is not within the
  /// distance of face 5". It calls `in` IN, and `out` OUT.
  std::string why_not{};
  /// If it doesn't hold: whether the bytes aren't a certificate of any meshes, such as the first half of one.
  bool is_malformed = false;
};

/// Checks a certificate (docs/dev/certificate.md) by following each step of the proof, without searching. Correct for
/// any triangles, open or non-manifold, and for any bytes.
///
/// Takes time in proportion to the steps and the faces that they read, and memory in proportion to the meshes and the
/// certificate.
/// \param in, out coordinates of used vertices are finite and not above 3e150; if not, the certificate doesn't hold
/// \param threads 0 = all cores. The result doesn't depend on it.
/// \throw std::bad_alloc
Verification verify(const Triangles& in, const Triangles& out, std::string_view certificate, unsigned threads = 0);

}  // namespace whittle::verify
