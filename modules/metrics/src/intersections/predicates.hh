#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// The side of the plane a, b, c on which the point d lies: +1 if a, b, c run clockwise seen from d (d is below, by the
/// right hand rule), −1 if counter-clockwise, 0 on the plane. Exact for doubles, unless products of three differences
/// over- or underflow.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether a, b, c turn left (+1), turn right (−1) or are on a line (0), in the plane of the coordinates `x` and `y`
/// (0 … 2). Exact in the same way.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int x, int y);

}  // namespace whittle::metrics
