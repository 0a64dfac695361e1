#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle::test {

/// The faces at both ends of an inner edge (a, b), found by their corners' numbers. Those of a come first, starting
/// after a common face, then those of b. Sums have the order that the engine promises: four sums, each over every
/// fourth face. So they agree to the bit.
class FacesAroundPair {
 public:
  /// \pre a and b each have one closed fan of faces, all of one orientation; each has faces that the other doesn't have
  /// \param origin the coordinates are relative to it
  FacesAroundPair(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                  const Vec3& origin);

  /// Of the faces before the contraction.
  StarVolume volume() const;
  /// The largest of three squared distances, if a and b became one vertex at `apex`: from `apex` to the faces before,
  /// and from a and from b to the faces after.
  double displacement_sq(const Vec3& apex) const;
  /// Sum of the faces' planes if a and b became one vertex at `apex`.
  SymmetricMatrix planes(const Vec3& apex, const QuadricOptions& options) const;

 private:
  /// A face at one end; that end comes first.
  using Corners = std::array<Vec3, 3>;

  std::vector<Corners> faces_;     ///< at one end only
  std::array<Corners, 2> common_;  ///< at both ends
};

/// The change of the sum of planes of the faces at v when a and b become one vertex at `position`.
/// \pre v has two faces at the merged vertex
/// \param origin the coordinates are relative to it
SymmetricMatrix change_of_planes(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                                 Index v, const Vec3& position, const Vec3& origin, const QuadricOptions& options);

/// Which vertices have the planes of their current faces, and which have the planes of all vertices merged into them.
class BruteForceMemory {
 public:
  /// \param faces of the input mesh
  BruteForceMemory(std::span<const Vec3> positions, std::span<const Triangle> faces,
                   const std::vector<bool>& is_on_seam);

  /// Of the vertices with a ring: each face counts once for every such corner.
  const MeanFaceArea& face_area() const { return face_area_; }

  /// Whether the merged vertex of a and b has the planes of its own faces only, and those of seams.
  /// \param is_nonmanifold whether the contraction needs more than the link condition
  bool forgets(Index a, Index b, bool is_nonmanifold) const { return !is_nonmanifold && is_ring_[a] && is_ring_[b]; }
  /// The neighbours of a and b that have the planes of their own faces, before and after the contraction.
  std::vector<Index> forgetful_neighbours(Index a, Index b, bool is_nonmanifold, std::span<const Triangle> faces) const;

  /// \param before, after the faces before and after the contraction
  void contract(Index survivor, Index removed, bool is_nonmanifold, std::span<const Triangle> before,
                std::span<const Triangle> after);

 private:
  std::vector<bool> is_ring_;  ///< its faces were one closed fan of one orientation when last looked at: at first, and
                               ///< after non-manifold contractions; two that merge are one if both were
  std::vector<bool> remembers_;
  MeanFaceArea face_area_;
};

}  // namespace whittle::test
