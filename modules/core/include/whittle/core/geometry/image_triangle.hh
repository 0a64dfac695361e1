#pragma once

#include <Eigen/Core>
#include <array>

// Triangles on the image of a texture.

namespace whittle::detail {

using Vec2 = Eigen::Vector2d;
using ImageTriangle = std::array<Vec2, 3>;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the signed area on the image; negative if clockwise.
inline double area_on_image(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

}  // namespace whittle::detail
