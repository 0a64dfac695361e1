#include "fuzz/read_and_check.hh"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {

namespace {

void require(bool holds, const char* promise) {
  if (!holds) throw std::logic_error(std::string("broken promise: ") + promise);
}

void check_mesh(const io::ReadResult& result) {
  const IndexedMesh& mesh = result.mesh;
  const std::size_t vertices = mesh.positions.size();
  require(!mesh.faces.empty(), "a mesh has faces");
  std::vector<char> is_used(vertices, 0);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      require(v < vertices, "corners are vertices");
      is_used[v] = 1;
    }
    require(has_three_corners(face), "no face is degenerate");
  }
  require(std::count(is_used.begin(), is_used.end(), 0) == 0, "no vertex is isolated");
  for (const Vec3& p : mesh.positions) require(p.allFinite(), "positions are finite");
  require(mesh.normals.empty() || mesh.normals.size() == vertices, "there is a normal a vertex");
  require(mesh.colors.empty() || mesh.colors.size() == vertices, "there is a colour a vertex");
  for (const auto& n : mesh.normals) require(std::isfinite(n[0] + n[1] + n[2]), "normals are finite");
  for (const Color& color : mesh.colors) {
    for (const float c : color) require(c >= 0 && c <= 1, "colours lie in [0, 1]");
  }
  require(mesh.origins.size() == vertices, "there is an origin a vertex");
  for (std::size_t v = 0; v < vertices; ++v) {
    require(mesh.origins[v] < result.file_vertices, "origins are vertices of the file");
    require(v == 0 || mesh.origins[v - 1] < mesh.origins[v], "origins ascend");
  }
  require(result.vertex_map.size() == result.file_vertices, "every vertex of the file is mapped");
  for (const Index to : result.vertex_map) require(to < vertices || to == invalid_index, "it is mapped to a vertex");
}

void check_round_trip(const IndexedMesh& mesh, io::Format format, bool ascii) {
  std::ostringstream out;
  io::write_mesh(out, format, mesh, {.ascii = ascii, .exact_colors = true});
  const std::string bytes = out.str();
  const io::ReadResult back = io::read_mesh(bytes, "again", {.weld = false, .format = format});
  require(back.mesh.positions == mesh.positions, "positions are written exactly");
  require(back.mesh.faces == mesh.faces, "faces are written exactly");
}

}  // namespace

// The lowest bit is for welding.
char choice_of(io::Format format, bool weld) {
  return static_cast<char>(2 * static_cast<unsigned>(format) + (weld ? 1 : 0));
}

io::Format format_chosen(char choice) {
  return io::all_formats[static_cast<unsigned char>(choice) / 2U % io::all_formats.size()];
}

void read_and_check(std::string_view bytes) {
  if (bytes.empty()) return;
  const bool weld = (bytes.front() & 1) != 0;
  const io::Format format = format_chosen(bytes.front());
  bytes.remove_prefix(1);
  try {
    const io::ReadResult result = io::read_mesh(bytes, "fuzz", {.weld = weld, .format = format});
    check_mesh(result);
    check_round_trip(result.mesh, io::Format::ply, false);
    if (format != io::Format::stl) check_round_trip(result.mesh, format, true);  // STL stores no shared vertices
  } catch (const io::ReadError& error) {
    require(std::string_view(error.what()).starts_with("fuzz:"), "an error names its file");
    require(std::string_view(error.what()).find('\n') == std::string_view::npos, "an error is one line");
  }
}

}  // namespace whittle::test
