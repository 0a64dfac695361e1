#include "format/vertex_split.hh"

#include "whittle/core/wedges.hh"

namespace whittle::io {

std::optional<IndexedMesh> split_for(const IndexedMesh& mesh, const VertexStorage& storage) {
  if (mesh.wedges.empty()) return std::nullopt;
  IndexedMesh stored;
  stored.positions = mesh.positions;
  stored.faces = mesh.faces;
  stored.wedges = mesh.wedges;
  if (storage.normals) stored.normals = mesh.normals;
  if (storage.colors) stored.colors = mesh.colors;
  for (const std::size_t i : storage.attributes) stored.attributes.push_back(mesh.attributes[i]);
  join_equal_wedges(stored);
  return stored.wedges.empty() ? std::move(stored) : split_at_wedges(stored);
}

void warn_of_lost(std::string_view title, std::string_view what, const std::vector<std::string>& names,
                  std::vector<std::string>& warnings) {
  if (names.empty()) return;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  const bool is_one = names.size() == 1;
  warnings.push_back(std::string(title) + " can't hold the " + std::string(what) + (is_one ? " " : "s ") + list +
                     (is_one ? ": it is left out" : ": they are left out"));
}

void warn_of_lost_groups(std::string_view title, const IndexedMesh& mesh, const FileNotes& notes,
                         std::vector<std::string>& warnings) {
  if (!mesh.face_groups.empty()) warnings.push_back(std::string(title) + " has no materials: they are left out");
  if (!notes.material_libraries.empty() || !notes.header_lines.empty()) {
    warnings.push_back(std::string(title) + " can't name textures: they are left out");
  }
}

std::optional<std::size_t> find_texcoords(const IndexedMesh& mesh, std::size_t fewest, std::size_t most) {
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const Attribute& attribute = mesh.attributes[i];
    const bool fits = attribute.n_components >= fewest && attribute.n_components <= most;
    if (attribute.kind == AttributeKind::texcoord && fits) return i;
  }
  return std::nullopt;
}

std::vector<std::string> names_of_others(const std::vector<Attribute>& attributes, std::optional<std::size_t> but) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    if (i != but) names.push_back(attributes[i].name);
  }
  return names;
}

}  // namespace whittle::io
