// Formats of files with one mesh: `io` reads and writes them.
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

#include "companions.hh"
#include "formats.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/write.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/scene_document.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

io::ReadResult read_mesh(const SceneFile& file, const io::ReadOptions& options) {
  if (file.path() == standard_stream) return io::read_mesh(file.content(), file.name(), options);
  return io::read_mesh(io::path_of(file.path()), options);
}

Scene read_one_mesh(const SceneFile& file, const SceneReadOptions& options) {
  const std::optional<io::Format> format = file.format() != nullptr ? file.format()->mesh_format : std::nullopt;
  Scene scene;
  scene.read = read_mesh(
      file, {.weld = options.weld, .format = format, .threads = options.threads, .attributes = options.attributes});
  scene.format = &format_of(scene.read.format);
  if (file.path() == standard_stream) return scene;
  const fs::path folder = folder_of(file.path());
  for (const fs::path& name : io::referenced_files(scene.read.notes, folder)) {
    scene.needed_files.push_back(folder / name);
  }
  return scene;
}

/// The textures of the materials that faces of the input have.
std::set<std::filesystem::path> textures_of(const Scene& scene) {
  const IndexedMesh& mesh = scene.read.mesh;
  const auto materials = io::read_materials(scene.read.notes, folder_of(scene.path), mesh).materials;
  std::set<std::filesystem::path> textures;
  for (const Index group : mesh.face_groups) {
    if (const auto& texture = materials[group].base_color_texture) textures.insert(texture->image->file);
  }
  return textures;
}

/// Lets a PLY file name the texture of an OBJ file as MeshLab and others read it. They take one texture: where there
/// are several, each face's group and the comment with the material libraries say which it has.
void name_texture(const SceneOutput& output, const Scene& scene, io::FileNotes& notes, SceneMessages& messages) {
  if (output.format->mesh_format != io::Format::ply) return;
  if (notes.material_libraries.empty() || !notes.header_lines.empty() || scene.path == standard_stream) return;
  const std::set<std::filesystem::path> textures = textures_of(scene);
  if (textures.size() == 1) {
    notes.header_lines.push_back("comment TextureFile " + textures.begin()->generic_string());
  } else if (textures.size() > 1) {
    messages.warnings.push_back(
        about(name_of(output), "has " + std::to_string(textures.size()) +
                                   " textures, which other programs don't read from PLY: write OBJ or glTF for them"));
  }
}

void write_mesh(io::OutputFiles& files, const SceneOutput& output, const IndexedMesh& mesh, const io::FileNotes& notes,
                SceneMessages& messages) {
  files.write(output.path, [&](std::ostream& out) {
    const io::WriteOptions how{
        .ascii = output.ascii, .gzip = io::has_gzip_extension(io::path_of(output.path)), .notes = notes};
    for (const std::string& warning : io::write_mesh(out, *output.format->mesh_format, mesh, how).warnings) {
      messages.warnings.push_back(about(name_of(output), warning));
    }
  });
}

void write_from_document(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                         SceneMessages& messages) {
  const bool is_positions_only = mesh.face_groups.empty();  // all else was dropped as asked
  if (const std::string lost = is_positions_only ? "" : scene.document->left_out_of_one_mesh(mesh); !lost.empty()) {
    messages.warnings.push_back(about(name_of(output), "left out: " + lost));
  }
  IndexedMesh written = mesh;
  if (scene.format->texcoords_grow_down) flip_texcoords(written);
  write_mesh(files, output, written, scene.read.notes, messages);
}

/// \pre there is a mesh, and no levels
void write_one_mesh(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh* mesh,
                    CoarserLevels /*levels*/, SceneMessages& messages) {
  if (scene.document) return write_from_document(files, output, scene, *mesh, messages);
  io::FileNotes notes = scene.read.notes;
  name_texture(output, scene, notes, messages);
  write_mesh(files, output, *mesh, notes, messages);
  notes = io::notes_in(*output.format->mesh_format, std::move(notes));
  copy_companions(files, scene.path, output.path, io::referenced_files(notes, folder_of(scene.path)), messages);
}

IndexedMesh one_mesh_as_written(const SceneOutput& output, const Scene& /*scene*/, const IndexedMesh& mesh,
                                const SceneReadOptions& options) {
  const io::Format format = *output.format->mesh_format;
  std::ostringstream out;
  io::write_mesh(out, format, mesh, {.ascii = output.ascii});
  const io::ReadOptions how{
      .weld = options.weld, .format = format, .threads = options.threads, .attributes = io::AttributeScope::per_vertex};
  return io::read_mesh(std::move(out).str(), output.path, how).mesh;
}

}  // namespace

SceneFormat format_with_one_mesh(io::Format format) {
  return {.name = io::name_of(format),
          .title = io::title_of(format),
          .extensions = io::extensions_of(format),
          .mesh_format = format,
          .has_text_and_binary = io::has_text_and_binary(format),
          .is_document = false,
          .read = read_one_mesh,
          .write = write_one_mesh,
          .as_written = one_mesh_as_written,
          .scene_as_written = one_mesh_as_written};
}

}  // namespace whittle
