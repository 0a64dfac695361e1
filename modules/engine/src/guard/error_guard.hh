#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "complex/triangle_complex.hh"
#include "error/error_bound.hh"
#include "error/point_supports.hh"
#include "guard/guard.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/proof/prover.hh"

namespace whittle {

/// Refuses what would take a point of the surface farther from the input than a bound, or a point of an edge of the
/// input from the surface. The latter is no proof: points inside of a face may be farther, though they rarely are.
class ErrorGuard : public Guard {
 public:
  /// \param bound with supports among the faces of the complex, by original vertices
  ErrorGuard(TriangleComplex& complex, const ErrorBound& bound);

  std::optional<Refusal> reason() const override { return Refusal::error; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;
  bool follows() const override { return true; }
  void note(const Change& change) override;

 protected:
  /// Lists what a contraction makes: `add_new`.
  virtual void list_new_faces(const ContractionProfile& profile);
  /// Lists what is at the merged vertex' neighbours and isn't new: `add_around`.
  virtual void list_faces_around();

  /// A face at the merged vertex by its other corners.
  void add_new(Index x, Index y) {
    add({invalid_index, x, y}, {position_, complex_.position(x), complex_.position(y)});
  }
  void add_around(const Triangle& face) {
    if (!is_at_pair(face)) add(face, corners(face));
  }
  TriangleComplex& complex() { return complex_; }
  std::span<const Index> around() const { return around_; }

 private:
  /// A face as a contraction would leave it. The merged vertex, which has no number yet, is `invalid_index`.
  struct FaceAfter {
    Triangle vertices;
    Corners corners;
    Box box;
  };
  /// A part of an edge of the input, and a face near to each of its ends.
  struct Segment {
    std::array<Vec3, 2> ends;
    std::array<Corners, 2> faces;
    double reach;  ///< how far it may be from the surface
  };
  /// Where a point is in `affected_`, if it is.
  struct Place {
    std::uint32_t look = 0;
    Index place = 0;
  };

  void add(const Triangle& vertices, const Corners& corners) {
    faces_.push_back({vertices, corners, bounds_of(corners)});
  }
  void list_around(const ContractionProfile& profile);
  void list_affected();
  bool are_new_faces_near();
  bool are_affected_near();
  bool are_edges_near(Index point, Index support);
  bool is_near(const Segment& segment, int depth);
  bool find_support(const Vec3& point, double reach, Index& hint);
  bool find_support_in_list(const Vec3& point, double reach, Index& hint);
  bool is_at_pair(const Triangle& face) const;
  static bool is_within(const Corners& face, const Vec3& point, double reach) {
    return distance_to(face, point) <= reach;
  }
  /// How far points and edges of the input may be: what is left of the limit is for points inside of faces.
  static double reach(double limit) { return 0.99 * limit; }
  Corners corners(const Triangle& face) const {
    return {complex_.position(face[0]), complex_.position(face[1]), complex_.position(face[2])};
  }

  TriangleComplex& complex_;
  const ErrorBound& bound_;
  PointSupports supports_;
  Prover prover_;
  Index last_ = invalid_index;  ///< a face of the input near the merged vertex looked at last

  // Of the contraction looked at last.
  Pair pair_;
  Vec3 position_ = Vec3::Zero();  ///< of the merged vertex
  std::size_t n_looks_left_ = 0;
  std::vector<FaceAfter> faces_;  ///< the new ones, and then, once they are asked for, those around them
  std::size_t n_new_ = 0;
  std::vector<Index> around_;              ///< the merged vertex' neighbours
  std::vector<Index> affected_;            ///< points of the input whose support changes
  std::vector<Index> after_;               ///< the support of each of them: a face of `faces_`
  std::vector<Place> places_;              ///< per point of the input
  std::vector<std::uint8_t> has_refused_;  ///< per point of the input: whether a contraction was refused for it
  std::uint32_t n_looks_ = 0;
};

/// The same for the open borders of the input and the surface: a face stands for a border edge, its second and third
/// corner are one.
class BorderErrorGuard final : public ErrorGuard {
 public:
  using ErrorGuard::ErrorGuard;

 private:
  void list_new_faces(const ContractionProfile& profile) override;
  void list_faces_around() override;

  std::vector<Index> ends_;  ///< scratch: the other corners of faces at a vertex
};

}  // namespace whittle
