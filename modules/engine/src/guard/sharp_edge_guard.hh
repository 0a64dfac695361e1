#pragma once

#include <vector>

#include "complex/constraints.hh"
#include "complex/triangle_complex.hh"
#include "guard/guard.hh"

namespace whittle {

/// Keeps feature lines visible and the rest smooth. An edge of two faces is sharp if their normals differ by more than
/// an angle. Feature edges stay sharp, so they don't become borders, and no other edge becomes sharp.
class SharpEdgeGuard final : public Guard {
 public:
  /// \param angle_deg (0, 180)
  SharpEdgeGuard(TriangleComplex& complex, const Constraints& constraints, double angle_deg);

  std::optional<Refusal> reason() const override { return Refusal::feature; }
  /// Whether the contraction would make an edge sharp that is no feature, or blunt a feature edge that is sharp.
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;
  int n_rings() const override { return 2; }

 private:
  /// A face at the merged vertex by its other corners, in its order.
  struct Face {
    Index x, y;
    Vec3 normal;
  };
  /// An edge of two faces as it is now.
  struct Edge {
    bool is_regular = false;
    bool is_sharp = false;
  };

  void list_faces(const ContractionProfile& profile, const Vec3& position);
  bool would_change_edge(const Pair& pair, Index x);
  bool would_change_link(const Pair& pair, const Face& face);
  bool is_sharp(const Vec3& normal, const Vec3& other) const;
  Edge look_at(Index v, Index w);
  bool is_feature(Index v, Index w);

  TriangleComplex& complex_;
  const Constraints& constraints_;
  double least_cosine_;
  std::vector<Face> faces_;    ///< scratch: of the merged vertex
  std::vector<Face> at_edge_;  ///< scratch: of an edge, x its second end, or y
  std::vector<Index> seen_;    ///< scratch
};

}  // namespace whittle
