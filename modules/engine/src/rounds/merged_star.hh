#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "complex/link.hh"
#include "guard/border_motion.hh"
#include "rounds/round_mesh.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

/// The faces that the merged vertex of a pair will have: those of a without b, then those of b without a.
class MergedStar {
 public:
  explicit MergedStar(const RoundMesh& mesh) : mesh_(mesh), marks_(mesh.n_vertices()) {}

  /// Looks at a pair, both vertices of which are left, as their faces are now.
  /// \return whether the contraction keeps the topology (the link condition, link_condition.hh)
  /// \param is_irregular of each vertex, false if its faces are one closed fan
  bool gather(const VertexPair& pair, std::array<bool, 2> is_irregular);

  std::size_t n_faces() const { return n_; }
  std::span<const LinkEdge> others() const { return std::span(others_).first(n_); }
  LinkEdge others(std::size_t i) const { return others_[i]; }
  Index apex(std::size_t i) const { return i < n_first_ ? pair_.a : pair_.b; }
  /// The third corners of the faces that vanish. \pre the condition holds
  std::span<const Index> opposites() const { return {opposites_.data(), n_opposite_}; }

  /// Those faces, by their places in the star of a. \pre the condition holds
  std::span<const Index> vanishing() const { return {vanishing_.data(), n_opposite_}; }

  /// The sums for one star of the pair, as its faces are now. \param end 0 or 1 \pre the condition holds
  StarPlanes planes(std::size_t end, const QuadricOptions& options);

  /// \param a, b the sums of the two stars \param origin of the result
  StarVolume volume(const StarPlanes& a, const StarPlanes& b, const Vec3& origin) const;
  /// Whether a face turns too far, or loses its area, if the vertex is at `position`.
  bool exceeds(const FlipLimit& limit, const Vec3& position);
  /// About how far the faces move, as `MergedRing::displacement_sq` says.
  double displacement_sq(const Vec3& position) const;
  /// The square of l sin α: the longest edge at the merged vertex, and the greatest turn of a face, if that is less
  /// than a right angle; else of l.
  double turn_sq(const Vec3& position) const;
  /// The faces of the pair. \pre the condition holds
  StarsOfPair stars() const { return {{others_at(0), others_at(1)}, opposites()}; }

 private:
  struct Kernels;
  void note_vanishing(Index slot, Index opposite, double turn) {
    make_room(vanishing_, n_opposite_ + 1);
    make_room(opposites_, n_opposite_ + 1);
    make_room(turns_, n_opposite_ + 1);
    vanishing_[n_opposite_] = slot;
    opposites_[n_opposite_] = opposite;
    turns_[n_opposite_++] = turn;
  }
  bool keeps_topology(std::array<bool, 2> is_irregular);
  std::span<const LinkEdge> others_at(std::size_t end) const {
    return end == 0 ? std::span(others_).first(n_first_) : std::span(others_).subspan(n_first_, n_ - n_first_);
  }
  std::span<const LinkEdge> gather_faces(std::size_t end);
  double farthest_sq(const Vec3& from) const;

  const RoundMesh& mesh_;
  VertexPair pair_{};
  std::vector<LinkEdge> others_;  ///< of each face, as the mesh lists them; and some more at the end
  std::size_t n_first_ = 0;
  std::size_t n_ = 0;
  // Of each common face; the lists may be longer
  std::vector<Index> vanishing_;
  std::vector<Index> opposites_;
  std::vector<double> turns_;  ///< 1 if the face is (a, b, opposite), −1 if it is (b, a, opposite)
  std::size_t n_opposite_ = 0;
  std::vector<LinkEdge> all_;  ///< scratch: the faces of one star
  std::vector<Index> marks_;   ///< per vertex, the look that found it next to a
  Index n_looks_ = 0;
  std::optional<Link> link_;  ///< scratch, if there is an irregular vertex
};

}  // namespace whittle
