#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "whittle/core/flat_arrays.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/verify/verify.hh"

// Certificates by hand: docs/dev/certificate.md.

namespace whittle::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline std::string number_bytes(std::uint64_t n) {
  std::string bytes;
  for (; n > 127; n >>= 7) bytes += static_cast<char>((n & 127) | 128);
  return bytes + static_cast<char>(n);
}

inline std::string real_bytes(double x) {
  std::string bytes;
  for (unsigned i = 0; i < 8; ++i) bytes += static_cast<char>(std::bit_cast<std::uint64_t>(x) >> 8 * i & 255);
  return bytes;
}

/// The proofs of a chunk's triangles.
class Steps {
 public:
  Steps& face(Index f) { return add(0, difference_to(f)); }
  Steps& patch(Index f) { return add(1, difference_to(f)); }
  Steps& halve(unsigned edge) { return add(2, edge); }
  Steps& add(unsigned kind, std::uint64_t rest) {
    bytes_ += number_bytes(4 * rest + kind);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::uint64_t difference_to(Index f) {
    const std::int64_t d = std::int64_t{f} - face_;
    face_ = f;
    return static_cast<std::uint64_t>(d >= 0 ? 2 * d : -2 * d - 1);
  }

  std::string bytes_;
  std::int64_t face_ = 0;
};

/// A certificate in the making. A section without chunks has no bytes.
struct Certificate {
  double max_error = 0;
  double max_error_borders = infinity;
  std::vector<double> tolerances{};
  /// Faces of IN, faces of OUT, borders of IN, borders of OUT.
  std::array<std::vector<std::string>, 4> sections{};

  Certificate& prove(std::size_t section, const Steps& steps) {
    sections[section].push_back(steps.bytes());
    return *this;
  }
  std::string head(const IndexedMesh& in, const IndexedMesh& out) const {
    std::string bytes = "whittle certificate 1\n" + real_bytes(max_error) + real_bytes(max_error_borders);
    for (const IndexedMesh* mesh : {&in, &out}) {
      bytes += number_bytes(mesh->positions.size()) + number_bytes(mesh->faces.size());
    }
    bytes += number_bytes(tolerances.size());
    for (const double tolerance : tolerances) bytes += real_bytes(tolerance);
    return bytes;
  }
  std::string bytes(const IndexedMesh& in, const IndexedMesh& out) const {
    std::string bytes = head(in, out);
    for (const std::vector<std::string>& chunks : sections) {
      for (const std::string& chunk : chunks) bytes += number_bytes(chunk.size()) + chunk;
    }
    return bytes;
  }
};

/// \param mesh must outlive it
inline verify::Triangles triangles_of(const IndexedMesh& mesh) { return {flat_positions(mesh), flat_faces(mesh)}; }

inline verify::Verification verified(const IndexedMesh& in, const IndexedMesh& out, const std::string& bytes,
                                     unsigned threads = 1) {
  return verify::verify(triangles_of(in), triangles_of(out), bytes, threads);
}

inline verify::Verification verified(const IndexedMesh& in, const IndexedMesh& out, const Certificate& certificate,
                                     unsigned threads = 1) {
  return verified(in, out, certificate.bytes(in, out), threads);
}

}  // namespace whittle::test
