#include <fast_float/fast_float.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "bytes/words.hh"
#include "notes/material_libraries.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

/// A share, in [0, 1].
std::optional<double> take_share(std::string_view& text) {
  const std::string_view word = take_word(text);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value >= 0)) return std::nullopt;
  return std::min(value, 1.0);
}

/// `Kd r g b`. A grey may have one number.
void read_diffuse(std::string_view text, Material& material) {
  const std::optional<double> red = take_share(text);
  if (!red) return;
  const std::optional<double> green = take_share(text);
  const std::optional<double> blue = take_share(text);
  material.base_color = {*red, green.value_or(*red), blue.value_or(green.value_or(*red)), material.base_color[3]};
}

void read_opacity(std::string_view text, Material& material) {
  material.base_color[3] = take_share(text).value_or(material.base_color[3]);
  material.alpha_mode = material.base_color[3] < 1 ? Alpha::blend : Alpha::opaque;
}

void name_texture(const fs::path& file, Material& material) {
  Texture& texture = material.base_color_texture.emplace();
  texture.image = std::make_shared<const Image>(Image{.name = "texture " + file.string(), .file = file});
  texture.is_tinted = false;
}

/// \param materials by name
void read_library(std::string_view text, const fs::path& folder, std::map<std::string, Material>& materials) {
  std::optional<Material> current;
  const auto finish = [&] {
    if (current) materials.emplace(current->name, *current);
  };
  for_each_mtl_line(text, [&](std::string_view line) {
    const std::string_view keyword = take_word(line);
    if (is_same_word(keyword, "newmtl")) {
      finish();
      current = Material{.name = std::string(line)};
    }
    if (!current) return;
    if (is_same_word(keyword, "kd")) read_diffuse(line, *current);
    if (is_same_word(keyword, "d")) read_opacity(line, *current);
    if (is_same_word(keyword, "map_kd")) {
      const fs::path file = path_of_reference(texture_name(line));
      if (!file.empty()) name_texture((folder / file).lexically_normal(), *current);
    }
  });
  finish();
}

/// Textures that the header of a PLY file names.
std::vector<fs::path> textures_of(const FileNotes& notes) {
  std::vector<fs::path> textures;
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (!name.empty()) textures.push_back(path_of_reference(name).lexically_normal());
  }
  return textures;
}

/// Lets a material be seen from both sides, and its texture be where the coordinates of the mesh put it: in these
/// files rows are counted from below.
void fit_to(const IndexedMesh& mesh, Material& material) {
  material.double_sided = true;
  if (!material.base_color_texture) return;
  const auto uv = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                               [](const Attribute& a) { return a.kind == AttributeKind::texcoord; });
  if (uv != mesh.attributes.end()) material.base_color_texture->texcoord = uv->name;
  material.base_color_texture->transform = Eigen::Translation2d(0, 1) * Eigen::Scaling(1.0, -1.0);
}

}  // namespace

SurfaceMaterials read_materials(const FileNotes& notes, const fs::path& folder, const IndexedMesh& mesh) {
  SurfaceMaterials all;
  std::map<std::string, Material> by_name;
  for (const fs::path& library : material_libraries(notes)) {
    const std::optional<std::string> text = content_of(folder / library);
    if (text) {
      read_library(*text, library.parent_path(), by_name);
    } else {
      all.missing.push_back(library);
    }
  }
  const std::vector<fs::path> textures = textures_of(notes);
  all.has_several_textures = textures.size() > 1;
  all.are_told = !by_name.empty() || textures.size() == 1;
  Material other;
  if (textures.size() == 1) name_texture(textures.front(), other);
  for (std::size_t group = 0; group < std::max<std::size_t>(1, mesh.group_names.size()); ++group) {
    const std::string name = mesh.group_names.empty() ? std::string() : mesh.group_names[group];
    const auto found = mesh.group_names.empty() ? by_name.end() : by_name.find(name);
    Material& material = all.materials.emplace_back(found == by_name.end() ? other : found->second);
    material.name = name;
    fit_to(mesh, material);
  }
  return all;
}

void read_images(std::span<Material> materials, const fs::path& folder) {
  std::map<fs::path, std::shared_ptr<const Image>> read;
  for (Material& material : materials) {
    if (!material.base_color_texture) continue;
    std::shared_ptr<const Image>& image = material.base_color_texture->image;
    const auto [known, is_new] = read.try_emplace(image->file);
    if (is_new) {
      Image with_bytes = *image;
      std::optional<std::string> bytes = content_of(folder / image->file);
      if (!bytes) with_bytes.problem = "the file can't be read";
      with_bytes.bytes = std::move(bytes).value_or("");
      known->second = std::make_shared<const Image>(std::move(with_bytes));
    }
    image = known->second;
  }
}

}  // namespace whittle::io
