#include "whittle/scene/join_scenes.hh"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "whittle/core/pieces.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/path_of.hh"
#include "whittle/scene/errors.hh"

namespace whittle {
namespace {

constexpr char object_attribute[] = "o";  // as OBJ has it
constexpr char group_attribute[] = "g";

Attribute names_of_faces(const char* name, std::size_t n_faces) {
  return {.name = name,
          .kind = AttributeKind::category,
          .n_components = 1,
          .values = std::vector<double>(n_faces, 0),
          .type = ScalarType::uint32};
}

Attribute* find_of_faces(IndexedMesh& mesh, const char* name) {
  const auto found = std::find_if(mesh.face_attributes.begin(), mesh.face_attributes.end(),
                                  [name](const Attribute& attribute) { return attribute.name == name; });
  return found == mesh.face_attributes.end() ? nullptr : &*found;
}

/// Gives a name that all faces have an attribute of its own, as it is where they have several.
void spell_out(io::ReadResult& read, const char* name) {
  if (find_of_faces(read.mesh, name) != nullptr || read.notes.face_names[name].empty()) return;
  read.mesh.face_attributes.push_back(names_of_faces(name, read.mesh.faces.size()));
}

/// The objects of a file become its stem, or "stem object" where it has several.
void name_by_file(io::ReadResult& read, const std::string& path) {
  const std::filesystem::path name = io::path_of(path).filename();
  const std::string stem = (io::has_gzip_extension(name) ? name.stem() : name).stem().string();
  std::vector<std::string>& names = read.notes.face_names[object_attribute];
  if (find_of_faces(read.mesh, object_attribute) == nullptr || names.empty()) {
    std::erase_if(read.mesh.face_attributes, [](const Attribute& a) { return a.name == object_attribute; });
    names = {stem};
    spell_out(read, object_attribute);
    return;
  }
  for (std::string& object : names) object.insert(0, object.empty() ? stem : stem + ' ');
}

/// Numbers the names of both files through.
void merge_names(io::ReadResult& all, io::ReadResult& more, const char* name) {
  Attribute* const attribute = find_of_faces(more.mesh, name);
  std::vector<std::string>& names = all.notes.face_names[name];
  const std::vector<std::string>& new_names = more.notes.face_names[name];
  if (attribute == nullptr || names.empty()) return;
  std::vector<double> number_of;
  for (const std::string& new_name : new_names) {
    const auto place = std::find(names.begin(), names.end(), new_name);
    number_of.push_back(static_cast<double>(place - names.begin()));
    if (place == names.end()) names.push_back(new_name);
  }
  for (double& value : attribute->values) {
    const auto old = static_cast<std::size_t>(value);
    if (old < number_of.size()) value = number_of[old];
  }
}

/// Drops attributes that the other list lacks. \param dropped gets the names
void keep_common(std::vector<Attribute>& a, std::vector<Attribute>& b, std::set<std::string>& dropped) {
  const auto drop = [&dropped](std::vector<Attribute>& from, const std::vector<Attribute>& other) {
    std::erase_if(from, [&](const Attribute& attribute) {
      const bool is_common =
          std::any_of(other.begin(), other.end(), [&](const Attribute& one) { return is_same_kind(one, attribute); });
      if (!is_common) dropped.insert(attribute.name);
      return !is_common;
    });
  };
  drop(a, b);
  drop(b, a);
}

template <class T>
void keep_common(std::vector<T>& a, std::vector<T>& b, const char* name, std::set<std::string>& dropped) {
  if (a.empty() == b.empty()) return;
  a.clear();
  b.clear();
  dropped.insert(name);
}

/// Keeps faces of a file without materials without one, also if the other file has materials.
void even_out_materials(IndexedMesh& a, IndexedMesh& b) {
  for (IndexedMesh* const mesh : {&a, &b}) {
    if (!mesh->face_groups.empty() || (a.face_groups.empty() && b.face_groups.empty())) continue;
    mesh->face_groups.assign(mesh->faces.size(), 0);
    mesh->group_names = {""};
  }
}

bool names_files(const io::FileNotes& notes) {
  return !notes.material_libraries.empty() || !notes.header_lines.empty();
}

/// Drops names of faces without an attribute, except names that both files have for all faces.
void drop_idle_names(io::ReadResult& a, const io::ReadResult& b) {
  std::erase_if(a.notes.face_names, [&](const auto& entry) {
    const auto& [name, names] = entry;
    if (find_of_faces(a.mesh, name.c_str()) != nullptr) return false;
    const auto other = b.notes.face_names.find(name);
    return other == b.notes.face_names.end() || other->second != names;
  });
}

void join_notes(io::FileNotes& all, const io::FileNotes& more) {
  for (const std::string& library : more.material_libraries) {
    const auto& known = all.material_libraries;
    if (std::find(known.begin(), known.end(), library) == known.end()) all.material_libraries.push_back(library);
  }
  if (all.header_lines.empty()) all.header_lines = more.header_lines;
  all.has_float32_positions = all.has_float32_positions && more.has_float32_positions;
}

void join_meshes(io::ReadResult& all, io::ReadResult more) {
  const auto first = static_cast<Index>(all.mesh.positions.size());
  for (Index& origin : more.mesh.origins) origin += static_cast<Index>(all.file_vertices);
  for (const Index v : more.vertex_map) all.vertex_map.push_back(v == invalid_index ? v : first + v);
  append_mesh(all.mesh, std::move(more.mesh));
  all.tolerances.insert(all.tolerances.end(), more.tolerances.begin(), more.tolerances.end());
  all.repairs += more.repairs;
  all.warnings.insert(all.warnings.end(), more.warnings.begin(), more.warnings.end());
  all.file_vertices += more.file_vertices;
  all.file_faces += more.file_faces;
}

}  // namespace

void SceneJoiner::refuse_conflicts(const Scene& more) const {
  if (names_files(more.read.notes) &&
      folder_of(more.path).lexically_normal() != folder_of(all_.path).lexically_normal()) {
    throw UnsupportedMesh(more.name + ": has textures or materials, and lies in another folder than " + all_.path +
                          ": put the files for --join into one folder");
  }
  if (!all_.read.notes.header_lines.empty() && !more.read.notes.header_lines.empty() &&
      all_.read.notes.header_lines != more.read.notes.header_lines) {
    throw UnsupportedMesh(more.name + ": has another texture than " + all_.name +
                          ", and a PLY file has one set: join them as OBJ files with materials");
  }
  for (const std::string& material : more.read.mesh.group_names) {
    const auto known = libraries_.find(material);
    if (material.empty() || known == libraries_.end() || known->second == more.read.notes.material_libraries) continue;
    throw UnsupportedMesh(more.name + ": has a material '" + material +
                          "' as a file before has, in another library: rename one of them for --join");
  }
}

void SceneJoiner::join(Scene more) {
  io::ReadResult& a = all_.read;
  io::ReadResult& b = more.read;
  if (a.file_vertices + b.file_vertices >= invalid_index ||
      a.mesh.faces.size() + b.mesh.faces.size() >= invalid_index / 3) {
    throw UnsupportedMesh(more.name + ": too many vertices or faces for one mesh with those before");
  }
  refuse_conflicts(more);
  all_.needed_files.insert(all_.needed_files.end(), more.needed_files.begin(), more.needed_files.end());
  keep_common(a.mesh.normals, b.mesh.normals, "normals", dropped_);
  keep_common(a.mesh.colors, b.mesh.colors, "colours", dropped_);
  keep_common(a.tolerances, b.tolerances, "tolerances", dropped_);
  keep_common(a.mesh.attributes, b.mesh.attributes, dropped_);
  keep_common(a.mesh.face_attributes, b.mesh.face_attributes, dropped_);
  even_out_materials(a.mesh, b.mesh);
  drop_idle_names(a, b);
  for (auto& [name, names] : b.notes.face_names) merge_names(a, b, name.c_str());
  join_notes(a.notes, b.notes);
  join_meshes(a, std::move(b));
  all_.warnings.insert(all_.warnings.end(), more.warnings.begin(), more.warnings.end());
  all_.weld_tolerance = std::max(all_.weld_tolerance, more.weld_tolerance);
}

void SceneJoiner::add(Scene scene) {
  paths_.push_back(scene.path);
  name_by_file(scene.read, scene.path);
  spell_out(scene.read, group_attribute);
  const std::vector<std::string> libraries = scene.read.notes.material_libraries;
  const std::vector<std::string> materials = scene.read.mesh.group_names;
  if (paths_.size() == 1) {
    all_ = std::move(scene);
  } else {
    join(std::move(scene));
  }
  for (const std::string& material : materials) libraries_.try_emplace(material, libraries);
}

Scene SceneJoiner::finish() {
  std::erase_if(all_.read.notes.face_names, [](const auto& entry) { return entry.second.empty(); });
  if (paths_.size() > 1) all_.name += " and " + counted(paths_.size() - 1, "more file", "more files");
  if (!dropped_.empty()) {
    all_.warnings.push_back(
        about(all_.name, "left out, as not all files have it: " + listed({dropped_.begin(), dropped_.end()})));
  }
  all_.joined = std::move(paths_);
  return std::move(all_);
}

}  // namespace whittle
