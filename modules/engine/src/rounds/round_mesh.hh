#pragma once

#include <span>
#include <vector>

#include "rounds/round_scratch.hh"
#include "rounds/star_planes.hh"

namespace whittle {

/// A part of a surface in rounds: the faces that are left, and the star of each vertex at the beginning of the round.
///
/// In a round each vertex is merged once at most. So the stars of its beginning tell what is there now: a corner that
/// was merged is what it was merged into, and a face of which two corners are one has vanished.
class RoundMesh {
 public:
  /// Positions are in the frame. Faces with two equal corners are left out.
  RoundMesh(std::span<const Vec3> positions, std::span<const Triangle> faces, RoundScratch& scratch);

  std::size_t n_vertices() const { return points_.size(); }
  std::span<const LanePoint> points() const { return points_; }
  const LanePoint& point(Index v) const { return points_[v]; }
  /// Those that were left at the beginning of the round.
  std::span<const Triangle> faces() const { return faces_; }
  /// The numbers of these faces in the surface.
  std::span<const Index> face_origins() const { return face_origins_; }

  /// As at the beginning of the round. \pre list_stars
  std::span<const LinkEdge> star(Index v) const {
    return std::span(corners_).subspan(offsets_[v], offsets_[v + 1] - offsets_[v]);
  }
  /// The numbers of these faces, among `faces`. \pre list_stars with face numbers
  std::span<const Index> faces_in_star(Index v) const {
    return std::span(corner_faces_).subspan(offsets_[v], offsets_[v + 1] - offsets_[v]);
  }
  /// What a vertex of the beginning of the round is now.
  Index now(Index v) const { return merged_into_[v]; }

  void merge(Index removed, Index survivor, const Vec3& position) {
    merged_into_[removed] = survivor;
    points_[survivor] = LanePoint(position);
  }

  /// Begins a round: leaves out the faces that have vanished. \param with_numbers whether `faces_in_star` are wanted
  void begin_round(bool with_numbers);

  /// What each vertex has become since the start.
  std::vector<Index> merged_into() const;

 private:
  void list_stars(bool with_numbers);

  std::vector<LanePoint> points_;
  std::vector<Triangle> faces_;
  std::vector<Index> face_origins_;
  std::vector<Index> merged_into_;  ///< in the round in which it was merged; itself if it wasn't
  std::vector<Index> offsets_;      ///< per vertex and one more, in `corners_`
  std::vector<LinkEdge>& corners_;  ///< by vertex, its faces in their order
  std::vector<Index> corner_faces_;
};

}  // namespace whittle
