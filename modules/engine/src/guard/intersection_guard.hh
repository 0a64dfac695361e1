#pragma once

#include <array>
#include <vector>

#include "complex/triangle_complex.hh"
#include "guard/face_boxes.hh"
#include "guard/guard.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {

/// Refuses what would make faces intersect that didn't before. Faces with a common edge are not compared: they
/// intersect only where they are folded onto each other, and the limit for turning faces prevents that.
///
/// A face far along the surface may be in the way. So a refusal may become outdated without the pair being woken.
class IntersectionGuard final : public Guard {
 public:
  explicit IntersectionGuard(TriangleComplex& complex) : complex_(complex), boxes_(complex) {}

  std::optional<Refusal> reason() const override { return Refusal::intersection; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;
  bool follows() const override { return true; }
  void note(const Change& change) override;

 private:
  /// A face at the merged vertex.
  struct Face {
    Index x, y;    ///< the other corners
    Corners now;   ///< with the vertex where it is now, a or b
    Corners then;  ///< with the merged vertex
    FloatBox box;  ///< of `then`
  };

  struct Crossed {
    Triangle face;
    Corners corners;
  };

  void list_faces(const ContractionProfile& profile, const Vec3& position);
  bool do_cross_each_other() const;
  bool cross_faces_at(Index v, const Pair& pair);
  bool is_crossed_already(const Pair& pair, const Crossed& face);

  TriangleComplex& complex_;
  FaceBoxes boxes_;
  std::vector<Face> faces_;       ///< scratch: of the merged vertex
  std::vector<Crossed> crossed_;  ///< scratch: other faces that intersect those
  std::vector<Index> around_;     ///< scratch
};

}  // namespace whittle
