#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses what may move the surface, or its open border, farther than a limit from where it is now. An estimate, which
/// takes little time.
class DisplacementGuard final : public Guard {
 public:
  /// \param limit in the frame
  /// \param limits of each vertex by its number in the surface that the stage begins with, in place of that; or empty
  DisplacementGuard(const TriangleComplex& complex, double limit, std::span<const double> limits);

  /// Nowhere: what is refused now may be contracted later.
  std::optional<Refusal> reason() const override { return std::nullopt; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;
  bool follows() const override { return !limits_.empty(); }
  void note(const Change& change) override;

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
  double limit_sq_;                          ///< of the contraction looked at last
  std::vector<double> limits_;               ///< per vertex; empty if all have one
  std::vector<std::array<Vec3, 3>> before_;  ///< scratch: faces
  std::vector<std::array<Vec3, 3>> after_;   ///< scratch
  std::vector<Index> ends_;                  ///< scratch: the other corners of the faces at a vertex
};

}  // namespace whittle
