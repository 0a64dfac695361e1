#include "whittle/engine/part_gaps.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "brute_force_pairs.hh"
#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/core/pieces.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

Parts parts_of(const IndexedMesh& mesh) { return find_parts(mesh.positions.size(), mesh.faces); }

/// Part labels by brute force: each face spreads its least label to its corners until nothing changes.
std::vector<Index> lowest_of_part_by_spreading(const IndexedMesh& mesh) {
  std::vector<Index> lowest(mesh.positions.size(), invalid_index);
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    for (const Index v : face) lowest[v] = v;
  }
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const Triangle& face : mesh.faces) {
      if (!has_three_corners(face)) continue;
      const Index least = std::min({lowest[face[0]], lowest[face[1]], lowest[face[2]]});
      for (const Index v : face) {
        is_changed = is_changed || lowest[v] != least;
        lowest[v] = least;
      }
    }
  }
  return lowest;
}

void expect_as_by_spreading(const std::string& name, const IndexedMesh& mesh) {
  const Parts parts = parts_of(mesh);
  const std::vector<Index> lowest = lowest_of_part_by_spreading(mesh);
  EXPECT_EQ(parts.count, static_cast<std::size_t>(topology(mesh).components)) << name;
  ASSERT_EQ(parts.part_of.size(), mesh.positions.size()) << name;
  Index n_met = 0;
  for (Index v = 0; v < lowest.size(); ++v) {
    if (lowest[v] == invalid_index) {
      EXPECT_EQ(parts.part_of[v], invalid_index) << name << ", vertex " << v;
    } else {  // parts are numbered in order of their lowest vertices
      EXPECT_EQ(parts.part_of[v], lowest[v] == v ? n_met++ : parts.part_of[lowest[v]]) << name << ", vertex " << v;
    }
  }
}

TEST(Parts, AreWhatHangsTogetherOverVertices) {
  for (const auto& [name, mesh] : all_meshes()) {
    expect_as_by_spreading(name, mesh);
    expect_as_by_spreading(name + ", permuted", permuted(mesh, 3).mesh);
    expect_as_by_spreading(name + ", isolated vertices", with_isolated_vertices(mesh, 5, 1));
    expect_as_by_spreading(name + ", soup", soup(mesh));
  }
}

TEST(Parts, AreNotJoinedByFacesWithTwoEqualCorners) {
  IndexedMesh mesh = spheres(2, 1);
  mesh.faces.push_back({0, 0, static_cast<Index>(mesh.positions.size() - 1)});
  EXPECT_EQ(parts_of(mesh).count, 2U);
}

TEST(Parts, AreNoneWithoutFaces) {
  const Parts parts = find_parts(3, {});
  EXPECT_EQ(parts.count, 0U);
  EXPECT_EQ(parts.part_of, std::vector<Index>(3, invalid_index));
}

TEST(Parts, HaveTheDiagonalsOfTheirBoxes) {
  const IndexedMesh mesh = joined(cube(), scaled(cube(), 0.5));
  const std::vector<double> diagonals = part_diagonals(mesh.positions, parts_of(mesh));
  ASSERT_EQ(diagonals.size(), 2U);
  EXPECT_DOUBLE_EQ(diagonals[0], 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(diagonals[1], std::sqrt(3.0));
  for (const double factor : {1e-300, 1e300}) {  // their squares overflow or underflow
    const IndexedMesh other = scaled(mesh, factor);
    EXPECT_NEAR(part_diagonals(other.positions, parts_of(other))[0] / factor, 2 * std::sqrt(3.0), 1e-12);
  }
}

void expect_gaps_as_by_brute_force(const std::string& name, const IndexedMesh& mesh) {
  const std::vector<double> expected = gaps_by_brute_force(mesh);
  for (const unsigned threads : {1U, 2U, 8U}) {
    const std::vector<double> gaps = gaps_between_parts(mesh, parts_of(mesh), {.threads = threads});
    ASSERT_EQ(gaps.size(), expected.size()) << name;
    for (std::size_t part = 0; part < gaps.size(); ++part) {
      EXPECT_EQ(gaps[part], expected[part]) << name << ", part " << part << ", " << threads << " threads";
    }
  }
}

TEST(PartGaps, AreThoseOfBruteForce) {
  for (const auto& [name, mesh] : all_meshes()) {
    expect_gaps_as_by_brute_force(name, mesh);
    expect_gaps_as_by_brute_force(name + ", isolated vertices", with_isolated_vertices(mesh, 5, 1));
    expect_gaps_as_by_brute_force(name + ", soup", soup(mesh));
    expect_gaps_as_by_brute_force(name + ", in a larger one", joined(mesh, scaled(mesh, 1.1)));
  }
  expect_gaps_as_by_brute_force("spheres", spheres(4, 3, 0.01));
  expect_gaps_as_by_brute_force("boxes", permuted(boxes(6, 5, 0.3), 1).mesh);
}

TEST(PartGaps, OfScatteredPartsAreThoseOfBruteForce) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Random random(seed);
    IndexedMesh mesh;
    for (int part = 0; part < 60; ++part) {
      const Vec3 place = random.uniform_vector(-10, 10);
      mesh = joined(mesh, moved(scaled(sphere(1), random.uniform(0.01, 2)), place));
    }
    expect_gaps_as_by_brute_force("scattered spheres, seed " + std::to_string(seed), mesh);
  }
}

TEST(PartGaps, OfRealMeshesAreThoseOfBruteForce) {
  WHITTLE_REAL_MESH_OR_SKIP(path, "bones.off");
  const IndexedMesh mesh = io::read_mesh(path).mesh;
  EXPECT_EQ(parts_of(mesh).count, 26U);
  expect_gaps_as_by_brute_force("bones.off", mesh);
}

TEST(PartGaps, AreZeroWherePartsTouch) {
  const IndexedMesh mesh = joined(joined(sphere(1), sphere(1)), moved(cube(), Vec3(9, 0, 0)));
  const std::vector<double> gaps = gaps_between_parts(mesh, parts_of(mesh));
  ASSERT_EQ(gaps.size(), 3U);
  EXPECT_EQ(gaps[0], 0);
  EXPECT_EQ(gaps[1], 0);
  EXPECT_EQ(gaps[2], gaps_by_brute_force(mesh)[2]);
}

TEST(PartGaps, AreInfiniteForASinglePart) {
  const IndexedMesh mesh = sphere(2);
  EXPECT_EQ(gaps_between_parts(mesh, parts_of(mesh)), std::vector<double>{no_limit});
}

TEST(PartGaps, AreInfiniteFromTheLimitOn) {
  const IndexedMesh mesh = joined(spheres(2, 2, 0.25), moved(sphere(2), Vec3(0, 5, 0)));
  const std::vector<double> all = gaps_between_parts(mesh, parts_of(mesh));
  const auto gaps = [&](double max_gap) { return gaps_between_parts(mesh, parts_of(mesh), {.max_gap = max_gap}); };
  EXPECT_EQ(gaps(3), (std::vector<double>{all[0], all[1], no_limit}));
  EXPECT_EQ(gaps(all[0]), std::vector<double>(3, no_limit));
  EXPECT_EQ(gaps(std::nextafter(all[0], 1)), (std::vector<double>{all[0], all[1], no_limit}));
  EXPECT_EQ(gaps(0), std::vector<double>(3, no_limit));
  const IndexedMesh twice = joined(mesh, mesh);
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(gaps_between_parts(twice, parts_of(twice), {.max_gap = least}), std::vector<double>(6, 0));
  EXPECT_THROW(gaps(-1), std::invalid_argument);
  EXPECT_THROW(gaps(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(PartGaps, HaveTheUnitOfTheMesh) {
  const IndexedMesh mesh = spheres(3, 2, 0.25);
  const std::vector<double> here = gaps_between_parts(mesh, parts_of(mesh));
  EXPECT_NEAR(here[0], 0.25, 1e-12);
  for (const int exponent : {-1000, -10, 10, 1020}) {
    const IndexedMesh other = scaled(mesh, std::ldexp(1.0, exponent));
    const std::vector<double> there = gaps_between_parts(other, parts_of(other));
    for (std::size_t part = 0; part < 3; ++part) EXPECT_EQ(there[part], std::ldexp(here[part], exponent));
  }
}

/// A mesh of three parts, sizes 3.4, 0.34 and 1.7, preceded by a vertex in no part. Every attribute value tells the
/// part it belongs to.
IndexedMesh three_cubes() {
  IndexedMesh mesh;
  mesh.positions.push_back({7, 7, 7});
  for (const double size : {1.0, 0.1, 0.5}) mesh = joined(mesh, scaled(cube(), size));
  const auto n = static_cast<Index>(mesh.positions.size());
  for (Index v = 0; v < n; ++v) {
    mesh.normals.push_back({static_cast<float>(v), 0, 1});
    mesh.colors.push_back({static_cast<float>(v), 0, 0, 1});
    mesh.origins.push_back(10 * v);
  }
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    mesh.face_groups.push_back(f);
  }
  mesh.face_attributes.push_back({.name = "number", .values = {mesh.face_groups.begin(), mesh.face_groups.end()}});
  mesh.group_names = {"first", "second"};
  return mesh;
}

// A tenth above the widest gap that counts. Boxes of two units of length have a diagonal of about 3.5.
TEST(AutomaticThreshold, IsATenthAboveTheWidestGapBetweenNeighbours) {
  EXPECT_NEAR(automatic_threshold(boxes(2, 1, 0.2)), 0.22, 1e-12);
  const IndexedMesh uneven = joined(boxes(3, 1, 0.1), moved(boxes(2, 1, 0.2), Vec3(0, 4, 0)));
  EXPECT_NEAR(automatic_threshold(uneven), 0.22, 1e-12);
  EXPECT_EQ(automatic_threshold(uneven, 1), automatic_threshold(uneven, 3));
  EXPECT_NEAR(automatic_threshold(scaled(uneven, 1000)), 220, 1e-9);
}

TEST(AutomaticThreshold, JoinsPartsThatTouch) {
  const double threshold = automatic_threshold(boxes(2, 1, 0));
  EXPECT_GT(threshold, 0);
  EXPECT_LT(threshold, 1e-8);
}

TEST(AutomaticThreshold, IsZeroWhereNoPartIsNearAnother) {
  EXPECT_EQ(automatic_threshold(IndexedMesh()), 0);
  EXPECT_EQ(automatic_threshold(cube()), 0);
  EXPECT_EQ(automatic_threshold(boxes(2, 1, 0.4)), 0) << "the gap is wider than a twentieth of the mesh";
  const IndexedMesh crumbs = scaled(boxes(2, 1, 8), 0.01);
  EXPECT_EQ(automatic_threshold(joined(crumbs, moved(cube(), Vec3(9, 0, 0)))), 0) << "the gap is wider than the parts";
}

TEST(AutomaticThreshold, RefusesVerticesThatArentThere) {
  IndexedMesh mesh = boxes(2, 1);
  mesh.faces[3][1] = 16;
  EXPECT_THROW(automatic_threshold(mesh), std::invalid_argument);
  mesh = boxes(2, 1);
  mesh.positions[9].x() = no_limit;
  EXPECT_THROW(automatic_threshold(mesh), std::invalid_argument);
}

TEST(WithoutSmallParts, CarriesWhatBelongsToTheOthers) {
  const IndexedMesh mesh = three_cubes();
  const PrunedMesh pruned = without_small_parts(mesh, 1);
  EXPECT_EQ(pruned.n_dropped_parts, 1U);
  EXPECT_EQ(pruned.n_dropped_faces, 12U);
  const IndexedMesh& out = pruned.mesh;
  ASSERT_EQ(out.positions.size(), 17U);
  ASSERT_EQ(out.faces.size(), 24U);
  ASSERT_EQ(pruned.vertex_map.size(), 25U);
  for (Index v = 0; v < 25; ++v) {
    if (v >= 9 && v < 17) {
      EXPECT_EQ(pruned.vertex_map[v], invalid_index);
      continue;
    }
    const Index w = pruned.vertex_map[v];
    ASSERT_EQ(w, v < 9 ? v : v - 8);
    EXPECT_EQ(out.positions[w], mesh.positions[v]);
    EXPECT_EQ(out.normals[w], mesh.normals[v]);
    EXPECT_EQ(out.colors[w], mesh.colors[v]);
    EXPECT_EQ(out.origins[w], mesh.origins[v]);
  }
  for (std::size_t f = 0; f < 24; ++f) {
    const std::size_t old = f < 12 ? f : f + 12;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(out.faces[f][c], pruned.vertex_map[mesh.faces[old][c]]);
    }
    EXPECT_EQ(out.face_attributes[0].values[f], mesh.face_attributes[0].values[old]);
    EXPECT_EQ(out.face_groups[f], mesh.face_groups[old]);
  }
  EXPECT_EQ(out.group_names, mesh.group_names);
}

/// Each corner has the values that it had.
TEST(WithoutSmallParts, CarriesWedges) {
  IndexedMesh mesh = charted_cube(2);
  const IndexedMesh small = scaled(mesh, 0.1);
  IndexedMesh all = small;
  append_mesh(all, mesh);
  join_equal_wedges(all);
  const PrunedMesh pruned = without_small_parts(all, 1);
  join_equal_wedges(mesh);
  ASSERT_EQ(pruned.mesh.faces.size(), mesh.faces.size());
  EXPECT_EQ(n_wedges(pruned.mesh), n_wedges(mesh));
  EXPECT_EQ(pruned.mesh.attributes[0].size(), n_wedges(mesh));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(pruned.mesh.normals[pruned.mesh.wedge(f, c)], mesh.normals[mesh.wedge(f, c)]);
      EXPECT_TRUE(std::ranges::equal(pruned.mesh.attributes[0].value(pruned.mesh.wedge(f, c)),
                                     mesh.attributes[0].value(mesh.wedge(f, c))));
    }
  }
  const IndexedMesh nothing = without_small_parts(all, no_limit).mesh;
  EXPECT_TRUE(nothing.normals.empty() && nothing.attributes[0].values.empty() && nothing.wedges.empty());
}

TEST(WithoutSmallParts, LeavesSoundMeshesAsTheyAre) {
  for (const auto& [name, mesh] : all_meshes()) {
    const PrunedMesh pruned = without_small_parts(mesh, 0);
    EXPECT_EQ(pruned.n_dropped_parts, 0U) << name;
    EXPECT_EQ(pruned.mesh.positions, mesh.positions) << name;
    EXPECT_EQ(pruned.mesh.faces, mesh.faces) << name;
    EXPECT_TRUE(pruned.mesh.origins.empty()) << name;
    std::vector<Index> same(mesh.positions.size());
    std::iota(same.begin(), same.end(), Index{0});
    EXPECT_EQ(pruned.vertex_map, same) << name;
  }
}

TEST(WithoutSmallParts, SaysWhoWasKept) {
  const IndexedMesh mesh = joined(scaled(cube(), 0.1), cube());
  const PrunedMesh pruned = without_small_parts(mesh, 1);
  EXPECT_EQ(pruned.mesh.origins, (std::vector<Index>{8, 9, 10, 11, 12, 13, 14, 15}));
}

/// A part of exactly the limit's size is kept.
TEST(WithoutSmallParts, KeepsPartsOfTheSizeItself) {
  const IndexedMesh mesh = two_triangles();
  const double size = part_diagonals(mesh.positions, parts_of(mesh))[0];
  EXPECT_EQ(without_small_parts(mesh, size).n_dropped_parts, 0U);
  EXPECT_EQ(without_small_parts(mesh, std::nextafter(size, no_limit)).n_dropped_parts, 1U);
  EXPECT_TRUE(without_small_parts(mesh, no_limit).mesh.faces.empty());
}

/// One such face lies between a removed part and a kept one, the other in the kept one.
TEST(WithoutSmallParts, DropsFacesWithTwoEqualCornersOnlyWithTheirVertices) {
  IndexedMesh mesh = joined(scaled(cube(), 0.1), cube());
  mesh.faces.push_back({8, 8, 0});
  mesh.faces.push_back({8, 9, 9});
  const PrunedMesh pruned = without_small_parts(mesh, 1);
  EXPECT_EQ(pruned.n_dropped_faces, 13U);
  ASSERT_EQ(pruned.mesh.faces.size(), 13U);
  EXPECT_EQ(pruned.mesh.faces.back(), (Triangle{0, 1, 1}));
}

TEST(WithoutSmallParts, RefusesVerticesThatArentThere) {
  IndexedMesh mesh = cube();
  mesh.faces[3][1] = 8;
  EXPECT_THROW(without_small_parts(mesh, 1), std::invalid_argument);
}

TEST(WithoutSmallParts, RefusesWhatIsNoSize) {
  EXPECT_THROW(without_small_parts(cube(), -1), std::invalid_argument);
  EXPECT_THROW(without_small_parts(cube(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
