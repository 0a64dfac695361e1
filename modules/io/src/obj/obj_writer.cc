#include "format/colors.hh"
#include "obj/obj.hh"

namespace whittle::io {

namespace {

// "v" or "v//v": a vertex and its normal have the same number.
void write_corner(ByteSink& sink, Index vertex, bool with_normal) {
  const std::uint64_t number = std::uint64_t{vertex} + 1;
  sink << " ";
  sink.number(number);
  if (!with_normal) return;
  sink << "//";
  sink.number(number);
}

}  // namespace

void write_obj(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions&, std::vector<std::string>& warnings) {
  if (has_opacity(mesh)) warnings.emplace_back("OBJ has no opacity: it is left out");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    sink << "v";
    for (const double x : mesh.positions[v]) (sink << " ").number(x);
    for (std::size_t i = 0; i < 3 && !mesh.colors.empty(); ++i) (sink << " ").number(mesh.colors[v][i]);
    sink << "\n";
  }
  for (const auto& normal : mesh.normals) {
    sink << "vn";
    for (const float x : normal) (sink << " ").number(x);
    sink << "\n";
  }
  for (const Triangle& face : mesh.faces) {
    sink << "f";
    for (const Index v : face) write_corner(sink, v, !mesh.normals.empty());
    sink << "\n";
  }
}

}  // namespace whittle::io
