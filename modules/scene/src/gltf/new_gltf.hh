#pragma once

#include "whittle/scene/format.hh"

namespace whittle {

/// Writes a mesh that was not read from glTF, or all that a scene of one shows, as a new glTF file, with the materials
/// of its libraries. Images become part of a .glb, and are copied beside a .gltf. Warns of what is left out. \param
/// mesh what the scene has, or has become \param levels of it \throw io::WriteError if a coordinate is too large for
/// glTF
void write_new_gltf(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                    CoarserLevels levels, SceneMessages& messages);

}  // namespace whittle
