#include "format/colors.hh"
#include "off/off.hh"

namespace whittle::io {

void write_off(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options, std::vector<std::string>&) {
  const bool with_normals = !mesh.normals.empty();
  const bool with_colors = !mesh.colors.empty();
  const std::size_t components = has_opacity(mesh) ? 4 : 3;
  sink << (with_colors ? "C" : "") << (with_normals ? "N" : "") << "OFF\n";
  sink.number(mesh.positions.size());
  (sink << " ").number(mesh.faces.size());
  sink << " 0\n";
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int i = 0; i < 3; ++i) (sink << (i > 0 ? " " : "")).number(mesh.positions[v][i]);
    for (std::size_t i = 0; i < 3 && with_normals; ++i) (sink << " ").number(mesh.normals[v][i]);
    for (std::size_t i = 0; i < components && with_colors; ++i) {
      sink << " ";
      if (options.exact_colors) {
        sink.number(mesh.colors[v][i]);
      } else {
        sink.number(to_byte(mesh.colors[v][i]));
      }
    }
    sink << "\n";
  }
  for (const Triangle& face : mesh.faces) {
    sink << "3";
    for (const Index v : face) (sink << " ").number(v);
    sink << "\n";
  }
}

}  // namespace whittle::io
