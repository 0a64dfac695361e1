#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "whittle/simplify/simplify.hh"
#include "whittle/web/options.hh"

namespace whittle::web {

/// What is known of a result beside its mesh.
struct JobReport {
  double n_vertices_before = 0;  ///< without duplicates
  double n_faces_before = 0;
  double stop = 0;  ///< a number of `StopReason`
  double max_cost = 0;
  double proven_error = -1;  ///< model units; −1: none
  double n_contractions = 0;
  double n_folded_texture_faces = 0;
};

/// A run whose levels can be had.
struct RecordedRun;

/// A mesh, options, and the result. JavaScript fills the first two. Native programs do the same, for the tests.
struct Job {
  IndexedMesh mesh;                  ///< a vertex per row of the arrays that are given
  std::vector<std::uint8_t> locked;  ///< by row, or empty
  Settings settings;
  std::vector<std::uint64_t> levels;  ///< counts of faces, descending; empty: one result, by the targets

  std::vector<IndexedMesh> results;  ///< a vertex for each different set of attributes
  std::vector<Index> vertex_map;     ///< of the last result: given rows → one of its vertices, or `invalid_index`
  std::vector<Index> face_origins;   ///< of the last result: its faces → given faces
  JobReport report;
  std::shared_ptr<RecordedRun> recorded;  ///< null before `record`

  /// Joins rows with one position to vertices with wedges, simplifies, and makes a vertex of each wedge again.
  /// \throw std::invalid_argument as `simplify`, or without a target
  void simplify();

  /// Simplifies likewise and keeps all levels, of which the last one is the result. Attributes are carried along, and
  /// not fitted to the given ones in the end.
  void record();
  /// Makes a level of the recorded run the result: the first one with at most so many faces or, if `counts_vertices`,
  /// vertices, else the last one. \pre `record`
  void take_level(std::uint64_t n, bool counts_vertices);

  /// Faces over the rows as given, which stay where they are, by plain quadrics with uniform weights. Rows with one
  /// position stay, unless `may_open_seams`: then they may come apart.
  /// \param max_distance limit of the root of a vertex's summed squared distances to planes, model units
  /// \return the greatest of the contractions made
  double simplify_indices(std::size_t n_faces, double max_distance, bool may_open_seams);
};

/// For each row the first row with the same position.
std::vector<Index> first_of_same_position(std::span<const Vec3> positions);

}  // namespace whittle::web
