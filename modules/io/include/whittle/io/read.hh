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
#include "whittle/io/format.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

struct ReadOptions {
  /// Weld exact duplicates that lie on open borders (`weld_borders`). Default true; false keeps them apart.
  bool weld = true;
  /// What the file is. Default: by the name's ending. Content that is evidently something else is an error either way.
  std::optional<Format> format{};
};

struct ReadResult {
  /// At least one face; every vertex is referenced; `origins` is filled and ascending (the number of the vertex in the
  /// file, from 0; in STL, of the corner). Normals and colours are filled when the file has them for vertices.
  IndexedMesh mesh;
  /// `file_vertices` numbers: the vertex of `mesh` each vertex of the file became, `invalid_index` for those dropped.
  /// Vertices welded together became the same.
  std::vector<Index> vertex_map;
  /// What was repaired, kind by kind.
  Repairs repairs;
  /// One line each, without a full stop: what the file has and the mesh doesn't carry, what was read leniently.
  std::vector<std::string> warnings;
  Format format = Format::obj;
  std::size_t file_vertices = 0;  ///< As stored, before repairs; in STL three a facet.
  std::size_t file_faces = 0;     ///< As stored: polygons before triangulation; a tristrip counts its triangles.
};

/// Reads a mesh file: triangulates polygons, then `repair` (repair.hh). docs/user/formats.md says what is carried.
/// \throw ReadError for anything that isn't a complete, valid mesh file with at least one face left after repairs.
/// \throw std::bad_alloc only for files that truly are too large for the memory: counts are checked against the size.
ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Likewise from memory (standard input, tests).
/// \param name shown in errors; its ending tells the format when `options.format` doesn't.
ReadResult read_mesh(std::span<const char> bytes, std::string_view name, const ReadOptions& options = {});

/// The whole of an open file descriptor, such as standard input (0), for the overload above.
/// \throw ReadError with `name` when reading fails.
std::vector<char> read_all(int descriptor, std::string_view name);

}  // namespace whittle::io
