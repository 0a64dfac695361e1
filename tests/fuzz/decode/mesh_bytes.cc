#include "fuzz/decode/mesh_bytes.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/detail/checks.hh"

namespace whittle::test {
namespace {

double grid_coordinate(ByteSource& source) { return source.whole(0, 8) - 4; }

/// Out of range in one of 64 cases.
double coordinate(ByteSource& source, unsigned kind) {
  switch (kind) {
    case 0:
      return grid_coordinate(source);
    case 1:
      return source.whole(0, 255) * 0x1p-6 - 2;
    default: {
      if (source.one_in(64)) return source.any_real();
      const double coarse = source.real(-1, 1);
      return coarse + source.real(-1, 1) / 256;
    }
  }
}

IndexedMesh listed(ByteSource& source) {
  IndexedMesh mesh;
  const int n_vertices = source.whole(1, 24);
  const int n_faces = source.whole(0, 60);
  const unsigned kind = source.below(3);
  for (int i = 0; i < n_vertices; ++i) {
    Vec3 p;
    for (double& x : p) x = coordinate(source, kind);
    mesh.positions.push_back(p);
  }
  for (int i = 0; i < n_faces && !source.is_empty(); ++i) {
    Triangle face{};
    for (Index& v : face) v = source.below(static_cast<unsigned>(n_vertices));
    mesh.faces.push_back(face);
  }
  return mesh;
}

using Shape = IndexedMesh (*)(ByteSource&);

/// Least and greatest.
using Range = std::array<int, 2>;

/// A shape of two sizes. These are read one after the other: arguments of one call are read in any order.
template <class Make>
IndexedMesh sized(const Make& make, ByteSource& source, const Range& first, const Range& second) {
  const int a = source.whole(first[0], first[1]);
  const int b = source.whole(second[0], second[1]);
  return make(a, b);
}

constexpr std::array<Shape, 22> shapes{{
    [](ByteSource&) { return tetrahedron(); },
    [](ByteSource&) { return octahedron(); },
    [](ByteSource&) { return icosahedron(); },
    [](ByteSource&) { return cube(); },
    [](ByteSource&) { return tessellated_cube(2); },
    [](ByteSource&) { return csaszar_torus(); },
    [](ByteSource&) { return pillow(); },
    [](ByteSource& s) {
      return sized(uv_sphere, s, {2, 4}, {3, 6});
    },
    [](ByteSource& s) {
      return sized([](int nu, int nv) { return torus(nu, nv); }, s, {3, 5}, {3, 5});
    },
    [](ByteSource& s) { return cone(s.whole(3, 9)); },
    [](ByteSource& s) { return frustum(s.whole(3, 8)); },
    [](ByteSource& s) {
      return sized(grid, s, {1, 4}, {1, 4});
    },
    [](ByteSource& s) {
      const auto noisy = [&s](int nx, int ny) { return noisy_grid(nx, ny, 0.5, s.byte()); };
      return sized(noisy, s, {1, 4}, {1, 4});
    },
    [](ByteSource& s) {
      return sized(open_cylinder, s, {3, 6}, {1, 3});
    },
    [](ByteSource& s) {
      return sized(moebius, s, {5, 8}, {1, 2});
    },
    [](ByteSource&) { return single_triangle(); },
    [](ByteSource&) { return two_triangles(); },
    [](ByteSource&) { return bow_tie(); },
    [](ByteSource&) { return three_faces_on_an_edge(); },
    [](ByteSource& s) {
      return sized(book, s, {3, 5}, {1, 2});
    },
    [](ByteSource&) { return two_cubes_on_an_edge(); },
    [](ByteSource& s) { return s.below(2) == 0 ? soup(octahedron()) : soup(grid(2, 2)); },
}};

IndexedMesh one_shape(ByteSource& source) {
  const unsigned kind = source.below(n_mesh_kinds());
  return kind == 0 ? listed(source) : shapes[kind - 1](source);
}

Index vertex(const IndexedMesh& mesh, ByteSource& source) {
  return source.below(static_cast<unsigned>(std::min<std::size_t>(mesh.positions.size(), 256)));
}

Triangle& face(IndexedMesh& mesh, ByteSource& source) {
  return mesh.faces[source.below(static_cast<unsigned>(std::min<std::size_t>(mesh.faces.size(), 256)))];
}

void shake(IndexedMesh& mesh, ByteSource& source) {
  Random random(source.byte());
  const double amplitude = std::ldexp(1.0, -source.whole(1, 40));
  for (Vec3& p : mesh.positions) p += random.uniform_vector(-amplitude, amplitude);
}

void edit_vertices(IndexedMesh& mesh, unsigned kind, ByteSource& source) {
  const Index v = vertex(mesh, source);
  switch (kind) {
    case 0:
      for (double& x : mesh.positions[v]) x += 0.25 * grid_coordinate(source);
      break;
    case 1:
      mesh.positions[v] = mesh.positions[vertex(mesh, source)];
      break;
    case 2: {  // one vertex for two
      const Index into = vertex(mesh, source);
      for (Triangle& f : mesh.faces) std::replace(f.begin(), f.end(), v, into);
      break;
    }
    case 3:
      std::swap(mesh.positions[v], mesh.positions[vertex(mesh, source)]);
      break;
    case 4: {  // on the line between two
      const Vec3& p = mesh.positions[vertex(mesh, source)];
      const double along = source.real(0, 1);
      mesh.positions[v] = p + along * (mesh.positions[vertex(mesh, source)] - p);
      break;
    }
    default:
      mesh.positions[v][source.below(3)] = source.any_real();
      break;
  }
}

void edit_faces(IndexedMesh& mesh, unsigned kind, ByteSource& source) {
  Triangle& f = face(mesh, source);
  switch (kind) {
    case 0:
      std::swap(f[1], f[2]);
      break;
    case 1: {
      Triangle copy = f;
      std::rotate(copy.begin(), copy.begin() + source.below(3), copy.end());
      mesh.faces.push_back(copy);
      break;
    }
    case 2:
      mesh.faces.push_back({f[0], f[2], f[1]});
      break;
    case 3:
      f = mesh.faces.back();
      mesh.faces.pop_back();
      break;
    case 4:
      f[source.below(3)] = vertex(mesh, source);
      break;
    default: {
      const Index a = vertex(mesh, source);
      const Index b = vertex(mesh, source);
      mesh.faces.push_back({a, b, vertex(mesh, source)});
      break;
    }
  }
}

void edit(IndexedMesh& mesh, ByteSource& source) {
  const unsigned kind = source.below(14);
  if (mesh.positions.empty()) return;
  if (kind < 6) return edit_vertices(mesh, kind, source);
  if (kind < 12 && !mesh.faces.empty()) return edit_faces(mesh, kind - 6, source);
  if (kind == 12) mesh.positions.emplace_back(grid_coordinate(source), 0, 0);
  if (kind == 13) shake(mesh, source);
}

IndexedMesh transformed(IndexedMesh mesh, ByteSource& source) {
  switch (source.below(12)) {
    case 8:
      return scaled(mesh, std::ldexp(1.0, 8 * (source.byte() - 128)));
    case 9:
      return scaled(mesh, source.real(0.01, 100));
    case 10: {
      Vec3 offset{source.real(-1, 1), source.real(-1, 1), 0};
      offset *= std::ldexp(1.0, source.whole(0, 60));
      return moved(mesh, offset);
    }
    case 11:
      return rotated(mesh, source.byte());
    default:
      return mesh;
  }
}

void add_attributes(IndexedMesh& mesh, ByteSource& source) {
  const unsigned which = source.byte();
  const std::size_t n = mesh.positions.size();
  if ((which & 1U) != 0) mesh.normals.assign(n, {0, 0, 1});
  if ((which & 2U) != 0) {
    for (std::size_t v = 0; v < n; ++v) mesh.colors.push_back({static_cast<float>(v) / static_cast<float>(n), 0, 1, 1});
  }
  if ((which & 4U) != 0) {
    for (Index v = 0; v < n; ++v) mesh.origins.push_back(3 * v + 1);
  }
  if ((which & 24U) == 24) {
    Attribute texcoords{.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
    for (std::size_t v = 0; v < n; ++v) texcoords.values.insert(texcoords.values.end(), {mesh.positions[v].x(), 1});
    mesh.attributes.push_back(texcoords);
  }
  if ((which & 96U) == 96) {
    mesh.group_names = {"a", "b"};
    for (Index f = 0; f < mesh.faces.size(); ++f) mesh.face_groups.push_back(f % 2);
  }
}

}  // namespace

unsigned n_mesh_kinds() { return static_cast<unsigned>(shapes.size()) + 1; }

IndexedMesh decode_mesh(ByteSource& source) {
  IndexedMesh mesh = one_shape(source);
  if (source.one_in(4)) {
    const Vec3 offset{0.5 * grid_coordinate(source), 0.5 * grid_coordinate(source), 0};
    mesh = joined(mesh, moved(one_shape(source), offset));
    if (source.one_in(3)) mesh = glued(mesh);
  }
  for (int n = source.below(10); n > 0 && !source.is_empty(); --n) edit(mesh, source);
  mesh = transformed(std::move(mesh), source);
  add_attributes(mesh, source);
  return mesh;
}

void make_finite(IndexedMesh& mesh) {
  for (Vec3& p : mesh.positions) {
    if (!is_in_range(p)) p.setZero();
  }
}

bool has_ordinary_sizes(const IndexedMesh& mesh) {
  double extent = 0;
  double farthest = 0;
  double least = std::numeric_limits<double>::infinity();
  double least_from_zero = least;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vec3& p : mesh.positions) {
      values.push_back(p[axis]);
      if (p[axis] != 0) least_from_zero = std::min(least_from_zero, std::abs(p[axis]));
    }
    std::sort(values.begin(), values.end());
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (values[i] > values[i - 1]) least = std::min(least, values[i] - values[i - 1]);
    }
    if (values.empty()) continue;
    extent = std::max(extent, values.back() - values.front());
    farthest = std::max({farthest, values.back(), -values.front()});
  }
  return least >= (farthest > 1000 * extent ? 1e-9 * farthest : 1e-30 * extent) && least_from_zero >= 1e-30 * extent;
}

std::string text_of(const IndexedMesh& mesh) {
  std::ostringstream text;
  text << std::setprecision(17) << "OFF\n" << mesh.positions.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const Vec3& p : mesh.positions) text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : mesh.faces) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

}  // namespace whittle::test
