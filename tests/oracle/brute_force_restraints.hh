#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle::test {

/// Locked vertices and feature lines, by their definitions. Remembered is what these speak of: how free each vertex is,
/// which edges are features, and where the line was that each of them stands for.
class BruteForceRestraints {
 public:
  using Edge = std::pair<Index, Index>;  ///< lower vertex first

  BruteForceRestraints() = default;
  /// \param positions in the frame \param faces of the mesh, those without three corners left out
  /// \param locked per vertex \param tolerance how far a line may come to lie from what it was, in the frame
  BruteForceRestraints(std::span<const Vec3> positions, std::span<const Triangle> faces,
                       const std::vector<bool>& locked, const DecimateOptions& options, double tolerance);

  /// Where a pair may go; nullopt if neither vertex may leave its place.
  std::optional<Pinned> pinned(Index a, Index b) const;

  /// Whether contracting (a, b) to `position` keeps every feature line a line, near where it was.
  bool keeps_lines(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                   const Vec3& position) const;
  /// Whether it leaves no edge sharp that wasn't and is no feature, and no feature edge blunt that was sharp.
  /// \param after the faces there would be, a the merged vertex
  bool keeps_sharpness(std::span<const Vec3> positions, std::span<const Triangle> faces,
                       std::span<const Triangle> after, Index a, Index b, const Vec3& position) const;

  /// \param positions before, \param after the faces after the contraction
  void contract(std::span<const Vec3> positions, std::span<const Triangle> after, Index survivor, Index removed,
                const Vec3& position);

  std::vector<Edge> feature_edges() const;

 private:
  enum class Freedom { full, line, corner, locked };  ///< each less than the one before
  using Course = std::vector<Vec3>;

  bool may_move(Index v, bool along_feature) const;
  bool is_feature(Index a, Index b) const;
  /// Which vertex of a feature edge goes to the other, and the other feature edge that it takes along.
  struct Move {
    Index moved;
    std::optional<Edge> next;
  };
  Move move_along(Index a, Index b, const Vec3& from_a, const Vec3& to) const;
  void mark_freedoms(std::span<const Vec3> positions, double corner_angle_deg);
  /// Whether the edge has two faces, and their normals differ by more than the angle.
  bool is_sharp(std::span<const Vec3> positions, std::span<const Triangle> faces, Index x, Index y) const;

  double sharp_angle_deg_ = 180;
  double tolerance_ = 0;
  std::vector<Freedom> freedoms_;    ///< per vertex
  std::map<Edge, Course> features_;  ///< with where the line between the ends went
};

}  // namespace whittle::test
