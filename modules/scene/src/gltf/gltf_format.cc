#include <filesystem>

#include "companions.hh"
#include "formats.hh"
#include "gltf/gltf_file.hh"
#include "gltf/new_gltf.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/path_of.hh"
#include "whittle/scene/errors.hh"
#include "whittle/scene/gltf_asset.hh"
#include "whittle/scene/read_scene.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view gltf_extensions[] = {"glb", "gltf"};

/// \pre the scene `keeps_meshes`, so that it is of this format
GltfFile& document_of(const Scene& scene) { return static_cast<GltfFile&>(*scene.document); }

io::ReadOptions own_options(const SceneReadOptions& options) {
  return {.weld = options.weld, .threads = options.threads, .attributes = options.attributes};
}

Scene read_gltf(const SceneFile& file, const SceneReadOptions& options) {
  Scene scene;
  scene.format = &gltf_format;
  const auto document = std::make_shared<GltfFile>(io::path_of(file.path()));
  scene.document = document;
  scene.read = document->read(own_options(options), options.scope);
  const fs::path folder = folder_of(file.path());
  for (const std::vector<fs::path>& names : {document->asset().buffer_files(), document->asset().image_files()}) {
    for (const fs::path& name : names) scene.needed_files.push_back(folder / name);
  }
  return scene;
}

void write_gltf(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh* mesh,
                CoarserLevels levels, SceneMessages& messages) {
  if (!keeps_meshes(scene)) {
    return write_new_gltf(files, output, scene, mesh == nullptr ? scene.read.mesh : *mesh, levels, messages);
  }
  GltfFile& document = document_of(scene);
  for (const std::string& warning : document.write(files, output, mesh, levels)) {
    messages.warnings.push_back(about(output.path, warning));
  }
  // It has written the images that can be beside it. This says which aren't.
  copy_companions(files, scene.path, output.path, document.asset().image_files(), messages);
}

IndexedMesh gltf_as_written(const SceneOutput& /*output*/, const Scene& scene, const IndexedMesh& mesh,
                            const SceneReadOptions& /*options*/) {
  if (keeps_meshes(scene)) return document_of(scene).as_written(mesh);
  const Vec3 origin = float32_origin(scene.read.mesh.positions);  // as `write_new_gltf` has it
  IndexedMesh rounded = mesh;
  for (Vec3& p : rounded.positions) p = rounded_to_float32(p, origin);
  return rounded;
}

IndexedMesh gltf_scene_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                                  const SceneReadOptions& options) {
  if (keeps_meshes(scene)) return document_of(scene).scene_as_written(mesh, output.gltf, own_options(options));
  GltfFile written(io::path_of(output.path), new_gltf_as_written(output, scene, mesh));
  return written.read(own_options(options), SceneScope::scene).mesh;
}

}  // namespace

const gltf::Asset& gltf_asset_of(const Scene& scene) {
  const auto* const document = dynamic_cast<const GltfFile*>(scene.document.get());
  if (document == nullptr) throw UnsupportedMesh(scene.name + ": it is not glTF");
  return document->asset();
}

constinit const SceneFormat gltf_format{.name = "gltf",
                                        .title = "glTF",
                                        .extensions = gltf_extensions,
                                        .mesh_format = std::nullopt,
                                        .has_text_and_binary = false,
                                        .is_document = true,
                                        .texcoords_grow_down = true,
                                        .read = read_gltf,
                                        .write = write_gltf,
                                        .as_written = gltf_as_written,
                                        .scene_as_written = gltf_scene_as_written};

}  // namespace whittle
