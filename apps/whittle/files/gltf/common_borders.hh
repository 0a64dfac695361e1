#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/input.hh"
#include "terminal/talk.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::app {

/// The vertices of an input that have to stay, as `GltfFile::held_borders` has them; says how many. Empty if the input
/// isn't a glTF file that keeps its meshes.
std::vector<std::uint8_t> held_borders(const Input& input, unsigned threads, const Talk& talk,
                                       std::vector<std::string>& warnings);

/// Makes several vertices one, with a wedge for each where their attributes differ. Faces stay.
/// \param joined V; for each vertex the one that it becomes, which is none after it and becomes itself
/// \pre the mesh has origins \return V; their new numbers
std::vector<Index> join_vertices(IndexedMesh& mesh, std::span<const Index> joined);

}  // namespace whittle::app
