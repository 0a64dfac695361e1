#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "complex/contraction_profile.hh"
#include "complex/triangle_complex.hh"
#include "error/error_bound.hh"
#include "error/near_test.hh"
#include "error/point_supports.hh"
#include "whittle/core/geometry/proof/prover.hh"

namespace whittle {

/// A contraction that an error guard looks at.
class ErrorLook {
 public:
  explicit ErrorLook(const ErrorBound& bound) : prover_(bound.input(), most_pieces_of_new_face) {}

 private:
  friend class ErrorGuard;

  /// Pieces of a face that are looked at before the contraction is refused.
  static constexpr int most_pieces_of_new_face = 256;

  /// A face as the contraction would leave it. The merged vertex, which has no number yet, is `invalid_index`.
  struct FaceAfter {
    Triangle vertices;
    NearTest near;
  };

  std::uint32_t number_ = 0;
  Pair pair_{};
  std::vector<LinkEdge> new_faces_;  ///< by their other corners
  std::vector<Index> around_;        ///< the merged vertex' neighbours
  std::vector<Index> affected_;      ///< points of the input whose support changes
  Prover prover_;

  // Of the position looked at last
  Vec3 position_ = Vec3::Zero();
  std::vector<FaceAfter> faces_;  ///< the new ones, and then, once they are asked for, those around them
  std::vector<Index> after_;      ///< the support of each affected point: a face of `faces_`
  NearFace nearest_;              ///< of the input, to the position
  std::size_t n_looks_left_ = 0;
  std::vector<Neighbour> star_;    ///< scratch
  std::vector<LinkEdge> at_star_;  ///< scratch
};

/// Refuses what would take a point of the surface farther from the input than a bound, or a point of an edge of the
/// input from the surface. The latter is no proof: points inside of a face may be farther, though they rarely are.
///
/// Several contractions can be looked at, and at once, if no two of their pairs have a neighbour in common.
class ErrorGuard {
 public:
  /// \param bound with supports among the faces of the complex, by original vertices
  ErrorGuard(TriangleComplex& complex, const ErrorBound& bound);
  virtual ~ErrorGuard() = default;

  ErrorLook new_look() const { return ErrorLook(bound_); }
  /// Begins to look at a contraction, one at a time.
  void begin(const ContractionProfile& profile, ErrorLook& look);
  /// Lists the points whose support changes. Threads may do so at once, but while none asks `accepts`.
  void list_affected(ErrorLook& look);
  /// Whether the merged vertex may be at a position. Any number of threads may ask, each with a look of its own.
  /// \pre list_affected
  bool accepts(const Vec3& position, ErrorLook& look);
  /// Where the merged vertex may rather be than at the position looked at last: nearer to the input. The farthest first
  std::vector<Vec3> nearer_positions(const ErrorLook& look) const;
  /// Whether the contraction is still accepted after others that were looked at since `first` have been made.
  bool still_accepts(ErrorLook& look, const ErrorLook& first) const;
  /// \pre the contraction was accepted where it was made
  void note(const Change& change, const ErrorLook& look);

 protected:
  using Faces = std::vector<LinkEdge>;

  /// Lists the faces that a contraction makes, by their corners besides the merged vertex.
  virtual void list_new_faces(const ContractionProfile& profile, Faces& faces) const;
  /// The faces of a star in pairs of neighbours. \return by their corners besides the vertex
  virtual void list_faces_of(std::span<const Neighbour> star, Faces& faces) const;

 private:
  /// A part of an edge of the input, and a face near to each of its ends.
  struct Segment {
    std::array<Vec3, 2> ends;
    std::array<NearTest, 2> faces;
    double reach;  ///< how far it may be from the surface
  };
  /// Which look a point is affected by, and its place there.
  struct Place {
    std::uint32_t look = 0;
    Index place = 0;
  };

  static bool is_at(const Pair& pair, const Triangle& face) {
    return std::any_of(face.begin(), face.end(), [&pair](Index v) { return v == pair.a || v == pair.b; });
  }
  static void list_around(const ContractionProfile& profile, std::vector<Index>& around);
  void list_faces_around(ErrorLook& look) const;
  bool are_affected_near(ErrorLook& look);
  bool are_edges_near(ErrorLook& look, Index point, Index support) const;
  bool is_edge_near(ErrorLook& look, Index point, Index support, Index other) const;
  bool is_near(ErrorLook& look, const Segment& segment, int depth) const;
  bool find_support(ErrorLook& look, const Vec3& point, double reach, Index& hint) const;
  static bool find_support_in_list(ErrorLook& look, const Vec3& point, double reach, Index& hint);
  bool are_new_faces_near(ErrorLook& look) const;
  /// How far points and edges of the input may be: what is left of the limit is for points inside of faces.
  static double reach(double limit) { return 0.99 * limit; }
  Corners corners(const Triangle& face) const {
    return {complex_.position(face[0]), complex_.position(face[1]), complex_.position(face[2])};
  }

  TriangleComplex& complex_;
  const ErrorBound& bound_;
  PointSupports supports_;
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
  void list_new_faces(const ContractionProfile& profile, Faces& faces) const override;
  void list_faces_of(std::span<const Neighbour> star, Faces& faces) const override;
};

}  // namespace whittle
