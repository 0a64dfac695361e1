#include "certify/proof_text.hh"

#include <bit>

namespace whittle::metrics {
namespace {

/// Small numbers for differences near 0.
std::uint64_t zigzag(Index from, Index to) {
  return to >= from ? 2 * (std::uint64_t{to} - from) : 2 * (std::uint64_t{from} - to) - 1;
}

}  // namespace

void append_varint(std::uint64_t number, std::string& bytes) {
  constexpr std::uint64_t more = 0x80;
  for (; number >= more; number >>= 7) bytes += static_cast<char>(number % more + more);
  bytes += static_cast<char>(number);
}

void append_double(double number, std::string& bytes) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  for (unsigned shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

void ProofText::add(std::span<const ProofStep> steps) {
  for (const auto& [kind, number] : steps) {
    const bool names_face = kind != ProofStep::Kind::halves;
    const std::uint64_t rest = names_face ? zigzag(last_, number) : number;
    append_varint(4 * rest + static_cast<std::uint64_t>(kind), bytes_);
    if (names_face) last_ = number;
  }
}

}  // namespace whittle::metrics
