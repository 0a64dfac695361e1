#pragma once

#include <string>
#include <vector>

#include "whittle/scene/scene.hh"

namespace whittle {

/// The vertex property `tolerance` of the file that a mesh was read from.
/// \param name of the file, for messages
/// \return of each vertex of the mesh, model units: of those that became one, the least; empty if the file has none
/// \throw UnsupportedMesh if one is not above 0
std::vector<double> tolerances_of_file(const io::ReadResult& read, const std::string& name);

/// Reads a text with a length a line, for each vertex of the file that a mesh was read from, in its order: model units,
/// or a percentage of the diagonal.
/// \return of each vertex of the mesh, model units: of those that became one, the least
/// \throw io::ReadError if the text can't be read, a line has no length above 0, or there are more or fewer lines than
///        vertices
std::vector<double> read_tolerance_map(const std::string& path, const io::ReadResult& read, double diagonal);

}  // namespace whittle
