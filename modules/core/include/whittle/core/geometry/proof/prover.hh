#pragma once

#include <vector>

#include "whittle/core/geometry/proof/patch.hh"
#include "whittle/core/geometry/proof/verdict.hh"

namespace whittle {

/// A point of a triangle that is far from a surface.
struct FarthestPoint {
  Vec3 point = Vec3::Zero();
  double distance = -1;  ///< none if negative
};

/// A step of a proof that a triangle is within a distance of a surface.
struct ProofStep {
  enum class Kind {
    face,   ///< its corners are within the distance of one face
    patch,  ///< a patch covers it
    halves  ///< an edge is halved: steps of both halves follow
  };
  Kind kind;
  Index number;  ///< of the face, of the face that the patch starts from, or of the corner that the edge starts from
};

/// Proves that triangles are within a distance of a surface.
class Prover {
 public:
  /// \param most_pieces of a triangle, before it is given up
  explicit Prover(const ProofTarget& target, int most_pieces = 1 << 16) : target_(target), most_pieces_(most_pieces) {}

  /// Proves that each point of a triangle is within a distance, or finds one that is farther. Undecided: a point is as
  /// far but for rounding, or it takes too many pieces.
  /// \param hint a face that may be near, or `invalid_index`: only the time depends on it
  /// \param farthest of the points looked at
  Verdict prove(const Corners& triangle, double distance, Index hint, FarthestPoint& farthest);

  /// Those of the last proof. Those of a half come before those of the other one.
  const std::vector<ProofStep>& steps() const { return steps_; }

  /// Finds the farthest point of a triangle, as far as it is farther than `from`.
  /// \param most unless a point is farther, all are to be proven to be within this
  /// \return a distance that all points are proven to be within: that of the point found, or `from`; and `accuracy`
  ///         times the greater of this and of `most`, if that is finite; and a 10⁻⁹th; or `most`. If that takes too
  ///         many pieces, more; then no less is sought of triangles after this one, as the largest distance of all is
  ///         what counts
  double find_farthest(const Corners& triangle, double from, double accuracy, double most, Index hint,
                       FarthestPoint& farthest);

 private:
  struct Piece {
    Corners corners;
    Index hint;                      ///< a face of the surface that may be near
    Index obstacle = invalid_index;  ///< a face that was too high over the piece that was halved, if there was one
  };

  void begin(const Corners& triangle, Index hint, double distance);
  template <class Limit, class Decide>
  Verdict search(const Limit& limit, const Decide& decide, FarthestPoint& farthest);
  bool is_proven(const Piece& piece, double distance);
  bool is_near(const Corners& corners, Index face, double distance);
  void list_known(Index hint);
  NearFace nearest_known(const Vec3& point) const;
  NearFace search_near(const Vec3& point, NearFace from, double distance);
  Vec3 suspect(const Corners& corners) const;
  void split(const Piece& piece);

  const ProofTarget& target_;
  LinkedFaces surface_;  ///< that of the target
  int most_pieces_;
  double coarse_ = 0;  ///< what `find_farthest` has proven of a triangle that took too many pieces
  Patch patch_;
  Index last_ = invalid_index;       ///< the face over the center of the piece looked at last, or its hint
  std::vector<Index> known_;         ///< faces that may be near to the piece looked at last
  NumberSet searched_;               ///< scratch
  std::vector<NearFace> to_search_;  ///< scratch
  std::vector<Piece> pieces_;
  std::vector<ProofStep> steps_;
};

}  // namespace whittle
