#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "guard/border_motion.hh"
#include "guard/guard.hh"

namespace whittle {

/// An edge of length l between faces that turn by α may come to lie l sin α from where the surface was, if it crosses
/// a crease. This share of it counts as a displacement.
inline constexpr double share_of_turn = 0.2;

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

  const TriangleComplex& complex_;
  double limit_sq_;                          ///< of the contraction looked at last
  std::vector<double> limits_;               ///< per vertex; empty if all have one
  std::vector<std::array<Vec3, 3>> before_;  ///< scratch: faces
  std::vector<std::array<Vec3, 3>> after_;   ///< scratch
  BorderMotion border_motion_;
  std::array<std::vector<LinkEdge>, 2> others_;  ///< scratch
  std::vector<Index> opposites_;                 ///< scratch
};

}  // namespace whittle
