#pragma once

#include <compare>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Two vertex numbers, a < b.
struct VertexPair {
  Index a, b;

  auto operator<=>(const VertexPair&) const = default;
};

}  // namespace whittle
