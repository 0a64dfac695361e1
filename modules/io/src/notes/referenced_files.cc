#include <algorithm>
#include <string>
#include <string_view>

#include "notes/material_libraries.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::io {

namespace fs = std::filesystem;

std::vector<fs::path> referenced_files(const FileNotes& notes, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (!name.empty()) add(path_of_reference(name).lexically_normal());
  }
  for (const fs::path& library : material_libraries(notes)) {
    add(library);
    for (const std::string& texture : mtl_textures(content_of(folder / library).value_or(""))) {
      add((library.parent_path() / path_of_reference(texture)).lexically_normal());
    }
  }
  return files;
}

}  // namespace whittle::io
