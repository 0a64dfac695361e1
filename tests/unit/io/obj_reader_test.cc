#include <gtest/gtest.h>

#include "io_test_tools.hh"

namespace whittle::io {
namespace {

using test::cat;
using test::error_of;
using test::expect_error;
using test::read;
using test::read_per_vertex;

const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron_faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

TEST(ObjReader, ReadsPositionsAndFaces) {
  const ReadResult result = read("# a comment\nv 0.5 -1e-3 +2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  ASSERT_EQ(result.mesh.positions.size(), 3U);
  EXPECT_EQ(result.mesh.positions[0], Vec3(0.5, -1e-3, 2));
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(result.mesh.origins, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(result.format, Format::obj);
  EXPECT_EQ(result.file_vertices, 3U);
  EXPECT_EQ(result.file_faces, 1U);
  EXPECT_FALSE(result.repairs.any());
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ObjReader, ReadsColorsInCommentsOfZBrush) {
  const std::string colors = "#MRGB ff8040ffff000000\n#MRGB 00ffffff000000ff\n";
  const ReadResult result = read(cat("#Mask\n", tetrahedron, colors, tetrahedron_faces), "a.obj");
  ASSERT_EQ(result.mesh.colors.size(), 4U);
  EXPECT_EQ(result.mesh.colors[0], (Color{128 / 255.0F, 64 / 255.0F, 1, 1}));
  EXPECT_EQ(result.mesh.colors[1], (Color{0, 0, 0, 1}));
  EXPECT_EQ(result.mesh.colors[3], (Color{0, 0, 1, 1}));
  EXPECT_TRUE(result.warnings.empty());

  const ReadResult own =
      read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n#MRGB ff00ff00ff00ff00ff00ff00\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(own.mesh.colors[0], (Color{1, 0, 0, 1})) << "the colours behind positions go first";

  for (const std::string bad :
       {"#MRGB ff8040ff\n", "#MRGB ff8040f\n", "#MRGB nothing!\n", "#MRGB\n", "#MRGBff8040ff\n"}) {
    const ReadResult without = read(cat(tetrahedron, bad, tetrahedron_faces), "a.obj");
    EXPECT_TRUE(without.mesh.colors.empty()) << bad;
    const bool has_colors = bad == "#MRGB ff8040ff\n";
    EXPECT_EQ(without.warnings.size(), has_colors ? 1U : 0U) << bad;
    if (!has_colors) continue;
    EXPECT_NE(without.warnings.at(0).find("there are 1 for 4 vertices"), std::string::npos);
  }
}

TEST(ObjReader, SaysWhereEachVertexOfTheFileWent) {
  const ReadResult result = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 2 3 5\n", "a.obj");
  EXPECT_EQ(result.vertex_map, (std::vector<Index>{invalid_index, 0, 1, invalid_index, 2}));
  EXPECT_EQ(result.mesh.origins, (std::vector<Index>{1, 2, 4}));
  EXPECT_EQ(result.repairs.isolated_vertices, 2U);
}

TEST(ObjReader, CountsNegativeNumbersFromTheLastVertex) {
  const ReadResult result = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -1 -3\n", "a.obj");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}}));
}

TEST(ObjReader, TakesEveryFormOfACorner) {
  const std::string start = tetrahedron + "vt 0 0\nvn 0 0 1\n";
  for (const std::string corner : {"", "/", "/1", "//1", "/1/1", "/-1/-1", "/1/"}) {
    const std::string face = cat("f 1", corner, " 2", corner, " 3", corner, "\n");
    const ReadResult result = read(cat(start, face, tetrahedron_faces), "a.obj");
    EXPECT_EQ(result.mesh.faces[0], (Triangle{0, 1, 2})) << face;
  }
}

TEST(ObjReader, TakesEveryKindOfLineEnd) {
  const std::string unix_text = tetrahedron + tetrahedron_faces;
  const ReadResult expected = read(unix_text, "a.obj");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : unix_text) text += c == '\n' ? end : std::string(1, c);
    const ReadResult result = read(text, "a.obj");
    EXPECT_EQ(result.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(result.mesh.faces, expected.mesh.faces);
  }
  EXPECT_EQ(read(unix_text.substr(0, unix_text.size() - 1), "a.obj").mesh.faces, expected.mesh.faces);
}

TEST(ObjReader, CountsLinesRightWithEveryKindOfLineEnd) {
  expect_error("v 0 0 0\nv 1 0 0\nv x 0 0\n", "a.obj", "a.obj:3: a coordinate expected, found \"x\"");
  expect_error("v 0 0 0\r\nv 1 0 0\r\nv x 0 0\r\n", "a.obj", "a.obj:3: a coordinate expected, found \"x\"");
  expect_error("v 0 0 0\rv 1 0 0\rv x 0 0\r", "a.obj", "a.obj:3: a coordinate expected, found \"x\"");
}

TEST(ObjReader, JoinsLinesThatABackslashContinues) {
  const ReadResult result = read("v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n2 \\\n  3\n", "a.obj");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
  expect_error("v 0 0 \\\n 0\nv 1 0 0\nf 1 2 9\n", "a.obj",
               "a.obj:4: vertex number 9, but the file has 2 vertices; it may be truncated");
}

TEST(ObjReader, LetsFacesUseVerticesThatComeLater) {
  const ReadResult result = read("f 1//1 2//1 3//1\nf 1 3 4 5\nvn 0 0 2\n" + tetrahedron + "v 0 0.5 1\n", "a.obj");
  EXPECT_EQ(result.mesh.faces.size(), 3U);
  EXPECT_EQ(result.mesh.normals[0], (std::array<float, 3>{0, 0, 1}));
  EXPECT_EQ(result.repairs.triangulated_polygons, 1U);
}

TEST(ObjReader, CarriesVertexColors) {
  const ReadResult result = read("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0 0.25\nv 0 1 0\nf 1 2 3\n", "a.obj");
  ASSERT_EQ(result.mesh.colors.size(), 3U);
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0, 1}));
  EXPECT_EQ(result.mesh.colors[1], (Color{0, 0.5, 0, 0.25}));
  EXPECT_EQ(result.mesh.colors[2], (Color{1, 1, 1, 1}));  // A vertex without a colour is white.
}

TEST(ObjReader, ScalesColorsOfUpTo255) {
  const ReadResult result = read("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0.2F, 1}));
}

TEST(ObjReader, IgnoresTheWeightOfAVertex) {
  const ReadResult result = read("v 0 0 0 1.0\nv 1 0 0 1.0\nv 0 1 0 1.0\nf 1 2 3\n", "a.obj");
  EXPECT_TRUE(result.mesh.colors.empty());
}

TEST(ObjReader, AveragesNormalsThatDifferBetweenCorners) {
  const std::string normals = "vn 1 0 0\nvn 0 1 0\nvn 0 1 0\n";
  const std::string faces = "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 1//2 4//3 3//3\n";
  const ReadResult result = read_per_vertex(tetrahedron + normals + faces, "a.obj");
  const float half = std::sqrt(0.5F);
  EXPECT_NEAR(result.mesh.normals[0][0], half, 1e-6);
  EXPECT_NEAR(result.mesh.normals[0][1], half, 1e-6);
  EXPECT_EQ(result.mesh.normals[3], (std::array<float, 3>{0, 1, 0}));
  EXPECT_EQ(result.warnings,
            (std::vector<std::string>{"normals that differ between the corners of a vertex were averaged"}));
}

TEST(ObjReader, IgnoresNormalsItCannotFindAndSaysSo) {
  for (const std::string number : {"9", "0", "-9"}) {
    const ReadResult result =
        read(cat(tetrahedron, "vn 0 0 1\n", tetrahedron_faces, "f 1//1 2//1 3//", number), "a.obj");
    EXPECT_TRUE(result.mesh.normals.empty());
    ASSERT_EQ(result.warnings.size(), 1U) << number;
    EXPECT_NE(result.warnings[0].find("normals are ignored"), std::string::npos);
  }
}

TEST(ObjReader, NamesWhatItDoesNotCarry) {
  const std::string obj = "mtllib a.mtl\no one\n" + tetrahedron +
                          "vt 0 0\ng left\nusemtl red\ns 1\nf 1/1 2/1 3/1\ng right\nl 1 2\np 1\nfoo 1 2\n" +
                          "cstype bezier\nsurf 0 1 0 1 1 2 3\n";
  std::vector<std::string> expected = {"lines and points (l, p) are not carried",
                                       "free-form curves and surfaces (curv, surf) are not read",
                                       "1 unknown statements ignored, the first in line 15: \"foo\""};
  EXPECT_EQ(read(obj, "a.obj").warnings, expected);
  expected.insert(expected.begin(),
                  {"texture coordinates (vt) are not carried", "materials (usemtl) are not carried",
                   "groups and object names (g, o) are not carried", "smoothing groups (s) are not carried"});
  EXPECT_EQ(read_per_vertex(obj, "a.obj").warnings, expected);
}

TEST(ObjReader, SaysNothingOfSmoothingThatIsOffAndOfOneName) {
  const ReadResult result = read("o only\ns off\n" + tetrahedron + tetrahedron_faces, "a.obj");
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ObjReader, TriangulatesPolygonsInTheirPlaces) {
  const ReadResult result = read(tetrahedron + "v 1 1 0\nf 1 3 4\nf 1 2 5 3\nf 2 3 4\n", "a.obj");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 2, 3}, {0, 1, 4}, {0, 4, 2}, {1, 2, 3}}));
  EXPECT_EQ(result.repairs.triangulated_polygons, 1U);
  EXPECT_EQ(result.file_faces, 3U);
}

TEST(ObjReader, DropsCornersThatRepeatTheirNeighbour) {
  const ReadResult result = read(tetrahedron + "f 1 2 2 3\nf 1 1 2 4 4 1\nf 2 2 3 3\n", "a.obj");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(result.repairs.degenerate_faces, 1U);
  EXPECT_EQ(result.repairs.triangulated_polygons, 0U);
}

TEST(ObjReader, RejectsIndexZero) {
  expect_error(tetrahedron + "f 1 2 3\nf 0 1 2\n", "a.obj", "a.obj:6: vertex number 0; OBJ counts from 1");
}

TEST(ObjReader, RejectsIndicesOutOfRange) {
  expect_error(tetrahedron + "f 1 2 5\n", "a.obj",
               "a.obj:5: vertex number 5, but the file has 4 vertices; it may be truncated");
  expect_error(tetrahedron + "f 1 2 -5\n", "a.obj",
               "a.obj:5: vertex number -5 reaches back before the first of the 4 vertices so far");
  const auto error = error_of(tetrahedron + "f 1 2 5000000000\n", "a.obj");
  EXPECT_NE(std::string(error->what()).find("more than the 4294967295 vertices a mesh can have"), std::string::npos);
  EXPECT_NE(std::string(error_of(tetrahedron + "f 1 2 99999999999999999999\n", "a.obj")->what()).find("too large"),
            std::string::npos);
}

TEST(ObjReader, RejectsCoordinatesThatAreNotFinite) {
  for (const std::string bad : {"nan", "inf", "-inf", "NaN", "1e999", "-infinity"}) {
    expect_error("v 0 0 0\nv 0 " + bad + " 0\n", "a.obj", "a.obj:2: a coordinate is not finite: \"" + bad + '"');
  }
}

TEST(ObjReader, RejectsWhatIsNoNumber) {
  for (const std::string bad : {"1.#IND", "1,5", "0x10", "--1", "1e", "abc", "1.5f"}) {
    expect_error("v 0 0 0\nv 0 " + bad + " 0\n", "a.obj", "a.obj:2: a coordinate expected, found \"" + bad + '"');
  }
  expect_error("v 0 0\nv 1 0 0\n", "a.obj", "a.obj:1: the line ends where a coordinate should be");
  expect_error("v 0 0 0\nv 1 0", "a.obj", "a.obj:2: the file ends where a coordinate should be; it may be truncated");
  expect_error(tetrahedron + "f 1 2 x\n", "a.obj", "a.obj:5: a vertex number expected, found \"x\"");
  expect_error(tetrahedron + "f 1 2 3.5\n", "a.obj", "a.obj:5: a vertex number expected, found \".5\"");
  expect_error("v 0 0 0 1 1 1 1 1\n", "a.obj", "a.obj:1: a vertex has at most seven numbers");
}

TEST(ObjReader, DropsAndCountsFacesOfFewerThanThreeCorners) {
  const ReadResult expected = read(tetrahedron + tetrahedron_faces, "a.obj");
  for (const std::string face :
       {"f 1 2", "f 1", "f", "f 1/1/1 2/1/1", "f 1//1", "f 3 # a point", "f -1 -2", "fo 1 2"}) {
    const std::string start = tetrahedron + "vt 0 0\nvn 0 0 1\n";
    for (const std::string& text :
         {cat(start, face, "\n", tetrahedron_faces), cat(start, tetrahedron_faces, face, "\n")}) {
      const ReadResult result = read(text, "a.obj");
      EXPECT_EQ(result.mesh.faces, expected.mesh.faces) << face;
      EXPECT_EQ(result.repairs.degenerate_faces, 1U) << face;
      EXPECT_EQ(result.file_faces, 5U) << face;
      EXPECT_TRUE(result.warnings.empty()) << face;
    }
  }
}

TEST(ObjReader, KeepsTheTagsOfTheFacesBesideDroppedOnes) {
  const ReadResult result = read(tetrahedron + "usemtl a\nf 1 3 2\nf 1 2\nusemtl b\nf 1\nf 1 2 4\n", "a.obj");
  EXPECT_EQ(result.mesh.group_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(result.mesh.face_groups, (std::vector<Index>{0, 1}));
}

TEST(ObjReader, WarnsOfAFaceThatTheEndOfTheFileCutsOff) {
  const ReadResult result = read(tetrahedron + tetrahedron_faces + "f 1 2", "a.obj");
  EXPECT_EQ(result.repairs.degenerate_faces, 1U);
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"the file ends in line 9 within a face: it may be truncated"}));
}

TEST(ObjReader, RejectsWrongNumbersInFacesOfFewerThanThreeCorners) {
  expect_error(tetrahedron + tetrahedron_faces + "f 0 1\n", "a.obj", "a.obj:9: vertex number 0; OBJ counts from 1");
  expect_error(tetrahedron + tetrahedron_faces + "f 1 9\n", "a.obj",
               "a.obj:9: vertex number 9, but the file has 4 vertices; it may be truncated");
  expect_error(tetrahedron + tetrahedron_faces + "f 1 x\n", "a.obj", "a.obj:9: a vertex number expected, found \"x\"");
}

TEST(ObjReader, RejectsFilesWithoutFaces) {
  expect_error(tetrahedron, "a.obj", "a.obj: the file has 4 vertices but no faces; point clouds are not supported");
  expect_error("# nothing\n", "a.obj", "a.obj: the file has no faces");
  expect_error(tetrahedron + "f 1 1 2\n", "a.obj",
               "a.obj: no face is left of 1: all are degenerate (dropped 1 degenerate face, 4 isolated vertices)");
  expect_error(tetrahedron + "f 1 2\n", "a.obj",
               "a.obj: no face is left of 1: all are degenerate (dropped 1 degenerate face, 4 isolated vertices)");
}

}  // namespace
}  // namespace whittle::io
