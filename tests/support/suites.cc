#include "support/suites.hh"

#include "support/shapes/shapes.hh"

// Stringizes the call to get its name.
#define WHITTLE_NAMED(call) \
  NamedMesh { #call, call }

namespace whittle::test {

std::vector<NamedMesh> closed_meshes() {
  return {WHITTLE_NAMED(tetrahedron()),
          WHITTLE_NAMED(octahedron()),
          WHITTLE_NAMED(icosahedron()),
          WHITTLE_NAMED(cube()),
          WHITTLE_NAMED(csaszar_torus()),
          WHITTLE_NAMED(tessellated_cube(4)),
          WHITTLE_NAMED(sphere(2)),
          WHITTLE_NAMED(uv_sphere(8, 16)),
          WHITTLE_NAMED(noisy_sphere(2, 0.1, 7)),
          WHITTLE_NAMED(blob(2, 3)),
          WHITTLE_NAMED(torus(16, 8)),
          WHITTLE_NAMED(noisy_torus(16, 8, 1.0, 0.4, 0.05, 11)),
          WHITTLE_NAMED(cone(24)),
          WHITTLE_NAMED(frustum(24)),
          WHITTLE_NAMED(bracket(3)),
          WHITTLE_NAMED(spheres(3, 1)),
          WHITTLE_NAMED(boxes(3, 2))};
}

std::vector<NamedMesh> open_meshes() {
  return {WHITTLE_NAMED(single_triangle()), WHITTLE_NAMED(two_triangles()),
          WHITTLE_NAMED(grid(8, 6)),        WHITTLE_NAMED(noisy_grid(8, 8, 0.3, 5)),
          WHITTLE_NAMED(terrain(12, 2)),    WHITTLE_NAMED(open_cylinder(12, 5)),
          WHITTLE_NAMED(moebius(20, 2)),    WHITTLE_NAMED(soup(octahedron()))};
}

std::vector<NamedMesh> nonmanifold_meshes() {
  return {WHITTLE_NAMED(bow_tie()), WHITTLE_NAMED(three_faces_on_an_edge()), WHITTLE_NAMED(two_cubes_on_an_edge()),
          WHITTLE_NAMED(book(7, 3)), WHITTLE_NAMED(with_duplicate_faces(sphere(1), 5))};
}

std::vector<NamedMesh> all_meshes() {
  std::vector<NamedMesh> result;
  for (auto suite : {closed_meshes(), open_meshes(), nonmanifold_meshes()})
    for (NamedMesh& entry : suite) result.push_back(std::move(entry));
  return result;
}

}  // namespace whittle::test
