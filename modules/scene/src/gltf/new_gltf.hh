#pragma once

#include "whittle/scene/format.hh"

namespace whittle {

/// Writes a mesh of another format, or the shown scene of a glTF file, as a new glTF file, with its materials. Images
/// are embedded in a .glb, and copied beside a .gltf. Warns of lost content.
/// \param mesh the scene's mesh, or one made from it
/// \param levels coarser levels of it
/// \throw io::WriteError if a coordinate is too large for glTF
void write_new_gltf(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                    CoarserLevels levels, SceneMessages& messages);

}  // namespace whittle
