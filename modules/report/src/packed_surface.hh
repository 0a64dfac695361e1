#pragma once

#include <array>
#include <cstdint>

#include "packed_look.hh"
#include "page_bytes.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/report/page.hh"

namespace whittle::report {

/// Positions as whole numbers, 0 … 65535, of steps along the longest side of a box.
struct Grid {
  Vec3 origin;
  double step;

  static Grid around(const Box& bounds);
  std::array<std::uint16_t, 3> at(const Vec3& position) const;
};

/// {"name", "note", "refusals", "vertices", "faces", "positions", "corners", "coarse", "borders", "nonmanifold",
/// "distances", "look"}: positions of four 16-bit numbers, the last one 0, edges and pairs of two 32-bit ones.
/// "distances" is null, or {"max", "usual", "deviation", "vertices", "values", "faces", "rounds", "cuts"}: a byte a
/// vertex, its signed distance (`packed_value`); numbers of faces of each round, and a byte a face
/// (`DistanceMap::rounds`). With a "look" (`pack_look`), corners are numbers of wedges.
Json pack(const PageSurface& surface, const Grid& grid, PageBytes& bytes, PageImages& images);

}  // namespace whittle::report
