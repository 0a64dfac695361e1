#pragma once

#include <cstddef>
#include <iosfwd>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/progressive/replay.hh"

// A continuous transition between two levels of detail: each vertex of the finer level moves to the position of its
// ancestor. \cite hoppe_1996_progressive (geomorphs)

namespace whittle::progressive {

/// Interpolation of normals between two levels.
enum class NormalBlend {
  spherical,  ///< at a constant angular speed, along any great circle between opposite normals
              ///< (\cite shoemake_1985_rotation: slerp)
  linear      ///< on the straight line, and then of unit length; the finer level's normal where that has no direction
};

/// The surface between two levels of a replay, with the vertices and faces of the finer level. At the coarser level,
/// contracted faces have no area, and faces joined into one coincide.
class Geomorph {
 public:
  /// Leaves the replay at the coarser level. Normals come from the levels, or by area if the input has none.
  /// \throw std::out_of_range for an unknown level
  /// \throw std::invalid_argument if `coarse_level` is below `fine_level`, or if a pass of polish between them flips
  ///        edges: then vertices can't move from one to the other
  Geomorph(Replay& replay, std::size_t fine_level, std::size_t coarse_level);

  const IndexedMesh& fine() const { return fine_; }
  /// The vertices and faces of `fine()`, with each vertex at the position of its ancestor at the coarser level.
  const IndexedMesh& coarse() const { return coarse_; }
  std::size_t n_coarse_faces() const { return n_coarse_faces_; }

  /// The surface in between. Positions and colours are interpolated linearly, exact at both ends.
  /// \param share 0 = `fine()`, 1 = `coarse()`; clamped
  IndexedMesh at(double share, NormalBlend blend = NormalBlend::spherical) const;

 private:
  IndexedMesh fine_;
  IndexedMesh coarse_;
  std::size_t n_coarse_faces_ = 0;
};

/// Writes a geomorph as glTF 2.0 (binary, `.glb`): one mesh of the finer level, with one morph target. The target's
/// weight is 0 at the finer level and 1 at the coarser one. An animation of four seconds goes there and back.
/// Positions, normals and colours are rounded to 32 bits. glTF interpolates normals linearly.
/// \param out a stream in binary mode; its state shows write errors
/// \throw std::range_error for a coordinate that 32 bits can't hold
/// \throw std::length_error for more than 4 GiB; std::invalid_argument without a face
void write_glb(std::ostream& out, const Geomorph& geomorph);

}  // namespace whittle::progressive
