#pragma once

#include <string>
#include <vector>

#include "files/gltf_file.hh"
#include "files/input.hh"
#include "files/output.hh"

namespace whittle::app {

/// Writes a mesh that was not read from glTF as a glTF file, with the materials of its libraries. Images become part of
/// a .glb, and are copied beside a .gltf. Warns of what is left out.
/// \param mesh what `input` has, or has become \param levels of it \param compress as
/// `gltf::WriteOptions` has it \throw io::WriteError if a coordinate is too large for glTF
void write_new_gltf(OutputFiles& files, const std::string& path, const Input& input, const IndexedMesh& mesh,
                    CoarserLevels levels, bool compress, const Talk& talk, std::vector<std::string>& warnings);

}  // namespace whittle::app
