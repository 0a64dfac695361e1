#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "bytes/words.hh"
#include "notes/mtl_materials.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/file_notes.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

bool ends_a_library_name(std::string_view word) {
  constexpr std::string_view extension = ".mtl";
  return word.size() >= extension.size() && is_same_word(word.substr(word.size() - extension.size()), extension);
}

/// The names after `mtllib`. A name with blanks ends with the first word that ends in ".mtl".
std::vector<std::string> library_names(std::string_view text) {
  std::vector<std::string> names;
  std::size_t first = text.find_first_not_of(blanks);
  for (std::size_t at = first; at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    const std::size_t next = text.find_first_not_of(blanks, end);
    if (next == text.npos || ends_a_library_name(text.substr(at, end - at))) {
      names.emplace_back(text.substr(first, end - first));
      first = next;
    }
    at = next;
  }
  return names;
}

/// Empty if the file can't be read.
std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A material library: its path as `referenced_files` has it, and its text.
struct Library {
  fs::path path;
  std::string text;

  fs::path path_of(std::string_view texture) const {
    return (path.parent_path() / with_slashes(texture)).lexically_normal();
  }
};

std::vector<Library> libraries_of(const FileNotes& notes, const fs::path& folder) {
  std::vector<Library> libraries;
  for (const std::string& line : notes.material_libraries) {
    for (const std::string& name : library_names(line)) {
      const fs::path path = fs::path(with_slashes(name)).lexically_normal();
      libraries.push_back({path, content_of(folder / path)});
    }
  }
  return libraries;
}

std::vector<fs::path> textures_of(const FileNotes& notes) {
  std::vector<fs::path> textures;
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (!name.empty()) textures.push_back(fs::path(with_slashes(name)).lexically_normal());
  }
  return textures;
}

}  // namespace

std::vector<fs::path> referenced_files(const FileNotes& notes, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const fs::path& texture : textures_of(notes)) add(texture);
  for (const Library& library : libraries_of(notes, folder)) {
    add(library.path);
    for (const std::string& texture : mtl_textures(library.text)) add(library.path_of(texture));
  }
  return files;
}

std::vector<Material> read_materials(const FileNotes& notes, const fs::path& folder) {
  std::vector<Material> materials;
  for (const fs::path& texture : textures_of(notes)) materials.push_back({.name = {}, .texture = texture});
  for (const Library& library : libraries_of(notes, folder)) {
    for (MtlMaterial& material : mtl_materials(library.text)) {
      Material& added = materials.emplace_back(Material{std::move(material.name), material.color, {}});
      if (material.texture.empty()) continue;
      added.texture = library.path_of(material.texture);
      std::fill_n(added.color.begin(), 3, 1.0F);
    }
  }
  return materials;
}

}  // namespace whittle::io
