#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "bytes/words.hh"
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

}  // namespace

std::vector<fs::path> referenced_files(const FileNotes& notes, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (!name.empty()) add(fs::path(with_slashes(name)).lexically_normal());
  }
  for (const std::string& line : notes.material_libraries) {
    for (const std::string& name : library_names(line)) {
      const fs::path library = fs::path(with_slashes(name)).lexically_normal();
      add(library);
      for (const std::string& texture : mtl_textures(content_of(folder / library))) {
        add((library.parent_path() / with_slashes(texture)).lexically_normal());
      }
    }
  }
  return files;
}

}  // namespace whittle::io
