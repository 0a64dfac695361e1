#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz/check/promise.hh"
#include "fuzz/decode/byte_source.hh"
#include "fuzz/targets.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::test {
namespace {

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
  check_attributes(mesh, "a reader");
  require(mesh.wedges.empty() || mesh.wedges.size() == 3 * mesh.faces.size(), "each corner has a wedge");
  for (const Index group : mesh.face_groups) require(group < mesh.group_names.size(), "groups have names");
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
  require(back.mesh.faces.size() == mesh.faces.size(), "all faces are written");
  if (mesh.wedges.empty()) {
    require(back.mesh.positions == mesh.positions, "positions are written exactly");
    require(back.mesh.faces == mesh.faces, "faces are written exactly");
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      require(back.mesh.positions[back.mesh.faces[f][c]] == mesh.positions[mesh.faces[f][c]],
              "corners keep their positions where vertices are split");
    }
  }
}

/// What `whittle info` does with a mesh.
void measure(const IndexedMesh& mesh) {
  const metrics::Topology topology = metrics::topology(mesh);
  require(topology.collapsed_faces == 0, "no face is degenerate");
  if (mesh.faces.size() > 64 || !std::all_of(mesh.positions.begin(), mesh.positions.end(), is_in_range)) return;
  require(std::isfinite(diagonal_of(bounds_of(mesh))), "meshes have a size");
  require(std::isfinite(metrics::shape(mesh).radius_ratio_mean), "meshes have a shape");
  metrics::self_intersections(mesh, 1);
}

}  // namespace

void fuzz_reader(std::string_view bytes, io::Format format) {
  if (bytes.empty()) return;
  const bool weld = (bytes.front() & 1) != 0;
  const bool is_measured = hash_of(bytes) % 8 == 0;
  bytes.remove_prefix(1);
  try {
    const io::ReadResult result = io::read_mesh(bytes, "fuzz", {.weld = weld, .format = format});
    check_mesh(result);
    check_round_trip(result.mesh, io::Format::ply, false);
    if (format != io::Format::stl) check_round_trip(result.mesh, format, true);  // STL stores no shared vertices
    if (is_measured) measure(result.mesh);
  } catch (const io::ReadError& error) {
    require(std::string_view(error.what()).starts_with("fuzz:"), "an error names its file");
    require(std::string_view(error.what()).find('\n') == std::string_view::npos, "an error is one line");
  }
}

}  // namespace whittle::test
