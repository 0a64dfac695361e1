#pragma once

#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

using LongVec3 = Eigen::Matrix<long double, 3, 1>;

/// The distance of a point from a triangle, computed in another way than in the tested code, in long double. It is the
/// least over the corners, the feet on the side lines, and the foot on the plane, of those that lie in the triangle.
long double distance_by_features(const LongVec3& p, const LongVec3& a, const LongVec3& b, const LongVec3& c);

/// The least over all faces; infinite without any.
long double distance_by_features(const IndexedMesh& mesh, const Vec3& point);

}  // namespace whittle::test
