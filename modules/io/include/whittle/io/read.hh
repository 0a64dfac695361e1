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

/// Which attributes are read.
enum class AttributeScope {
  per_vertex,  ///< Normals and colours, one of each a vertex: of welded vertices that of the lowest, in OBJ their mean.
  all          ///< Everything that `IndexedMesh` holds. A vertex may have several wedges.
};

struct ReadOptions {
  /// Whether to weld exact duplicates of vertices on open borders (`weld_borders`).
  bool weld = true;
  /// Default: by the name's extension. Content that is evidently of another format is an error in any case.
  std::optional<Format> format{};
  /// Largest number of threads; 0 = all cores. The result is the same for any number.
  unsigned threads = 0;
  /// For callers that can't take wedges, groups, or attributes of faces: `per_vertex`.
  AttributeScope attributes = AttributeScope::all;
};

struct ReadResult {
  /// At least one face. Every vertex has a face. `origins` is filled and ascends: the vertex's number in the file, from
  /// 0; in STL, the corner's. Attributes are filled as far as the file has them; docs/user/formats.md says which.
  IndexedMesh mesh;
  /// What the file says beside the mesh. To be given to the writer.
  FileNotes notes;
  /// `file_vertices` numbers: the vertex of `mesh` that each vertex of the file became, `invalid_index` if it was
  /// dropped. Vertices that were welded together became the same.
  std::vector<Index> vertex_map;
  /// `file_vertices` numbers, as stored: PLY's vertex property `tolerance`. Empty if there is none. The mesh doesn't
  /// carry it.
  std::vector<double> tolerances;
  /// Counts of each kind of repair.
  Repairs repairs;
  /// One line each, without a full stop: what the mesh doesn't carry, and which irregularities were accepted.
  std::vector<std::string> warnings;
  Format format = Format::obj;
  std::size_t file_vertices = 0;  ///< As stored, before repairs. In STL three per facet.
  std::size_t file_faces = 0;     ///< As stored: polygons count once, tristrips by their triangles.
};

/// Reads a mesh file, unpacks it if its content is gzip data, triangulates polygons, then repairs (`repair`).
/// docs/user/formats.md says what is carried. \throw ReadError if the file isn't a complete and valid mesh file, or if
/// no face is left after repairs. \throw std::bad_alloc only if the file is too large for the memory. Counts are
/// checked against the file's size before anything is allocated.
ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Likewise from memory.
/// \param name for messages. Its extension tells the format if `options.format` is empty.
ReadResult read_mesh(std::span<const char> bytes, std::string_view name, const ReadOptions& options = {});

/// Reads an open file descriptor, such as standard input (0), up to its end. For the overload above.
/// \param name for messages. \throw ReadError if reading fails.
std::vector<char> read_all(int descriptor, std::string_view name);

}  // namespace whittle::io
