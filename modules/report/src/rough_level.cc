#include "whittle/report/rough_level.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::report {
namespace {

/// A vertex, and the number of the cell that it is in.
struct InCell {
  std::uint64_t cell;
  Index vertex;
};

std::vector<InCell> by_cell(const IndexedMesh& mesh, const Vec3& origin, double size) {
  constexpr unsigned bits = 21;  // of a coordinate
  const auto coordinate = [](double x) { return static_cast<std::uint64_t>(std::clamp(x, 0.0, 2097151.0)); };
  std::vector<InCell> vertices;
  vertices.reserve(mesh.positions.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 at = (mesh.positions[v] - origin) / size;
    vertices.push_back({coordinate(at.x()) << 2 * bits | coordinate(at.y()) << bits | coordinate(at.z()), v});
  }
  std::sort(vertices.begin(), vertices.end(),
            [](const InCell& a, const InCell& b) { return a.cell != b.cell ? a.cell < b.cell : a.vertex < b.vertex; });
  return vertices;
}

/// \param size of the cells
IndexedMesh joined_in_cells(const IndexedMesh& mesh, const Vec3& origin, double size) {
  IndexedMesh level;
  std::vector<Index> cells(mesh.positions.size());
  const std::vector<InCell> vertices = by_cell(mesh, origin, size);
  for (auto begin = vertices.begin(); begin != vertices.end();) {
    const auto end = std::find_if(begin, vertices.end(), [&](const InCell& v) { return v.cell != begin->cell; });
    Vec3 sum = Vec3::Zero();
    for (auto v = begin; v != end; ++v) {
      cells[v->vertex] = static_cast<Index>(level.positions.size());
      sum += mesh.positions[v->vertex] - origin;
    }
    level.positions.push_back(origin + sum / static_cast<double>(end - begin));
    begin = end;
  }
  for (const auto& [a, b, c] : mesh.faces) {
    const Triangle face{cells[a], cells[b], cells[c]};
    if (has_three_corners(face)) level.faces.push_back(face);
  }
  return level;
}

/// For parts that are all smaller than a cell.
IndexedMesh some_faces(const IndexedMesh& mesh, std::size_t most_faces) {
  IndexedMesh level;
  const std::size_t step = (mesh.faces.size() + most_faces - 1) / most_faces;
  for (std::size_t f = 0; f < mesh.faces.size(); f += step) {
    const auto first = static_cast<Index>(level.positions.size());
    for (const Index v : mesh.faces[f]) level.positions.push_back(mesh.positions[v]);
    level.faces.push_back({first, first + 1, first + 2});
  }
  return level;
}

double area_of(const IndexedMesh& mesh) {
  double area = 0;
  for (const Triangle& face : mesh.faces) area += whittle::area_of(corners_of(mesh.positions, face));
  return area;
}

}  // namespace

IndexedMesh rough_level(const IndexedMesh& mesh, std::size_t most_faces) {
  IndexedMesh level;
  if (mesh.faces.size() <= most_faces) {
    level.positions = mesh.positions;
    level.faces = mesh.faces;
    return level;
  }
  const Box box = bounds_of(mesh);
  const double longest = box.sizes().maxCoeff();
  // A surface meets about 1.5 A / s² cells of size s, and has two faces a cell.
  double size = std::max(std::sqrt(3 * area_of(mesh) / static_cast<double>(most_faces)), longest * 1e-6);
  if (!(size > 0)) return some_faces(mesh, most_faces);
  do {
    level = joined_in_cells(mesh, box.min(), size);
    size *= 1.25;
  } while (level.faces.size() > most_faces);
  return level.faces.empty() ? some_faces(mesh, most_faces) : level;
}

}  // namespace whittle::report
