#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::verify {

/// A set of triangles. What it names must outlive it.
struct Triangles {
  std::span<const double> coordinates;     ///< x, y, z of each vertex, model units
  std::span<const std::uint32_t> corners;  ///< three vertices of each face, from 0 on
};

/// What a certificate proves, or why it doesn't.
struct Verification {
  bool holds = false;

  /// Each point of either surface is within this distance of the other surface. Model units, (0, inf]; 0 unless the
  /// certificate holds.
  double max_error = 0;
  /// The same of the borders, the edges that occur once; infinite if nothing is proven of them.
  double max_error_borders = 0;
  /// Of each vertex of `in`, model units, (0, inf]; or none. Each point of a face of `in` is also within the least of
  /// its corners' of `out`, and each point of `out` is within that tolerance of some face of `in`.
  std::vector<double> tolerances{};

  /// If it doesn't hold: the first reason in the order of the file, such as "face 17 of IN: a corner is not within the
  /// distance of face 5". It calls `in` IN, and `out` OUT.
  std::string why_not{};
  /// If it doesn't hold: whether the bytes are no certificate of any meshes, such as the first half of one.
  bool is_malformed = false;
};

/// Checks a certificate (docs/dev/certificate.md): follows each step of the proof, and searches for nothing. It is
/// right for any triangles, open or not manifold, and for any bytes.
///
/// Takes time in proportion to the steps and to the faces that they look at, and memory in proportion to the meshes and
/// the certificate.
/// \param in, out coordinates of used vertices are finite and not above 3e150; if not, the certificate doesn't hold
/// \param threads 0 = all cores. The result doesn't depend on it.
/// \throw std::bad_alloc
Verification verify(const Triangles& in, const Triangles& out, std::string_view certificate, unsigned threads = 0);

}  // namespace whittle::verify
