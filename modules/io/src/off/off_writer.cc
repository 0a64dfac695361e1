#include "format/colors.hh"
#include "format/vertex_split.hh"
#include "off/off.hh"

namespace whittle::io {

namespace {

/// \param mesh without wedges \param texcoords of its vertices, or null
void write_vertices(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options, const Attribute* texcoords) {
  const std::size_t components = mesh.colors.empty() ? 0 : has_opacity(mesh) ? 4 : 3;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int i = 0; i < 3; ++i) (sink << (i > 0 ? " " : "")).number(mesh.positions[v][i]);
    for (std::size_t i = 0; i < 3 && !mesh.normals.empty(); ++i) (sink << " ").number(mesh.normals[v][i]);
    for (std::size_t i = 0; i < components; ++i) {
      sink << " ";
      if (options.exact_colors) {
        sink.number(mesh.colors[v][i]);
      } else {
        sink.number(to_byte(mesh.colors[v][i]));
      }
    }
    for (std::size_t i = 0; i < 2 && texcoords != nullptr; ++i) {
      (sink << " ").number(static_cast<float>(texcoords->value(v)[i]));
    }
    sink << "\n";
  }
}

}  // namespace

void write_off(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings) {
  const std::optional<std::size_t> texcoords = find_texcoords(mesh, 2, 2);
  VertexStorage storage{.normals = true, .colors = true, .attributes = {}};
  if (texcoords) storage.attributes.push_back(*texcoords);
  const std::optional<IndexedMesh> split = split_for(mesh, storage);
  const IndexedMesh& stored = split ? *split : mesh;
  warn_of_lost("OFF", "vertex attribute", names_of_others(mesh.attributes, texcoords), warnings);
  warn_of_lost("OFF", "face attribute", names_of_others(mesh.face_attributes, std::nullopt), warnings);
  warn_of_lost_groups("OFF", mesh, options.notes, warnings);

  sink << (texcoords ? "ST" : "") << (stored.colors.empty() ? "" : "C") << (stored.normals.empty() ? "" : "N")
       << "OFF\n";
  sink.number(stored.positions.size());
  (sink << " ").number(stored.faces.size());
  sink << " 0\n";
  write_vertices(sink, stored, options, texcoords ? &stored.attributes[split ? 0 : *texcoords] : nullptr);
  for (const Triangle& face : stored.faces) {
    sink << "3";
    for (const Index v : face) (sink << " ").number(v);
    sink << "\n";
  }
}

}  // namespace whittle::io
