#include "support/defects.hh"

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

IndexedMesh any_shape(Random& random) {
  const std::vector<std::function<IndexedMesh(std::uint64_t)>> shapes{
      [](std::uint64_t seed) { return blob(3, seed); },
      [](std::uint64_t) { return torus(24, 12); },
      [](std::uint64_t seed) { return terrain(20, seed); },
      [](std::uint64_t) { return bracket(4); },
      [](std::uint64_t) { return knot(60, 8); },
      [](std::uint64_t) { return open_cylinder(20, 12); },
      [](std::uint64_t seed) { return noisy_sphere(3, 0.1, seed); },
      [](std::uint64_t) { return boxes(4, 3); },
      [](std::uint64_t) { return moebius(40, 3); },
      [](std::uint64_t) { return frustum(40); },
      [](std::uint64_t) { return tessellated_cube(6); }};
  return rotated(shapes[random.below(shapes.size())](random.bits()), random.bits());
}

Index any_vertex(const IndexedMesh& mesh, Random& random) {
  return static_cast<Index>(random.below(mesh.positions.size()));
}
std::size_t any_face(const IndexedMesh& mesh, Random& random) { return random.below(mesh.faces.size()); }

/// A part through the mesh, or vertices pulled through it.
void intersect_itself(IndexedMesh& mesh, Random& random) {
  const double size = diagonal(mesh);
  if (random.below(2) == 0) {
    const IndexedMesh other = moved(scaled(sphere(2), 0.2 * size), mesh.positions[any_vertex(mesh, random)]);
    mesh = joined(mesh, other);
    return;
  }
  for (std::uint64_t i = 1 + random.below(8); i > 0; --i) {
    mesh.positions[any_vertex(mesh, random)] += random.uniform_vector(-0.4 * size, 0.4 * size);
  }
}

/// Faces on edges that have two, or vertices that belong to two places.
void make_nonmanifold(IndexedMesh& mesh, Random& random) {
  for (std::uint64_t i = 1 + random.below(6); i > 0; --i) {
    const Triangle face = mesh.faces[any_face(mesh, random)];
    const Index other = any_vertex(mesh, random);
    if (random.below(2) == 0) {
      mesh.faces.push_back({face[0], face[1], other});
      continue;
    }
    for (Triangle& f : mesh.faces) std::replace(f.begin(), f.end(), face[0], other);
  }
}

/// Two equal corners, corners at one place, or on a line.
void make_degenerate(IndexedMesh& mesh, Random& random) {
  for (std::uint64_t i = 1 + random.below(6); i > 0; --i) {
    Triangle& face = mesh.faces[any_face(mesh, random)];
    const std::uint64_t kind = random.below(3);
    if (kind == 0) face[1] = face[0];
    if (kind == 1) mesh.positions[face[1]] = mesh.positions[face[0]];
    if (kind == 2) mesh.positions[face[2]] = (mesh.positions[face[0]] + mesh.positions[face[1]]) / 2;
  }
}

void tear_holes(IndexedMesh& mesh, Random& random) {
  for (std::uint64_t i = 1 + random.below(10); i > 0 && mesh.faces.size() > 8; --i) {
    mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(any_face(mesh, random)));
  }
}

void turn_faces(IndexedMesh& mesh, Random& random) {
  for (std::uint64_t i = 1 + random.below(10); i > 0; --i) {
    Triangle& face = mesh.faces[any_face(mesh, random)];
    std::swap(face[1], face[2]);
  }
}

}  // namespace

NamedMesh defective_mesh(std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh = any_shape(random);
  std::string name = "defective_mesh(" + std::to_string(seed) + "):";
  const auto with_chance = [&](std::uint64_t percent, const char* what, const auto& spoil) {
    if (random.below(100) >= percent) return;
    spoil(mesh, random);
    name += std::string(" ") + what;
  };
  with_chance(45, "intersecting", intersect_itself);
  with_chance(22, "non-manifold", make_nonmanifold);
  with_chance(16, "degenerate", make_degenerate);
  with_chance(20, "torn", tear_holes);
  with_chance(10, "turned", turn_faces);
  with_chance(10, "duplicates",
              [](IndexedMesh& m, Random& r) { m = with_duplicate_faces(m, 1 + static_cast<int>(r.below(5))); });
  with_chance(10, "soup", [](IndexedMesh& m, Random&) { m = soup(m); });
  with_chance(5, "isolated", [](IndexedMesh& m, Random& r) { m = with_isolated_vertices(m, 3, r.bits()); });
  with_chance(5, "large", [](IndexedMesh& m, Random&) { m = scaled(m, 1e100); });
  with_chance(5, "small", [](IndexedMesh& m, Random&) { m = scaled(m, 1e-100); });
  with_chance(5, "far", [](IndexedMesh& m, Random&) { m = moved(m, Vec3(1e7, -1e6, 3e8)); });
  return {name, mesh};
}

}  // namespace whittle::test
