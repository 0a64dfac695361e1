#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rounds/round_scratch.hh"
#include "rounds/star_planes.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// A part of a surface in rounds: the vertices that are left, and the star of each.
///
/// In a round each vertex is merged once at most. So the stars of its beginning tell what is there now: a corner that
/// was merged is what it was merged into, and a face of which two corners are one has vanished.
class RoundMesh {
 public:
  /// Positions are in the frame. Faces with two equal corners are left out.
  /// \param frozen per vertex, or empty: those that have no star here, and are never merged
  /// \param with_numbers whether `faces_in_star` are wanted
  RoundMesh(std::span<const Vec3> positions, std::span<const Triangle> faces, std::span<const std::uint8_t> frozen,
            bool with_numbers, RoundScratch& scratch);

  std::size_t n_vertices() const { return points_.size(); }
  std::span<const LanePoint> points() const { return points_; }
  const LanePoint& point(Index v) const { return points_[v]; }
  /// At the start, as all of the surface.
  std::size_t n_faces() const { return n_faces_; }
  /// Frozen vertices with faces.
  std::size_t n_frozen() const { return n_frozen_; }
  /// With stars, ascending. As at the beginning of the round.
  std::span<const Index> vertices() const { return vertices_; }

  /// As at the beginning of the round, or when v was merged; empty if it has none.
  std::span<const LinkEdge> star(Index v) const { return std::span(*corners_).subspan(stars_[v].begin, stars_[v].n); }
  /// The numbers of these faces in the surface. \pre with numbers
  std::span<const Index> faces_in_star(Index v) const {
    return std::span(*corner_faces_).subspan(stars_[v].begin, stars_[v].n);
  }
  /// What a vertex of the beginning of the round is now.
  Index now(Index v) const { return merged_into_[v]; }

  /// \param star of the merged vertex: the faces of a without b, then those of b without a, as they are now
  void merge(const VertexPair& pair, Index removed, const Vec3& position, std::span<const LinkEdge> star);

  /// Begins a round: leaves out the faces that have vanished. The same on any number of threads.
  void begin_round(unsigned threads);

  /// The faces as they are now, in any order. \pre no vertex is frozen
  std::vector<Triangle> faces_now() const;
  /// What each vertex has become since the start.
  std::vector<Index> merged_into() const;

 private:
  struct Star {
    std::size_t begin = 0;  ///< in `corners_`
    Index n = 0;            ///< faces
  };
  void list_vertices(std::span<const std::uint8_t> frozen);
  void list_stars(std::span<const Triangle> faces);
  void number_stars(std::span<const Triangle> faces, std::vector<std::size_t> places);
  void append_numbers(const VertexPair& pair);
  void move_star(Index v, std::size_t to);
  void move_numbers(Index v, std::size_t to);

  std::vector<LanePoint> points_;
  std::vector<Index> vertices_;
  std::vector<Index> merged_into_;  ///< in the round in which it was merged; itself if it wasn't
  std::vector<Star> stars_;         ///< per vertex
  std::size_t n_faces_ = 0;
  std::size_t n_frozen_ = 0;
  bool has_numbers_;
  // By vertex, its faces. Those of the next round are made from those of this one.
  std::vector<LinkEdge>* corners_;
  std::vector<LinkEdge>* next_corners_;
  std::vector<Index>* corner_faces_;
  std::vector<Index>* next_corner_faces_;
  std::size_t end_ = 0;  ///< of what is used of `corners_`
};

}  // namespace whittle
