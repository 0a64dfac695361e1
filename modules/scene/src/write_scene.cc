#include "whittle/scene/write_scene.hh"

#include <utility>

#include "whittle/scene/scene_document.hh"

namespace whittle {

std::string name_of(const SceneOutput& output) {
  return output.path == standard_stream ? "standard output" : output.path;
}

bool keeps_meshes(const Scene& scene, const SceneOutput& output) {
  return keeps_meshes(scene) && output.format->is_document;
}

std::string rounding_options(const gltf::WriteOptions& options) {
  std::string names;
  for (const auto& [is_given, name] : {std::pair(options.compress, "--compress"),
                                       {options.quantize, "--quantize"},
                                       {options.merge, "--merge-meshes"}}) {
    if (is_given) names += (names.empty() ? "" : " and ") + std::string(name);
  }
  return names;
}

void write_scene(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                 SceneMessages& messages) {
  output.format->write(files, output, scene, &mesh, {}, messages);
}

void write_levels(io::OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels,
                  SceneMessages& messages) {
  // Only replaced geometry is rounded.
  output.format->write(files, output, scene, output.gltf.rounds() ? &scene.read.mesh : nullptr, levels, messages);
}

IndexedMesh as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                       const SceneReadOptions& options) {
  return output.format->as_written(output, scene, mesh, options);
}

IndexedMesh scene_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                             const SceneReadOptions& options) {
  return output.format->scene_as_written(output, scene, mesh, options);
}

double widest_gap_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh) {
  return keeps_meshes(scene, output) ? scene.document->widest_gap_as_written(mesh) : 0;
}

}  // namespace whittle
