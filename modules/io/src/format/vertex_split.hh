#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/file_notes.hh"

// Fits a mesh to the capabilities of a format, for writers.

namespace whittle::io {

/// Attributes that a format stores at vertices.
struct VertexStorage {
  bool normals = false;
  bool colors = false;
  std::vector<std::size_t> attributes;  ///< which of the mesh
};

/// The mesh with these attributes alone, and a vertex for each of their different values. Faces keep their order and
/// corners. Nothing if the mesh has no wedges: it can be written as it is.
std::optional<IndexedMesh> split_for(const IndexedMesh& mesh, const VertexStorage& storage);

/// Adds "TITLE can't hold the vertex attributes a, b: they are left out", if there are any.
/// \param what "vertex attribute"
void warn_of_lost(std::string_view title, std::string_view what, const std::vector<std::string>& names,
                  std::vector<std::string>& warnings);

/// Likewise of materials, and of the textures that a file names.
void warn_of_lost_groups(std::string_view title, const IndexedMesh& mesh, const FileNotes& notes,
                         std::vector<std::string>& warnings);

/// The first texture coordinates with a number of components from `fewest` to `most`.
std::optional<std::size_t> find_texcoords(const IndexedMesh& mesh, std::size_t fewest, std::size_t most);

/// The names of all attributes but one.
std::vector<std::string> names_of_others(const std::vector<Attribute>& attributes, std::optional<std::size_t> but);

}  // namespace whittle::io
