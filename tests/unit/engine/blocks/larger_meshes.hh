#pragma once

#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"

namespace whittle::test {

/// Of all kinds, each large enough for several small blocks.
inline std::vector<NamedMesh> larger_meshes() {
  std::vector<NamedMesh> meshes{{"blob(4)", blob(4, 1)},
                                {"noisy_sphere(4)", noisy_sphere(4, 0.05, 2)},
                                {"torus(60, 20)", torus(60, 20)},
                                {"terrain(30)", terrain(30, 3)},
                                {"tessellated_cube(14)", tessellated_cube(14)},
                                {"spheres(5, 3)", spheres(5, 3)},
                                {"soup(blob(3))", soup(blob(3, 4))},
                                {"book(3, 40)", book(3, 40)},
                                {"two_cubes_on_an_edge(8)", two_cubes_on_an_edge(8)},
                                {"moebius(60, 8)", moebius(60, 8)},
                                {"isolated", with_isolated_vertices(blob(4, 5), 300, 6)},
                                {"duplicates", with_duplicate_faces(blob(4, 7), 100)}};
  for (const NamedMesh& named : all_meshes()) meshes.push_back(named);
  return meshes;
}

}  // namespace whittle::test
