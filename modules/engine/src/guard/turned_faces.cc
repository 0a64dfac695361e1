#include "guard/turned_faces.hh"

#include <algorithm>

#include "whittle/core/detail/lanes.hh"

namespace whittle {
namespace {

template <class Real>
[[gnu::always_inline]] inline bool turns_a_face_in_lanes(const TriangleComplex& complex, const FlipLimit& limit,
                                                         const Wings& wings, const Vec3& from, const Vec3& to) {
  const auto everywhere = [](const Vec3& p) __attribute__((always_inline)) {
    return [&p](std::size_t) -> const Vec3& { return p; };
  };
  const auto from_lanes = point_lanes<Real>(everywhere(from));
  const auto to_lanes = point_lanes<Real>(everywhere(to));
  for (std::size_t i = 0; i < wings.size(); i += n_lanes<Real>) {
    const auto wing = [&](std::size_t lane) { return wings[std::min(i + lane, wings.size() - 1)]; };
    const auto x = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return complex.position(wing(lane).x); });
    const auto y = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return complex.position(wing(lane).y); });
    if (limit.is_exceeded(from_lanes, to_lanes, x, y)) return true;
  }
  return false;
}

WHITTLE_DOUBLE4 bool turns_one_of_four(const TriangleComplex& complex, const FlipLimit& limit, const Wings& wings,
                                       const Vec3& from, const Vec3& to) {
  return turns_a_face_in_lanes<Double4>(complex, limit, wings, from, to);
}

}  // namespace

bool turns_a_face(const TriangleComplex& complex, const FlipLimit& limit, const Wings& wings, const Vec3& from,
                  const Vec3& to) {
  return has_double4 ? turns_one_of_four(complex, limit, wings, from, to)
                     : turns_a_face_in_lanes<Double2>(complex, limit, wings, from, to);
}

}  // namespace whittle
