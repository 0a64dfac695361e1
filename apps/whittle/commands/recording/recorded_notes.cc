#include "commands/recording/recorded_notes.hh"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::app {
namespace {

using Texts = std::vector<std::string>;

constexpr char libraries_note[] = "material_libraries";
constexpr char texture_lines_note[] = "texture_lines";
constexpr char vertex_properties_note[] = "vertex_properties";
constexpr char face_properties_note[] = "face_properties";
constexpr char color_type_note[] = "color_type";
constexpr std::string_view face_names_note = "face_names ";  ///< and the attribute's name

/// Whether these are some of the others, in their order.
bool are_some_in_order(const Texts& names, const Texts& all) {
  auto at = all.begin();
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    at = std::find(at, all.end(), name);
    return at != all.end();
  });
}

std::string_view name_of_color_type(ScalarType type) {
  if (type == ScalarType::uint16) return "uint16";
  return type == ScalarType::float32 ? "float32" : "";
}

ScalarType color_type_of(const Texts& texts) {
  for (const ScalarType type : {ScalarType::uint16, ScalarType::float32}) {
    if (texts == Texts{std::string(name_of_color_type(type))}) return type;
  }
  throw progressive::RecordingError("it is damaged: an unknown type of colours");
}

}  // namespace

progressive::RecordingNotes recorded_notes(const io::FileNotes& notes) {
  const Texts usual_vertex{"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
  const Texts usual_face{"vertex_indices"};
  progressive::RecordingNotes recorded;
  const auto add = [&recorded](const std::string& name, const Texts& texts) {
    if (!texts.empty()) recorded[name] = texts;
  };
  add(libraries_note, notes.material_libraries);
  add(texture_lines_note, notes.header_lines);
  for (const auto& [attribute, names] : notes.face_names) add(std::string(face_names_note) + attribute, names);
  if (!are_some_in_order(notes.vertex_properties, usual_vertex)) add(vertex_properties_note, notes.vertex_properties);
  if (!are_some_in_order(notes.face_properties, usual_face)) add(face_properties_note, notes.face_properties);
  const std::string_view color_type = name_of_color_type(notes.color_type);
  if (!color_type.empty()) add(color_type_note, {std::string(color_type)});
  return recorded;
}

io::FileNotes file_notes_of(const progressive::RecordingNotes& recorded) {
  io::FileNotes notes;
  for (const auto& [name, texts] : recorded) {
    if (name == libraries_note) notes.material_libraries = texts;
    if (name == texture_lines_note) notes.header_lines = texts;
    if (name == vertex_properties_note) notes.vertex_properties = texts;
    if (name == face_properties_note) notes.face_properties = texts;
    if (name == color_type_note) notes.color_type = color_type_of(texts);
    if (name.starts_with(face_names_note)) notes.face_names[name.substr(face_names_note.size())] = texts;
  }
  return notes;
}

}  // namespace whittle::app
