#include "guard/flip_guard.hh"

#include <algorithm>

#include "whittle/core/detail/lanes.hh"

namespace whittle {
namespace {

/// Whether moving the common corner of `faces` exceeds the limit for one of them.
template <class Real>
WHITTLE_INLINE bool exceeds_in_lanes(const TriangleComplex& complex, const FlipLimit& limit, const StarFaces& faces,
                                     const Vec3& from, const Vec3& to) {
  const auto everywhere = [](const Vec3& p)
                              WHITTLE_INLINE_LAMBDA { return [&p](std::size_t) -> const Vec3& { return p; }; };
  const auto from_lanes = point_lanes<Real>(everywhere(from));
  const auto to_lanes = point_lanes<Real>(everywhere(to));
  for (std::size_t i = 0; i < faces.size(); i += n_lanes<Real>) {
    const auto face = [&](std::size_t lane)
                          WHITTLE_INLINE_LAMBDA { return faces[std::min(i + lane, faces.size() - 1)]; };
    const auto x = point_lanes<Real>(
        [&](std::size_t lane) WHITTLE_INLINE_LAMBDA -> const Vec3& { return complex.position(face(lane).x); });
    const auto y = point_lanes<Real>(
        [&](std::size_t lane) WHITTLE_INLINE_LAMBDA -> const Vec3& { return complex.position(face(lane).y); });
    if (limit.is_exceeded(from_lanes, to_lanes, x, y)) return true;
  }
  return false;
}

WHITTLE_AVX2 bool exceeds_with_four(const TriangleComplex& complex, const FlipLimit& limit, const StarFaces& faces,
                                    const Vec3& from, const Vec3& to) {
  return exceeds_in_lanes<Double4>(complex, limit, faces, from, to);
}

bool exceeds(const TriangleComplex& complex, const FlipLimit& limit, const StarFaces& faces, const Vec3& from,
             const Vec3& to) {
  return has_double4 ? exceeds_with_four(complex, limit, faces, from, to)
                     : exceeds_in_lanes<Double2>(complex, limit, faces, from, to);
}

}  // namespace

bool FlipGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  if (profile.has_ring) {
    profile.ring.move_to(position, quadric_);
    return profile.ring.least_cosine() < limit_.least_cosine();
  }
  const auto& [id, a, b] = profile.pair;
  return exceeds(complex_, limit_, profile.first, complex_.position(a), position) ||
         exceeds(complex_, limit_, profile.second, complex_.position(b), position);
}

}  // namespace whittle
