#include "files/mesh_output.hh"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "files/companions.hh"
#include "files/gltf/new_gltf.hh"
#include "files/gltf_file.hh"
#include "files/report.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/io/materials.hh"

namespace whittle::app {
namespace {

/// \param mesh null: that of the input, as the file has it
void write_to_gltf(OutputFiles& files, const MeshOutput& output, Input& input, const IndexedMesh* mesh,
                   CoarserLevels levels, const Talk& talk, std::vector<std::string>& warnings) {
  if (!keeps_meshes(input)) {
    const IndexedMesh& finest = mesh == nullptr ? input.read.mesh : *mesh;
    return write_new_gltf(files, output.path, input, finest, levels, output.compresses_gltf, talk, warnings);
  }
  for (const std::string& warning : input.gltf->write(files, output.path, mesh, levels, output.compresses_gltf)) {
    warnings.push_back(about(output.path, warning));
    talk.warning(warnings.back());
  }
  // It has written the images that can be beside it. This says which aren't.
  copy_companions(files, input.path, output.path, input.gltf->asset().image_files(), talk, warnings);
}

/// Whether a glTF input has a material that shows on the mesh, with more than a name.
bool has_looks(const Input& input, const IndexedMesh& mesh) {
  const std::vector<GltfFile::Group> groups = input.gltf->groups();
  return std::any_of(mesh.face_groups.begin(), mesh.face_groups.end(), [&](Index group) {
    return input.gltf->asset().has_look(groups[group].mesh, groups[group].primitive);
  });
}

/// What a glTF input has that files of other formats can't hold. \pre the mesh has its groups
std::string left_out_of(const Input& input, const IndexedMesh& mesh) {
  std::string others = listed(input.gltf->asset().other_content());
  if (!has_looks(input, mesh)) return others;
  return "the materials, with their colours and images" + (others.empty() ? "" : "; " + others);
}

void write_from_gltf(OutputFiles& files, const MeshOutput& output, const Input& input, const IndexedMesh& mesh,
                     const Talk& talk, std::vector<std::string>& warnings) {
  const bool is_positions_only = mesh.face_groups.empty();  // all else was dropped as asked
  if (const std::string lost = is_positions_only ? "" : left_out_of(input, mesh); !lost.empty()) {
    warnings.push_back(about(shown_output(output.path), "left out: " + lost));
    talk.warning(warnings.back());
  }
  IndexedMesh flipped = mesh;
  flip_texcoords(flipped);
  write_mesh(files, output.path, output.options, flipped, talk, warnings, input.read.notes);
}

/// The textures of the materials that faces of the input have.
std::set<std::filesystem::path> textures_of(const Input& input) {
  const io::SurfaceMaterials surface = io::read_materials(input.read.notes, folder_of(input.path));
  const IndexedMesh& mesh = input.read.mesh;
  const auto is_used = [&](const io::SurfaceMaterial& material) {
    return std::any_of(mesh.face_groups.begin(), mesh.face_groups.end(),
                       [&](Index group) { return mesh.group_names[group] == material.name; });
  };
  std::set<std::filesystem::path> textures;
  for (const io::SurfaceMaterial& material : surface.materials) {
    if (!material.texture.empty() && is_used(material)) textures.insert(material.texture);
  }
  return textures;
}

/// Lets a PLY file name the texture of an OBJ file as MeshLab and others read it. They take one texture: where there
/// are several, each face's group and the comment with the material libraries say which it has.
void name_texture(const MeshOutput& output, const Input& input, io::FileNotes& notes, const Talk& talk,
                  std::vector<std::string>& warnings) {
  if (format_for_output(output.path, output.options) != io::Format::ply) return;
  if (notes.material_libraries.empty() || !notes.header_lines.empty() || input.path == standard_stream) return;
  const std::set<std::filesystem::path> textures = textures_of(input);
  if (textures.size() == 1) {
    notes.header_lines.push_back("comment TextureFile " + textures.begin()->generic_string());
  } else if (textures.size() > 1) {
    warnings.push_back(about(shown_output(output.path),
                             "has " + std::to_string(textures.size()) +
                                 " textures, which other programs don't read from PLY: write OBJ or glTF for them"));
    talk.warning(warnings.back());
  }
}

}  // namespace

bool is_gltf_output(const std::string& path, const FileOptions& options) {
  return options.writes_gltf && !options.output_format && is_gltf(path);
}

std::string output_format_name(const std::string& path, const FileOptions& options) {
  if (is_gltf_output(path, options)) return "gltf";
  return std::string(io::name_of(format_for_output(path, options)));
}

IndexedMesh as_written(const MeshOutput& output, const Input& input, const IndexedMesh& mesh, unsigned threads) {
  if (!is_gltf_output(output.path, output.options)) return as_written(mesh, output.path, output.options, threads);
  if (keeps_meshes(input)) return input.gltf->as_written(mesh);
  const Vec3 origin = float32_origin(input.read.mesh.positions);  // as `write_new_gltf` has it
  IndexedMesh rounded = mesh;
  for (Vec3& p : rounded.positions) p = rounded_to_float32(p, origin);
  return rounded;
}

double widest_gap_as_written(const MeshOutput& output, const Input& input, const IndexedMesh& mesh) {
  const bool has_meshes = is_gltf_output(output.path, output.options) && keeps_meshes(input);
  return has_meshes ? input.gltf->widest_gap_as_written(mesh) : 0;
}

void write_result(OutputFiles& files, const MeshOutput& output, Input& input, const IndexedMesh& mesh, const Talk& talk,
                  std::vector<std::string>& warnings) {
  if (is_gltf_output(output.path, output.options)) {
    return write_to_gltf(files, output, input, &mesh, {}, talk, warnings);
  }
  if (input.gltf) return write_from_gltf(files, output, input, mesh, talk, warnings);
  io::FileNotes notes = input.read.notes;
  name_texture(output, input, notes, talk, warnings);
  write_mesh(files, output.path, output.options, mesh, talk, warnings, notes);
  notes = io::notes_in(format_for_output(output.path, output.options), std::move(notes));
  copy_companions(files, input.path, output.path, io::referenced_files(notes, folder_of(input.path)), talk, warnings);
}

void write_levels(OutputFiles& files, const MeshOutput& output, Input& input, CoarserLevels levels, const Talk& talk,
                  std::vector<std::string>& warnings) {
  // What is compressed is replaced geometry.
  write_to_gltf(files, output, input, output.compresses_gltf ? &input.read.mesh : nullptr, levels, talk, warnings);
}

}  // namespace whittle::app
