#pragma once

#include <cstddef>
#include <iosfwd>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/progressive/replay.hh"

// A continuous way between two levels of detail: each vertex of the finer one goes to the place of the vertex that it
// went into. \cite hoppe_1996_progressive (geomorphs)

namespace whittle::progressive {

/// How normals go from one level to the other.
enum class NormalBlend {
  spherical,  ///< at a constant angular speed, along any great circle between opposite normals
              ///< (\cite shoemake_1985_rotation: slerp)
  linear      ///< on the straight line, and then of unit length; the finer level's normal where that has no direction
};

/// The surface between two levels of a replay. It has the vertices and the faces of the finer level at any time. At the
/// coarser level, faces that were contracted have no area. Where coincident faces became one, they still coincide.
class Geomorph {
 public:
  /// Leaves the replay at the coarser level. Normals are those of the levels, or by area where the input has none.
  /// \throw std::out_of_range if there is no such level
  /// \throw std::invalid_argument if `coarse_level` is below `fine_level`, or if a pass of polish between them flips
  ///        edges: no movement of vertices leads from one to the other
  Geomorph(Replay& replay, std::size_t fine_level, std::size_t coarse_level);

  const IndexedMesh& fine() const { return fine_; }
  /// The vertices and the faces of `fine()`, with each vertex where its ancestor is at the coarser level.
  const IndexedMesh& coarse() const { return coarse_; }
  std::size_t n_coarse_faces() const { return n_coarse_faces_; }

  /// Positions and colours are interpolated linearly, without rounding at both ends.
  /// \param share 0 = `fine()`, 1 = `coarse()`; what lies outside is clamped
  IndexedMesh at(double share, NormalBlend blend = NormalBlend::spherical) const;

 private:
  IndexedMesh fine_;
  IndexedMesh coarse_;
  std::size_t n_coarse_faces_ = 0;
};

/// Writes a geomorph as glTF 2.0 (binary, `.glb`): one mesh of the finer level, with one morph target. The target's
/// weight is 0 at the finer level and 1 at the coarser one. An animation of four seconds goes there and back.
/// Positions, normals and colours are rounded to 32 bits. glTF interpolates normals linearly.
/// \param out a stream that was opened in binary mode; its state says whether all could be written
/// \throw std::range_error for a coordinate that 32 bits can't hold
/// \throw std::length_error for more than 4 GiB; std::invalid_argument if there is no face
void write_glb(std::ostream& out, const Geomorph& geomorph);

}  // namespace whittle::progressive
