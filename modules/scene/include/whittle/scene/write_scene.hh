#pragma once

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/output_files.hh"
#include "whittle/scene/format.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// What messages call an output: its path, or "standard output".
std::string name_of(const SceneOutput& output);

/// Writes what has become of a scene, with all that a file of the output's format can say of it, and the files that it
/// needs beside it. A document stays what it is in all but its meshes.
/// \param mesh that of the scene, simplified or as it is
/// \throw io::WriteError if a file can't be written, or the format can't hold a coordinate
void write_scene(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                 SceneMessages& messages);

/// Writes a scene with coarser levels of detail beside it, as the extension MSFT_lod has them.
/// \param levels of the scene, the finer ones first \pre the output's format `is_document`, and is written once
void write_levels(io::OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels,
                  SceneMessages& messages);

/// The mesh as it is read again from what `write_scene` writes without compression.
/// A vertex that the file has several times has one place in it.
/// \param options how it is read
IndexedMesh as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                       const SceneReadOptions& options);
/// How far the places of such a vertex lie apart at most.
double widest_gap_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh);

}  // namespace whittle
