#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/io/read.hh"

namespace whittle {

class GltfFile;
struct SceneFormat;

/// Stands for standard input or output in place of a path.
inline constexpr std::string_view standard_stream = "-";

/// Meshes that were read from a file, as one mesh, and what else is known of the file.
struct Scene {
  std::string path;  ///< of the file, or `standard_stream`
  std::string name;  ///< in messages: the path, or "standard input"
  const SceneFormat* format = nullptr;
  io::ReadResult read;
  double weld_tolerance = 0;         ///< to which vertices were welded, model units; 0 = exact duplicates alone
  std::shared_ptr<GltfFile> gltf{};  ///< the document of a glTF file, to be written again; or null
  std::string mesh_name{};           ///< what new documents call the mesh
  std::vector<std::filesystem::path> needed_files{};  ///< beside it: buffers, material libraries, textures
  std::vector<std::string> joined{};    ///< the files that it was joined of (`SceneJoiner`), `path` first; or empty
  std::vector<std::string> warnings{};  ///< a line each, with the name in front
};

/// Whether the document keeps its meshes, each by itself: what has become of them replaces them.
bool keeps_meshes(const Scene& scene);

/// The vertices that have to stay, as `GltfFile::held_borders` has them. Empty if the document doesn't keep its meshes.
/// \param mesh that of the scene, or some of its faces \param threads 0 = all cores \param warnings gets how many
/// \return V or empty
std::vector<std::uint8_t> held_borders(const Scene& scene, const IndexedMesh& mesh, unsigned threads,
                                       std::vector<std::string>& warnings);

/// Why nothing is left of what was read: "there are no triangles in it". \pre it has no faces
std::string why_no_faces(const io::ReadResult& read);

/// The folder of a file.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace whittle
