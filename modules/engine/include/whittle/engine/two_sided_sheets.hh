#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// A mesh with two-sided sheets (`fronts_of_backs`), and the same mesh without their backs. That one is a surface that
/// can be contracted; `add_backs` gives the result its backs again. `decimate` and `simplify` do so by themselves.
///
/// A face of the result has a back if its origin had one. Where a sheet ends at faces with one side, and where the
/// groups or face attributes of either side change, is a border of regions (`seam_edges`). Where corners of backs have
/// wedges of their own, both sides are carried together: a wedge has the attributes of the front, then those of the
/// back.
class TwoSidedSheets {
 public:
  /// Keeps a reference to the mesh.
  /// \throw std::invalid_argument for attributes of a wrong length or that are not finite, if there is a sheet
  explicit TwoSidedSheets(const IndexedMesh& mesh, unsigned threads = 0);

  bool any() const { return !fronts_of_backs_.empty(); }
  const IndexedMesh& mesh() const { return mesh_; }
  /// The mesh without backs; its vertices are those of `mesh()`. Empty if there is no sheet.
  const IndexedMesh& without_backs() const { return without_backs_; }
  /// The face of `mesh()` that one of `without_backs()` is, and its back there, or `invalid_index`.
  Index front_of(Index face) const { return kept_[face]; }
  Index back_of(Index face) const { return back_of_[kept_[face]]; }
  bool has_back(Index face) const { return back_of(face) != invalid_index; }
  /// How many faces some of `without_backs()` are, with their backs.
  std::uint64_t n_faces_with_backs(std::span<const Index> faces) const;

  /// What `without_backs()` is decimated with: callbacks are told of about as many faces as there are with backs.
  DecimateOptions options_without_backs(DecimateOptions options) const;
  /// Steps of a run of `mesh()` as those of `without_backs()`. \throw std::invalid_argument if they turn faces that
  /// aren't there
  RunSteps steps_without_backs(RunSteps steps) const;

  /// Makes a decimation of `without_backs()` one of `mesh()`. \param normals what the run did with them
  void add_backs(Normals normals, unsigned threads, Decimation& decimation) const;

 private:
  /// A face with its back, or without.
  struct Side {
    Index origin;  ///< in `mesh_`
    Index face;    ///< of what has no backs
    bool is_back;
  };
  std::vector<Side> sides_of(std::span<const Index> face_origins) const;
  Triangle as_side(const Triangle& corners, const Side& side) const;
  void add_backs_to(RunSteps& steps) const;
  void add_backs_to(std::span<const Side> sides, Normals normals, IndexedMesh& mesh) const;

  const IndexedMesh& mesh_;
  std::vector<Index> fronts_of_backs_;
  std::vector<Index> back_of_;   ///< of each face of the mesh, or `invalid_index`
  std::vector<Index> kept_;      ///< faces of `without_backs_` → those of the mesh
  bool has_own_wedges_ = false;  ///< whether a wedge of `without_backs_` has the attributes of both sides
  IndexedMesh without_backs_;
};

}  // namespace whittle
