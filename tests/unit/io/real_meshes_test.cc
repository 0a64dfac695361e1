// Real meshes: counts as other tools report them, and counts after repair. Also files that must be refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ostream>
#include <vector>

#include "io_test_tools.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

std::ostream& operator<<(std::ostream& out, const Repairs& repairs);
std::ostream& operator<<(std::ostream& out, const Repairs& repairs) { return out << to_string(repairs); }

namespace {

struct EdgeCounts {
  std::size_t open = 0;
  std::size_t nonmanifold = 0;
};

EdgeCounts count_edges(const IndexedMesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& face : mesh.faces) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(face[c], face[(c + 1) % 3]);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  EdgeCounts counts;
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    counts.open += last - first == 1;
    counts.nonmanifold += last - first > 2;
    first = last;
  }
  return counts;
}

struct Known {
  std::string file;
  std::size_t file_vertices, file_faces;  // As stored.
  std::size_t vertices, faces;            // Repaired.
  std::size_t open_edges = 0;
  std::size_t nonmanifold_edges = 0;
  std::string repairs{};
};

std::ostream& operator<<(std::ostream& out, const Known& known) { return out << known.file; }

class RealMesh : public testing::TestWithParam<Known> {};

TEST_P(RealMesh, IsReadAndRepaired) {
  const Known& known = GetParam();
  WHITTLE_REAL_MESH_OR_SKIP(path, known.file);
  const ReadResult result = read_mesh(path);
  test::expect_valid(result, known.file);
  EXPECT_EQ(result.file_vertices, known.file_vertices);
  EXPECT_EQ(result.file_faces, known.file_faces);
  EXPECT_EQ(result.mesh.positions.size(), known.vertices);
  EXPECT_EQ(result.mesh.faces.size(), known.faces);
  EXPECT_EQ(to_string(result.repairs), known.repairs);
  const EdgeCounts edges = count_edges(result.mesh);
  EXPECT_EQ(edges.open, known.open_edges);
  EXPECT_EQ(edges.nonmanifold, known.nonmanifold_edges);
}

// A soup is what STL would store. Welding restores a manifold mesh. For other meshes a soup doesn't tell which faces
// belong together; welding then makes a manifold mesh.
TEST_P(RealMesh, ComesBackFromASoup) {
  const Known& known = GetParam();
  WHITTLE_REAL_MESH_OR_SKIP(path, known.file);
  IndexedMesh soup = whittle::test::soup(read_mesh(path).mesh);
  repair(soup);
  EXPECT_EQ(soup.faces.size(), known.faces);
  const EdgeCounts edges = count_edges(soup);
  EXPECT_EQ(edges.nonmanifold, 0U);
  if (known.nonmanifold_edges > 0) {
    EXPECT_GT(soup.positions.size(), known.vertices);
    return;
  }
  EXPECT_EQ(soup.positions.size(), known.vertices);
  EXPECT_EQ(edges.open, known.open_edges);
}

const std::vector<Known> meshes = {
    {"dinosaur.obj", 2002, 4000, 2002, 4000},
    {"bunny.obj", 35292, 70580, 35292, 70580},
    {"ankylosaurus.obj", 14762, 29520, 14762, 29520},
    // One pair of coincident vertices is not welded, because an edge would get four faces.
    {"cow.off", 2762, 5520, 2762, 5520},
    {"bunny_28576.obj", 14290, 28576, 14290, 28576},
    // 2046 vertices lie on open borders, 54 at edges without length, each between two faces without area.
    {"dragon_vrip.ply", 437645, 871414, 435545, 871306, 0, 0, "welded 2100 vertices, dropped 108 degenerate faces"},
    {"armadillo_86k.obj", 43243, 86482, 43243, 86482},
    {"hand_bones_opensim.obj", 57817, 115502, 57065, 114037, 55, 2,
     "triangulated 32 polygons, welded 752 vertices, dropped 1503 degenerate faces"},
    {"gt_hand_finger.ply", 2046, 4088, 2046, 4088},
    {"bones.off", 2154, 4204, 2154, 4204},
    {"kitten.obj", 24956, 49912, 24956, 49912},
    {"Arma.obj", 23201, 46398, 23201, 46398},
    {"sphere.obj", 10242, 20480, 10242, 20480},
    {"triceratops.off", 2832, 5660, 2832, 5660},
    {"camel.off", 9770, 19536, 9770, 19536},
    {"bun_zipper.ply", 35947, 69451, 34834, 69451, 223, 0, "dropped 1113 isolated vertices"},
    {"camelhead.off", 11381, 22704, 11381, 22704, 56},
    {"lion-head.off", 8356, 16674, 8356, 16674, 36},
    {"mech-holes-shark.off", 5246, 10192, 5246, 10192, 304},
    {"three_peaks.off", 1907, 3671, 1907, 3671, 141},
    {"beetle-alt.obj", 19887, 38656, 19885, 38656, 1136, 0, "welded 2 vertices"},
    {"fandisk.obj", 9445, 18886, 9445, 18886},
    {"rocker.obj", 9397, 18794, 9397, 18794},
    {"block.obj", 2132, 4272, 2132, 4272},
    {"joint.off", 221, 446, 221, 446},
    {"couplingdown.off", 1841, 3714, 1841, 3714},
    {"pinion.off", 650, 1300, 650, 1300},
    {"openmesh_cube1Binary.stl", 45144, 15048, 7526, 15048, 0, 0, "welded 37618 vertices"},
    {"knot2.off", 5760, 11520, 5760, 11520},
    {"hundred_cubes.obj", 800, 600, 800, 1200, 0, 0, "triangulated 600 polygons"},
    {"cycloidal.ply", 21384, 43368, 21384, 43368, 0, 242},
    {"tray_bottom.stl", 13560, 4520, 2216, 4520, 0, 0, "welded 11344 vertices"},
    {"spot_uv.obj", 2930, 5856, 2930, 5856},
    {"bunny10k_textured.obj", 5051, 9999, 5051, 9999, 109},
    {"Laurana50k.ply", 27861, 49954, 25126, 49954, 302, 0, "dropped 2735 isolated vertices"},
    {"texturedknot_wedge.ply", 1440, 2880, 1440, 2880},
    {"greek_helmet.obj", 5021, 4856, 5021, 9608, 424, 0, "triangulated 4752 polygons"},
    {"office_chair.obj", 3476, 3391, 3474, 6869, 157, 196,
     "triangulated 3351 polygons, welded 2 vertices, dropped 8 degenerate faces"},
    {"geo_delft_testarea.obj", 14760, 28619, 14760, 28611, 950, 33, "dropped 8 duplicate faces"},
    // Some flaps are two faces on the same corners. If both have the same orientation they are duplicates. Dropping one
    // opens the flap.
    {"conrod_flipped.off", 3223, 6442, 3223, 6439, 6, 3, "dropped 3 duplicate faces"},
    {"dragon_vrip_res3.ply", 22998, 47794, 22982, 47592, 0, 2080, "dropped 202 duplicate faces, 16 isolated vertices"},
    {"boeing.off", 2741, 2564, 1264, 2564, 0, 0, "welded 1477 vertices"},
    {"nasty/oblong-shuffled.off", 424, 840, 422, 840, 0, 0, "welded 2 vertices"},
    {"nasty/triple_vierbein.obj", 75, 108, 75, 108, 60, 20},
    {"nasty/hourglass_ico.obj", 23, 40, 23, 40},
    {"nasty/fan3.obj", 5, 3, 5, 3, 6, 1},
    {"nasty/moebius.obj", 280, 224, 280, 448, 112, 0, "triangulated 224 polygons"},
    {"nasty/cube-minimal-degenerated.obj", 8, 14, 8, 12, 0, 0, "dropped 2 degenerate faces"},
    {"nasty/cube-minimal-vertexColors.ply", 8, 12, 8, 12},
    {"nasty/cube-minimal-texCoords.obj", 8, 12, 8, 12},
    {"nasty/cube-custom_props-binary.ply", 8, 6, 8, 12, 0, 0, "triangulated 6 polygons"},
    {"nasty/deg_faces.obj", 6, 4, 5, 3, 5, 0, "dropped 1 degenerate face, 1 isolated vertex"},
    {"nasty/nonmanifold_cubes.obj", 9, 12, 9, 12, 6},
    {"synthetic/crlf_tet.obj", 4, 4, 4, 4},
    {"synthetic/single_tet.off", 4, 4, 4, 4},
    {"synthetic/single_triangle.obj", 3, 1, 3, 1, 3},
    {"synthetic/synth_bowtie_vertex.off", 7, 8, 7, 8},
    {"synthetic/synth_cow_degenerate_dup.obj", 2812, 5655, 2812, 5620, 0, 0,
     "dropped 10 degenerate faces, 25 duplicate faces"},
    {"synthetic/synth_cow_geo_offset.obj", 2762, 5520, 2762, 5520},
    {"synthetic/synth_cow_halfflipped.off", 2762, 5520, 2762, 5520},
    {"synthetic/synth_cow_insideout.off", 2762, 5520, 2762, 5520},
    {"synthetic/synth_cow_isolated_verts.obj", 3223, 5520, 2762, 5520, 0, 0, "dropped 461 isolated vertices"},
    {"synthetic/synth_cow_scale1e-9.obj", 2762, 5520, 2762, 5520},
    {"synthetic/synth_cow_scale1e9.obj", 2762, 5520, 2762, 5520},
    {"synthetic/synth_cow_soup.obj", 16560, 5520, 2762, 5520, 0, 0, "welded 13798 vertices"},
    {"synthetic/synth_cube_tess32.obj", 6146, 12288, 6146, 12288},
    {"synthetic/synth_cubes_10x10_gap10pct.obj", 800, 1200, 800, 1200},
    {"synthetic/synth_cubes_shared_edge.obj", 14, 24, 14, 24, 0, 1},
    {"synthetic/synth_plane_grid_100.obj", 10201, 20000, 10201, 20000, 400},
    {"synthetic/synth_two_spheres_gap0.01.obj", 1284, 2560, 1284, 2560},
    {"synthetic/synth_uvsphere_pole256.off", 3842, 7680, 3842, 7680},
    {"synthetic/two_disjoint_triangles.obj", 6, 2, 6, 2, 6},
};

template <class Info>
std::string test_name(const Info& info) {
  std::string name = info.param.file;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Known, RealMesh, testing::ValuesIn(meshes),
                         [](const auto& instance) { return test_name(instance); });

struct Refused {
  std::string file;
  std::string why;  // The message after the path.
};

std::ostream& operator<<(std::ostream& out, const Refused& refused) { return out << refused.file; }

class RefusedFile : public testing::TestWithParam<Refused> {};

TEST_P(RefusedFile, IsRefusedWithAReason) {
  WHITTLE_REAL_MESH_OR_SKIP(path, GetParam().file);
  try {
    read_mesh(path);
    FAIL() << "read";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.what(), path.string() + GetParam().why);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Known, RefusedFile,
    testing::Values(
        Refused{"nasty/Duck.glb", ": is glTF (.glb), a format that is not supported; use " + format_titles()},
        Refused{"nasty/cube_tri_version_2_0.om",
                ": is OpenMesh's own format (.om), a format that is not supported; convert it with OpenMesh "
                "('mconvert IN OUT.off')"},
        Refused{"nasty/test-nan.obj", ":12: a coordinate is not finite: \"nan\""},
        Refused{"nasty/inf_nan.obj", ":1: a coordinate is not finite: \"inf\""},
        Refused{"nasty/malformed.obj", ":28: vertex number 0; OBJ counts from 1"},
        Refused{"nasty/zero_face_index.obj", ":16: vertex number 0; OBJ counts from 1"},
        Refused{"nasty/empty.off", ": the file is empty"}, Refused{"nasty/empty_header.ply", ": the file has no faces"},
        Refused{"synthetic/empty_zero_bytes.obj", ": the file is empty"},
        Refused{"synthetic/empty_zero_bytes.off", ": the file is empty"},
        Refused{"synthetic/empty_zero_bytes.ply", ": the file is empty"},
        Refused{"synthetic/empty_zero_bytes.stl", ": the file is empty"},
        Refused{"synthetic/header_only.ply", ": the file has no faces"},
        Refused{"synthetic/index_out_of_range.obj",
                ":17: vertex number 100, but the file has 7 vertices; it may be truncated"},
        Refused{"synthetic/ply_content_named.obj", ": the content is ply, not obj; rename it to .ply"},
        Refused{"synthetic/synth_cow_nan_inf.obj", ":12: a coordinate is not finite: \"nan\""},
        Refused{"synthetic/truncated_binary.ply",
                ": byte 85111: the file ends where a vertex number should be; it is truncated"},
        Refused{"synthetic/vertices_only.off",
                ": the file has 100 vertices but no faces; point clouds are not supported"}),
    [](const auto& instance) { return test_name(instance); });

}  // namespace
}  // namespace whittle::io
