#pragma once

#include "whittle/gltf/asset.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// Writes a mesh of another format, or the shown scene of a glTF file, as a new glTF file, with its materials. Images
/// are embedded in a .glb, and copied beside a .gltf. Warns of lost content.
/// \param mesh the scene's mesh, or one made from it
/// \param levels coarser levels of it
/// \throw io::WriteError if a coordinate is too large for glTF
void write_new_gltf(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                    CoarserLevels levels, SceneMessages& messages);

/// The file as it is read again, but for materials. \throw as `write_new_gltf`
gltf::Asset new_gltf_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh);

}  // namespace whittle
