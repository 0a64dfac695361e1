#include "ply/ply_notes.hh"

#include <algorithm>
#include <charconv>
#include <string>

#include "bytes/words.hh"
#include "notes/texture_lines.hh"
#include "ply/ply_plan.hh"

namespace whittle::io {
namespace {

/// \param text after "name"
void take_name(std::string_view text, FileNotes& notes) {
  const std::string property(take_word(text));
  const std::string_view number = take_word(text);
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (property.empty() || error != std::errc{} || end != number.data() + number.size()) return;
  const auto known = notes.face_names.find(property);
  if (value != (known == notes.face_names.end() ? 0 : known->second.size())) return;
  notes.face_names[property].emplace_back(text);
}

void take_remark(std::string_view line, FileNotes& notes) {
  std::string_view text = line;
  const std::string_view keyword = take_word(text);
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  if (keyword == "comment" && word == "name") {
    take_name(rest, notes);
  } else if (keyword == "comment" && word == "mtllib") {
    notes.material_libraries.emplace_back(rest);
  } else if (!texture_of_line(line).empty()) {
    notes.header_lines.emplace_back(line);
  }
}

std::vector<std::string> names_of(const PlyElement& element) {
  std::vector<std::string> names;
  for (const PlyProperty& property : element.properties) {
    names.push_back(element.name == "vertex" ? written_name(property) : property.name);
  }
  return names;
}

/// Turns an attribute of faces into groups, if all values have names.
void take_groups(IndexedMesh& mesh, FileNotes& notes) {
  const auto names = notes.face_names.find(group_property);
  const auto attribute = std::find_if(mesh.face_attributes.begin(), mesh.face_attributes.end(),
                                      [](const Attribute& a) { return a.name == group_property; });
  if (names == notes.face_names.end() || attribute == mesh.face_attributes.end()) return;
  const auto is_named = [n = static_cast<double>(names->second.size())](double value) {
    return value >= 0 && value < n && value == static_cast<double>(static_cast<Index>(value));
  };
  if (!std::all_of(attribute->values.begin(), attribute->values.end(), is_named)) return;
  mesh.face_groups.assign(attribute->values.begin(), attribute->values.end());
  mesh.group_names = std::move(names->second);
  mesh.face_attributes.erase(attribute);
  notes.face_names.erase(names);
}

/// A name in one line.
void write_text(ByteSink& sink, std::string_view text) {
  for (const char c : text) sink << std::string_view(static_cast<unsigned char>(c) < ' ' ? " " : &c, 1);
  sink << "\n";
}

void write_names(ByteSink& sink, std::string_view property, const std::vector<std::string>& names) {
  for (std::size_t value = 0; value < names.size(); ++value) {
    (sink << "comment name " << property << " ").number(value);
    write_text(sink << " ", names[value]);
  }
}

}  // namespace

void take_ply_notes(const PlyHeader& header, ReadResult& result) {
  FileNotes& notes = result.notes;
  for (const std::string_view line : header.remarks) take_remark(line, notes);
  for (const PlyElement& element : header.elements) {
    if (element.name == "face") notes.face_properties = names_of(element);
    if (element.name != "vertex") continue;
    notes.vertex_properties = names_of(element);
    notes.color_type = plan_vertices(element, AttributeScope::all).color_type;
  }
  take_groups(result.mesh, notes);
}

void write_ply_notes(ByteSink& sink, const IndexedMesh& mesh, const FileNotes& notes) {
  for (const std::string& line : notes.header_lines) write_text(sink, line);
  for (const std::string& library : notes.material_libraries) write_text(sink << "comment mtllib ", library);
  if (!mesh.face_groups.empty()) write_names(sink, group_property, mesh.group_names);
  for (const auto& [property, names] : notes.face_names) write_names(sink, property, names);
}

}  // namespace whittle::io
