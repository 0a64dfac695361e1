#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "whittle/core/geometry/proof/prover.hh"

namespace whittle::metrics {

/// Appends a number as an unsigned LEB128 varint.
void append_varint(std::uint64_t number, std::string& bytes);

/// Appends a double, the least byte first.
void append_double(double number, std::string& bytes);

/// The proofs of the triangles of a chunk, as a certificate has them.
class ProofText {
 public:
  void add(std::span<const ProofStep> steps);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  Index last_ = 0;  ///< the face named last
};

}  // namespace whittle::metrics
