#pragma once

#include <vector>

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses what may move the surface, or its open border, farther than a limit from where it is now. An estimate, which
/// takes little time.
class DisplacementGuard final : public Guard {
 public:
  /// \param limit in the frame
  DisplacementGuard(const TriangleComplex& complex, double limit) : complex_(complex), limit_sq_(limit * limit) {}

  /// Nowhere: what is refused now may be contracted later.
  std::uint64_t Rejections::*reason() const override { return nullptr; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;

 private:
  /// What a contraction does to the faces around a pair.
  struct Motion {
    double displacement_sq;  ///< of the faces' corners
    double least_cosine;     ///< between a face's normals before and after
  };

  Motion motion(ContractionProfile& profile, const Vec3& position);
  bool moves_border(const ContractionProfile& profile, const Vec3& position);
  void list_border_edges(const Vec3& from, std::vector<std::array<Vec3, 3>>& edges);

  const TriangleComplex& complex_;
  double limit_sq_;
  std::vector<std::array<Vec3, 3>> before_;  ///< scratch: faces
  std::vector<std::array<Vec3, 3>> after_;   ///< scratch
  std::vector<Index> ends_;                  ///< scratch: the other corners of the faces at a vertex
};

}  // namespace whittle
