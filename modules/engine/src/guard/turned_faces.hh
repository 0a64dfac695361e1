#pragma once

#include "complex/triangle_complex.hh"
#include "whittle/engine/formula/flip_limit.hh"

namespace whittle {

/// Whether moving the common corner of `wings` turns one of them too far.
bool turns_a_face(const TriangleComplex& complex, const FlipLimit& limit, const Wings& wings, const Vec3& from,
                  const Vec3& to);

}  // namespace whittle
