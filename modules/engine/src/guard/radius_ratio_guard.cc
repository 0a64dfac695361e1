#include "guard/radius_ratio_guard.hh"

#include "whittle/core/geometry/radius_ratio.hh"

namespace whittle {

bool RadiusRatioGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  return makes_thin(profile.first, complex_.position(profile.pair.a), position) ||
         makes_thin(profile.second, complex_.position(profile.pair.b), position);
}

/// Whether moving the common corner of `faces` makes one of them too thin.
bool RadiusRatioGuard::makes_thin(const StarFaces& faces, const Vec3& from, const Vec3& to) const {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Vec3& x = complex_.position(faces[i].x);
    const Vec3& y = complex_.position(faces[i].y);
    const double after = radius_ratio(to, x, y);
    if (after < min_radius_ratio_ && after < radius_ratio(from, x, y)) return true;
  }
  return false;
}

}  // namespace whittle
