#include "oracle/clipping.hh"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace whittle::test {
namespace {

__extension__ using Wide = __int128;

/// The point (x, y, z) / w, w > 0, without a common divisor.
struct RationalPoint {
  Wide x, y, z, w;
  bool operator==(const RationalPoint&) const = default;
};

Wide gcd(Wide a, Wide b) {
  if (a < 0) a = -a;
  if (b < 0) b = -b;
  while (b != 0) {
    a %= b;
    std::swap(a, b);
  }
  return a;
}

RationalPoint reduced(Wide x, Wide y, Wide z, Wide w) {
  Wide d = gcd(gcd(x, y), gcd(z, w));
  if (w < 0) d = -d;
  return {x / d, y / d, z / d, w / d};
}

struct IntegerVector {
  std::int64_t x, y, z;
};
IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
bool is_zero(const IntegerVector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// w times the dot product of `normal` with p − through.
Wide height(const RationalPoint& p, const IntegerVector& normal, const IntegerVector& through) {
  return normal.x * (p.x - through.x * p.w) + normal.y * (p.y - through.y * p.w) + normal.z * (p.z - through.z * p.w);
}

/// The part of a convex polygon (or segment, or point) where `normal` · (p − through) >= 0.
std::vector<RationalPoint> clipped(const std::vector<RationalPoint>& polygon, const IntegerVector& normal,
                                   const IntegerVector& through) {
  std::vector<RationalPoint> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Wide hp = height(p, normal, through), hq = height(q, normal, through);
    if (hp >= 0) result.push_back(p);
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
      // p/p.w and q/q.w weighted by the other's height over its w.
      result.push_back(reduced(q.x * hp - p.x * hq, q.y * hp - p.y * hq, q.z * hp - p.z * hq, q.w * hp - p.w * hq));
    }
  }
  return result;
}

}  // namespace

std::vector<std::array<Index, 2>> intersections_by_clipping(const IndexedMesh& mesh) {
  const auto corner = [&](std::size_t face, std::size_t c) {
    const Vec3& p = mesh.positions[mesh.faces[face][c]];
    return IntegerVector{static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()),
                         static_cast<std::int64_t>(p.z())};
  };
  const auto normal = [&](std::size_t face) {
    return cross(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0));
  };
  const auto as_rational = [](const IntegerVector& p) { return RationalPoint{p.x, p.y, p.z, 1}; };
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t g = f + 1; g < mesh.faces.size(); ++g) {
      const IntegerVector n = normal(g);
      if (is_zero(n) || is_zero(normal(f))) continue;
      std::vector<RationalPoint> common, polygon;
      for (std::size_t c = 0; c < 3; ++c) polygon.push_back(as_rational(corner(f, c)));
      for (const RationalPoint& p : polygon) {
        for (std::size_t c = 0; c < 3; ++c) {
          if (p == as_rational(corner(g, c))) common.push_back(p);
        }
      }
      polygon = clipped(polygon, n, corner(g, 0));
      polygon = clipped(polygon, {-n.x, -n.y, -n.z}, corner(g, 0));
      for (std::size_t c = 0; c < 3; ++c) {
        polygon = clipped(polygon, cross(n, corner(g, (c + 1) % 3) - corner(g, c)), corner(g, c));
      }
      const bool more = std::any_of(polygon.begin(), polygon.end(), [&](const RationalPoint& p) {
        if (common.empty()) return true;
        if (common.size() == 1) return !(p == common[0]);
        if (common.size() == 3) return true;
        // The common point is off the line through both common corners, which are integers.
        const RationalPoint &a = common[0], &b = common[1];
        const Wide dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
        const Wide px = p.x - a.x * p.w, py = p.y - a.y * p.w, pz = p.z - a.z * p.w;
        return dy * pz != dz * py || dz * px != dx * pz || dx * py != dy * px;
      });
      if (more) pairs.push_back({static_cast<Index>(f), static_cast<Index>(g)});
    }
  }
  return pairs;
}

}  // namespace whittle::test
