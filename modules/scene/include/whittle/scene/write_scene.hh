#pragma once

#include <string>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/output_files.hh"
#include "whittle/scene/format.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// Name of an output in messages: its path, or "standard output".
std::string name_of(const SceneOutput& output);

/// Whether a scene's document, with its meshes, is what is written.
bool keeps_meshes(const Scene& scene, const SceneOutput& output);

/// The options of the program that make an output round positions: "--compress and --quantize". \pre `rounds()`
std::string rounding_options(const gltf::WriteOptions& options);

/// Writes a scene with all content that the output's format supports, and the files that it needs. Of a document only
/// the meshes change.
/// \param mesh the scene's mesh, simplified or unchanged
/// \throw io::WriteError if a file can't be written, or the format can't hold a coordinate
void write_scene(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                 SceneMessages& messages);

/// Writes a scene with coarser levels of detail, by the extension MSFT_lod.
/// \param levels of the scene, finest first \pre the output's format `is_document`; the scene is written once
void write_levels(io::OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels,
                  SceneMessages& messages);

/// The mesh after `write_scene` without `gltf` options, and reading. A vertex that the file has several times has one
/// position. \param options of reading
IndexedMesh as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                       const SceneReadOptions& options);
/// What `write_scene` writes, as `SceneScope::scene` reads it: the file's vertices and faces, also of rounded ones.
/// \param options of reading; the scope doesn't count
IndexedMesh scene_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                             const SceneReadOptions& options);
/// Largest distance between the positions of such a vertex in the file.
double widest_gap_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh);

}  // namespace whittle
