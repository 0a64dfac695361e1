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
  Index number;  ///< face; first face of the patch; or first corner of the halved edge
};

/// Proves that triangles are within a distance of a surface.
class Prover {
 public:
  /// \param most_pieces largest number of pieces of a triangle; beyond it the result is undecided
  explicit Prover(const ProofTarget& target, int most_pieces = 1 << 16) : target_(target), most_pieces_(most_pieces) {}

  /// Proves that each point of a triangle is within a distance, or finds a farther point. Undecided: a point is at the
  /// distance up to rounding, or the proof takes too many pieces.
  /// \param hint a face that may be near, or `invalid_index`: only the time depends on it
  /// \param farthest gets the farthest point checked
  Verdict prove(const Corners& triangle, double distance, Index hint, FarthestPoint& farthest);

  /// Steps of the last proof, depth first.
  const std::vector<ProofStep>& steps() const { return steps_; }
  /// Faces of the target that the last proof is by, some of them several times. It holds as long as these do.
  const std::vector<Index>& faces() const { return faces_; }

  /// Finds the farthest point of a triangle, if it is farther than `from`.
  /// \param most limit to prove for all points, unless a point is farther
  /// \return a proven bound for all points: `most`, or the distance of the point found (or `from`), plus `accuracy`
  ///        times the larger of this distance and a finite `most`, plus a 10⁻⁹th. Larger if the proof takes too many
  ///        pieces; then later triangles aren't proven below it, as only the largest distance counts
  double find_farthest(const Corners& triangle, double from, double accuracy, double most, Index hint,
                       FarthestPoint& farthest);

 private:
  struct Piece {
    Corners corners;
    Index hint;                      ///< a face that may be near
    Index obstacle = invalid_index;  ///< face too high over the piece before it was halved, or `invalid_index`
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
  LinkedFaces surface_;  ///< of the target
  int most_pieces_;
  double coarse_ = 0;  ///< bound of `find_farthest` for a triangle that took too many pieces
  Patch patch_;
  Index last_ = invalid_index;       ///< face over the center of the last piece, or its hint
  std::vector<Index> known_;         ///< faces that may be near the last piece
  NumberSet searched_;               ///< scratch
  std::vector<NearFace> to_search_;  ///< scratch
  std::vector<Piece> pieces_;
  std::vector<ProofStep> steps_;
  std::vector<Index> faces_;
};

}  // namespace whittle
