#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/io/format.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

/// The attributes to read.
enum class AttributeScope {
  per_vertex,  ///< Normals and colours, one per vertex: welded vertices get the lowest one's, in OBJ the mean.
  all          ///< All attributes of `IndexedMesh`. A vertex may have several wedges.
};

struct ReadOptions {
  /// Whether to weld exact duplicates of vertices on open borders (`weld_borders`).
  bool weld = true;
  /// Default: by the name's extension. Content of evidently another format is an error in any case.
  std::optional<Format> format{};
  /// Largest number of threads; 0 = all cores. The result is the same for any number.
  unsigned threads = 0;
  /// `per_vertex` is for callers without wedges, groups, or attributes of faces.
  AttributeScope attributes = AttributeScope::all;
};

struct ReadResult {
  /// At least one face. Every vertex has a face. `origins` is filled and ascends: the vertex's number in the file, from
  /// 0; in STL, the corner's. docs/user/formats.md lists the attributes.
  IndexedMesh mesh;
  /// Content of the file beside the mesh, for the writer.
  FileNotes notes;
  /// `file_vertices` numbers: for each vertex of the file its vertex in `mesh`, `invalid_index` if it was dropped.
  /// Welded vertices have the same number.
  std::vector<Index> vertex_map;
  /// `file_vertices` numbers, as stored: PLY's vertex property `tolerance`; or empty. The mesh doesn't have it.
  std::vector<double> tolerances;
  /// Counts of each kind of repair.
  Repairs repairs;
  /// One line each, without a full stop: content that was lost, and irregularities that were accepted.
  std::vector<std::string> warnings;
  Format format = Format::obj;
  std::size_t file_vertices = 0;  ///< As stored, before repairs. In STL three per facet.
  std::size_t file_faces = 0;     ///< As stored: polygons count once, tristrips by their triangles.
};

/// Reads a mesh file, decompresses gzip data, triangulates polygons, then repairs (`repair`). docs/user/formats.md
/// lists the content that is kept. Counts are checked against the file's size before anything is allocated.
/// \throw ReadError if the file isn't a complete and valid mesh file, or if no face is left after repairs
/// \throw std::bad_alloc only if the file is too large for the memory
ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from memory.
/// \param name for messages. Its extension gives the format if `options.format` is empty.
ReadResult read_mesh(std::span<const char> bytes, std::string_view name, const ReadOptions& options = {});

/// A mesh in memory, as if it had been read: with all repairs. Its format is PLY, which keeps every attribute.
/// \param mesh with finite positions, corners below V, and arrays that are empty or full; it has no origins yet
/// \param name for messages
/// \throw ReadError if it has no faces, or none is left after repairs
ReadResult take_mesh(IndexedMesh mesh, std::string_view name, const ReadOptions& options = {});

/// Reads an open file descriptor, such as standard input (0), up to its end, for the overload above.
/// \param name for messages. \throw ReadError if reading fails.
std::vector<char> read_all(int descriptor, std::string_view name);

}  // namespace whittle::io
