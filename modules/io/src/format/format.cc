#include "whittle/io/format.hh"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <stdexcept>
#include <vector>

#include "format/foreign.hh"
#include "format/format_row.hh"

namespace whittle::io {

namespace {

/// "PLY, STL or OFF": the titles of the formats that `holds` is true of, and others.
template <class Holds>
std::string titles_of(const Holds& holds, std::initializer_list<std::string_view> others = {}) {
  std::vector<std::string_view> titles;
  for (const detail::FormatRow* row : detail::format_table) {
    if (holds(*row)) titles.push_back(row->title);
  }
  titles.insert(titles.end(), others);
  std::string text;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (i > 0) text += i + 1 == titles.size() ? " or " : ", ";
    text += titles[i];
  }
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

}  // namespace

const detail::FormatRow& row_of(Format format) {
  for (const detail::FormatRow* row : detail::format_table) {
    if (row->format == format) return *row;
  }
  throw std::invalid_argument("not a format");
}

std::string_view name_of(Format format) { return row_of(format).name; }

std::span<const std::string_view> extensions_of(Format format) { return row_of(format).extensions; }

std::string_view title_of(Format format) { return row_of(format).title; }

bool has_text_and_binary(Format format) { return row_of(format).has_text_and_binary; }

FileNotes notes_in(Format format, FileNotes notes) {
  if (!row_of(format).names_libraries) notes.material_libraries.clear();
  if (!row_of(format).names_textures) notes.header_lines.clear();
  return notes;
}

std::string format_names(std::string_view separator) {
  std::string names;
  for (const detail::FormatRow* row : detail::format_table) {
    if (!names.empty()) names += separator;
    names += row->name;
  }
  return names;
}

std::string format_titles() {
  return titles_of([](const detail::FormatRow&) { return true; });
}

std::string mesh_titles() {
  return titles_of([](const detail::FormatRow&) { return true; }, {"glTF"});
}

std::string titles_with_text_and_binary() {
  return titles_of([](const detail::FormatRow& row) { return row.has_text_and_binary; });
}

Format format_from_extension(std::string_view extension) {
  if (!extension.empty() && extension.front() == '.') extension.remove_prefix(1);
  const std::string lower = lower_case(extension);
  for (const detail::FormatRow* row : detail::format_table) {
    const auto known = row->extensions;
    if (std::find(known.begin(), known.end(), lower) != known.end()) return row->format;
  }
  if (lower.empty()) {
    throw std::invalid_argument("has no extension that tells its format; name one of " + format_names() +
                                ", glb, gltf");
  }
  if (const std::optional<std::string> problem = problem_of_foreign_extension(lower)) {
    throw std::invalid_argument(*problem);
  }
  throw std::invalid_argument("has the unknown extension \"." + std::string(extension) + "\"; use " + mesh_titles());
}

bool has_gzip_extension(const std::filesystem::path& path) { return lower_case(path.extension().string()) == ".gz"; }

Format format_of(const std::filesystem::path& path) {
  return format_from_extension((has_gzip_extension(path) ? path.stem() : path).extension().string());
}

}  // namespace whittle::io
