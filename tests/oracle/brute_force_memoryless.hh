#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle::test {

/// The faces at both ends of an inner edge (a, b), found by their corners' numbers: first those of a, from the one
/// after a face of both on, then those of b. Sums have the order that the engine promises: four sums, each over every
/// fourth face, so that they agree to the bit.
class FacesAroundPair {
 public:
  /// \pre the faces at a, and those at b, are one closed fan each, all of one orientation; of either some are not the
  /// other's
  /// \param origin what all is seen from
  FacesAroundPair(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                  const Vec3& origin);

  /// Of the faces as they are.
  StarVolume volume() const;
  /// How far they would move, were a and b one vertex at `apex`.
  double displacement_sq(const Vec3& apex) const;
  /// The sum of the faces' planes, were a and b one vertex at `apex`.
  SymmetricMatrix planes(const Vec3& apex, const QuadricOptions& options) const;

 private:
  /// A face of one end, that end first.
  using Corners = std::array<Vec3, 3>;

  std::vector<Corners> faces_;     ///< of one end alone
  std::array<Corners, 2> common_;  ///< of both
};

/// By how much the planes of the faces at v change if a and b become one vertex at `position`.
/// \pre v is to have two faces at that vertex
/// \param origin what all is seen from
SymmetricMatrix change_of_planes(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                                 Index v, const Vec3& position, const Vec3& origin, const QuadricOptions& options);

/// Which vertices have the planes of their faces as these are now, and which have those of all they have merged.
class BruteForceMemory {
 public:
  /// \param faces of the mesh as it is at first
  BruteForceMemory(std::span<const Vec3> positions, std::span<const Triangle> faces);

  /// Of those at rings, each as often as it has corners there.
  const MeanFaceArea& face_area() const { return face_area_; }

  /// Whether the vertex that a and b are merged into is to have the planes of its faces alone.
  /// \param is_joint whether the contraction needs more than the link condition
  bool forgets(Index a, Index b, bool is_joint) const { return !is_joint && is_ring_[a] && is_ring_[b]; }
  /// The vertices beside a and b that have them already, and go on having them.
  std::vector<Index> forgetful_neighbours(Index a, Index b, bool is_joint, std::span<const Triangle> faces) const;

  /// \param before, after the faces
  void contract(Index survivor, Index removed, bool is_joint, std::span<const Triangle> before,
                std::span<const Triangle> after);

 private:
  std::vector<bool> is_ring_;  ///< its faces were one closed fan of one orientation when last looked at: at first, and
                               ///< after joints; two that merge are one if both were
  std::vector<bool> remembers_;
  MeanFaceArea face_area_;
};

}  // namespace whittle::test
