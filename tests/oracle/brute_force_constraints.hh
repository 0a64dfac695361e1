#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle::test {

/// Locked vertices and feature lines, by their definitions. Stores how freely each vertex may move, which edges are
/// features, and the course of the line that each of them stands for.
class BruteForceConstraints {
 public:
  using Edge = std::pair<Index, Index>;  ///< lower vertex first

  BruteForceConstraints() = default;
  /// \param positions in the frame \param faces of the mesh, without collapsed faces
  /// \param locked per vertex \param tolerance how far a line may move away from its course, in the frame
  BruteForceConstraints(std::span<const Vec3> positions, std::span<const Triangle> faces,
                        const std::vector<bool>& locked, const DecimateOptions& options, double tolerance,
                        std::span<const VertexPair> seams);

  const std::set<Edge>& seams() const { return seams_; }
  bool is_seam(Index a, Index b) const { return seams_.contains(std::minmax(a, b)); }

  /// Where the merged vertex of a pair may go; nullopt if neither vertex may move.
  std::optional<PairConstraint> of(Index a, Index b) const;

  /// Whether contracting (a, b) to `position` keeps all feature lines, and keeps them within the tolerance.
  bool keeps_lines(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                   const Vec3& position) const;
  /// Whether each feature edge has a face after a contraction.
  bool keeps_edges(std::span<const Triangle> after, Index survivor, Index removed) const;
  /// Whether no edge becomes sharp unless it is a feature, and no sharp feature edge becomes blunt.
  /// \param after the faces after the contraction, a being the merged vertex
  bool keeps_sharpness(std::span<const Vec3> positions, std::span<const Triangle> faces,
                       std::span<const Triangle> after, Index a, Index b, const Vec3& position) const;

  /// \param positions before, \param after the faces after the contraction
  void contract(std::span<const Vec3> positions, std::span<const Triangle> after, Index survivor, Index removed,
                const Vec3& position);

  std::vector<Edge> feature_edges() const;

 private:
  enum class Constraint { free, on_line, at_corner, locked };  ///< the weakest first
  using Course = std::vector<Vec3>;

  bool may_move(Index v, bool along_feature) const;
  bool is_feature(Index a, Index b) const;
  /// The vertex of a feature edge that moves to the other one, and the next feature edge at it, which moves, too.
  struct Move {
    Index moved;
    std::optional<Edge> next;
  };
  Move move_along(Index a, Index b, const Vec3& from_a, const Vec3& to) const;
  void mark_constraints(std::span<const Vec3> positions, double corner_angle_deg);
  /// Whether the edge has two faces, and their normals differ by more than the angle.
  bool is_sharp(std::span<const Vec3> positions, std::span<const Triangle> faces, Index x, Index y) const;

  double sharp_angle_deg_ = 180;
  bool seams_have_planes_ = false;  ///< in the cost; or merged vertices on them go to an end
  bool seams_give_way_ = false;     ///< then they are no features
  std::set<Edge> seams_;            ///< those that only the cost holds in place
  double tolerance_ = 0;
  std::vector<Constraint> constraints_;  ///< per vertex
  std::map<Edge, Course> features_;      ///< with the course of the line between the ends
};

}  // namespace whittle::test
