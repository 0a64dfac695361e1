#include "decimate/checkpoint/changes.hh"

#include <array>
#include <bit>
#include <cstdint>

namespace whittle {
namespace {

bool is_same(const Vec3& a, const Vec3& b) {
  const auto bits = [](const Vec3& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.x()), std::bit_cast<std::uint64_t>(p.y()),
                      std::bit_cast<std::uint64_t>(p.z())};
  };
  return bits(a) == bits(b);
}

}  // namespace

std::vector<PassEnd::MovedVertex> moved_vertices(std::span<const Vec3> before, std::span<const Vec3> after,
                                                 std::span<const Index> vertices) {
  std::vector<PassEnd::MovedVertex> moved;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (!is_same(before[v], after[v])) moved.push_back({vertices[v], after[v]});
  }
  return moved;
}

std::vector<PassEnd::TurnedFace> turned_faces(std::span<const Triangle> before, std::span<const Triangle> after,
                                              std::span<const Index> vertices, std::span<const Index> face_origins) {
  std::vector<PassEnd::TurnedFace> turned;
  for (std::size_t f = 0; f < before.size(); ++f) {
    if (before[f] == after[f]) continue;
    const auto& [a, b, c] = after[f];
    turned.push_back({face_origins[f], {vertices[a], vertices[b], vertices[c]}});
  }
  return turned;
}

}  // namespace whittle
