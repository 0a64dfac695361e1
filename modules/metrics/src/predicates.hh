#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Which side of the plane a, b, c the point d lies on: +1 where a, b, c run clockwise seen from d (d below, by the
/// right hand rule), −1 where counter-clockwise, 0 on the plane. Exact for doubles, barring over- and underflow of
/// products of three differences.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether a, b, c turn left (+1), right (−1) or lie on a line (0), seen in the plane of coordinates `x` and `y` (0 …
/// 2). Exact likewise.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int x, int y);

}  // namespace whittle::metrics
