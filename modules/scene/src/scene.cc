#include "whittle/scene/scene.hh"

#include "whittle/scene/gltf_file.hh"

namespace whittle {

bool keeps_meshes(const Scene& scene) { return scene.gltf && scene.gltf->scope() == SceneScope::meshes; }

std::string why_no_faces(const io::ReadResult& read) {
  if (read.file_faces == 0) return "there are no triangles in it";
  return "there are only degenerate triangles in it (" + std::to_string(read.file_faces) + ")";
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace whittle
