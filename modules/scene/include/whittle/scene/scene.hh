#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/io/read.hh"

namespace whittle {

class SceneDocument;
struct SceneFormat;

/// Stands for standard input or output in place of a path.
inline constexpr std::string_view standard_stream = "-";

/// The meshes of a file, as one mesh, and further content of the file.
struct Scene {
  std::string path;  ///< of the file, or `standard_stream`
  std::string name;  ///< in messages: the path, or "standard input"
  const SceneFormat* format = nullptr;
  io::ReadResult read;
  double weld_tolerance = 0;                          ///< of welding, model units; 0 = exact duplicates only
  std::shared_ptr<SceneDocument> document{};          ///< for writing it again; null for a file with one mesh
  std::string mesh_name{};                            ///< name of the mesh in new documents
  std::vector<std::filesystem::path> needed_files{};  ///< buffers, material libraries, textures
  std::vector<std::string> joined{};    ///< files that were joined (`SceneJoiner`), `path` first; or empty
  std::vector<std::string> warnings{};  ///< a line each, with the name in front
};

/// Whether the document keeps its meshes separate, and simplified meshes replace them.
bool keeps_meshes(const Scene& scene);

/// How many times as long as in the scene's mesh a length can be where the scene is shown
/// (`SceneDocument::widest_stretch`). 1 if the document doesn't keep its meshes.
double widest_stretch(const Scene& scene);

/// The vertices that must stay (`SceneDocument::held_borders`). Empty if the document doesn't keep its meshes.
/// \param mesh the scene's mesh, or some of its faces
/// \param threads 0 = all cores
/// \param warnings gets their number
/// \return V or empty
std::vector<std::uint8_t> held_borders(const Scene& scene, const IndexedMesh& mesh, unsigned threads,
                                       std::vector<std::string>& warnings);

/// The reason for a mesh without faces: "there are no triangles in it". \pre the mesh has no faces
std::string why_no_faces(const io::ReadResult& read);

/// Turns the second texture coordinate over: it grows upwards or downwards (`SceneFormat::texcoords_grow_down`).
void flip_texcoords(IndexedMesh& mesh);

/// The folder of a file.
std::filesystem::path folder_of(const std::string& path);

}  // namespace whittle
