#include "whittle/scene/scene.hh"

#include <algorithm>

#include "whittle/core/text/text.hh"
#include "whittle/io/path_of.hh"
#include "whittle/scene/scene_document.hh"

namespace whittle {

bool keeps_meshes(const Scene& scene) { return scene.document && scene.document->scope() == SceneScope::meshes; }

double widest_stretch(const Scene& scene) { return keeps_meshes(scene) ? scene.document->widest_stretch() : 1; }

std::vector<std::uint8_t> held_borders(const Scene& scene, const IndexedMesh& mesh, unsigned threads,
                                       std::vector<std::string>& warnings) {
  if (!keeps_meshes(scene)) return {};
  std::vector<std::uint8_t> held = scene.document->held_borders(mesh, threads);
  const auto n = static_cast<std::size_t>(std::count(held.begin(), held.end(), 1));
  if (n > 0) {
    warnings.push_back(about(scene.name, counted(n, "vertex stays where it is", "vertices stay where they are") +
                                             ": meshes that the scene shows several times meet others there"));
  }
  return held;
}

std::string why_no_faces(const io::ReadResult& read) {
  if (read.file_faces == 0) return "there are no triangles in it";
  return "there are only degenerate triangles in it (" + std::to_string(read.file_faces) + ")";
}

void flip_texcoords(IndexedMesh& mesh) {
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::texcoord || attribute.n_components < 2) continue;
    for (std::size_t w = 0; w < attribute.size(); ++w) attribute.value(w)[1] = 1 - attribute.value(w)[1];
  }
}

std::filesystem::path folder_of(const std::string& path) {
  const std::filesystem::path file = io::path_of(path);
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace whittle
