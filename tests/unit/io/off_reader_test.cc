#include <gtest/gtest.h>

#include "io_test_tools.hh"

namespace whittle::io {
namespace {

using test::all_bytes_of;
using test::cat;
using test::expect_error;
using test::read;

const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

TEST(OffReader, ReadsPositionsAndFaces) {
  const ReadResult result = read("OFF\n4 4 6\n" + vertices + faces, "a.off");
  EXPECT_EQ(result.mesh.positions[3], Vec3(0, 0, 1));
  EXPECT_EQ(result.mesh.faces[1], (Triangle{0, 1, 3}));
  EXPECT_EQ(result.format, Format::off);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(OffReader, TakesTheHeadersThatAreAbout) {
  for (const std::string header :
       {"OFF\n4 4 0\n", "OFF 4 4 0\n", "4 4 0\n", "OFF\n4 4\n", "OFF\r\n4 4 0\r\n",
        "# made by hand\n\nOFF # here\n# counts\n4 4 0 # six edges really\n\n", "\xEF\xBB\xBFOFF\n4 4 0\n"}) {
    EXPECT_EQ(read(cat(header, vertices, faces), "a.off").mesh.faces.size(), 4U) << header;
  }
}

TEST(OffReader, SkipsCommentsAndBlankLinesEverywhere) {
  const ReadResult result =
      read("OFF\n3 1 0\n\n# first\n0 0 0 # origin\n1 0 0\n\n0 1 0\n# faces\n3 0 1 2 # the only one\n\n# end", "a.off");
  EXPECT_EQ(result.mesh.faces.size(), 1U);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(OffReader, CarriesNormalsAndColors) {
  const ReadResult result = read(
      "STCNOFF\n3 1 0\n0 0 0 0 0 2 255 0 0 255 0.5 0.5\n1 0 0 0 0 1 0 51 0 0 0 0\n0 1 0 1 0 0 0 0 0 102 0 0\n3 0 1 2\n",
      "a.off");
  EXPECT_EQ(result.mesh.normals[0], (std::array<float, 3>{0, 0, 1}));
  EXPECT_EQ(result.mesh.normals[2], (std::array<float, 3>{1, 0, 0}));
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0, 1}));
  EXPECT_EQ(result.mesh.colors[1], (Color{0, 0.2F, 0, 0}));
  EXPECT_EQ(result.mesh.colors[2], (Color{0, 0, 0, 0.4F}));
  ASSERT_EQ(result.mesh.attributes.size(), 1U);
  EXPECT_EQ(result.mesh.attributes[0].kind, AttributeKind::texcoord);
  EXPECT_EQ(result.mesh.attributes[0].values, (std::vector<double>{0.5, 0.5, 0, 0, 0, 0}));
  EXPECT_TRUE(result.warnings.empty());
}

TEST(OffReader, TakesColorsAsIntegersAndAsReals) {
  const ReadResult bytes = read("COFF\n3 1 0\n0 0 0 255 0 51\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(bytes.mesh.colors[0], (Color{1, 0, 0.2F, 1}));
  const ReadResult reals = read("COFF\n3 1 0\n0 0 0 1 0 0.2 0.5\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n", "a.off");
  EXPECT_EQ(reals.mesh.colors[0], (Color{1, 0, 0.2F, 0.5F}));
}

TEST(OffReader, SaysThatFaceColorsAndExtraNumbersAreLost) {
  const ReadResult result = read("OFF\n3 1 0\n0 0 0 9 9\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n", "a.off");
  EXPECT_EQ(result.warnings, (std::vector<std::string>{
                                 "face colours are not carried",
                                 "numbers after a vertex's coordinates are ignored: the keyword OFF announces none"}));
}

TEST(OffReader, TriangulatesPolygonsAndCountsDegenerateFaces) {
  const ReadResult result = read("OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n3 0 1 1\n", "a.off");
  EXPECT_EQ(result.mesh.faces.size(), 2U);
  EXPECT_EQ(result.repairs.triangulated_polygons, 1U);
  EXPECT_EQ(result.repairs.degenerate_faces, 2U);
}

TEST(OffReader, RejectsLyingCounts) {
  expect_error("OFF\n5 4 0\n" + vertices + faces, "a.off",
               "a.off:11: the file ends where a face's number of corners should be; it may be truncated");
  expect_error("OFF\n3 4 0\n" + vertices + faces, "a.off",
               "a.off:6: a face of 0 corners; the file is truncated or invalid");
  expect_error("OFF\n4 5 0\n" + vertices + faces, "a.off",
               "a.off:11: the file ends where a face's number of corners should be; it may be truncated");
  expect_error("OFF\n4 3 0\n" + vertices + faces, "a.off",
               "a.off:10: the file goes on after the 3 faces it announces; its counts are wrong");
}

TEST(OffReader, RejectsAbsurdCountsBeforeItAllocates) {
  expect_error("OFF\n4000000000 4 0\n" + vertices + faces, "a.off",
               "a.off:2: the file is too short for 4000000000 vertices and 4 faces; it is truncated or its counts are "
               "wrong");
  expect_error("OFF\n4 4000000000 0\n" + vertices + faces, "a.off",
               "a.off:2: the file is too short for 4 vertices and 4000000000 faces; it is truncated or its counts are "
               "wrong");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3000000000 0 1 2\n", "a.off",
               "a.off:6: a face of 3000000000 corners; the file is truncated or invalid");
  expect_error("OFF\n-4 4 0\n" + vertices + faces, "a.off", "a.off:2: the number of vertices is negative");
}

TEST(OffReader, RejectsMoreElementsThanAMeshCanHave) {
  expect_error("OFF\n5000000000 4 0\n", "a.off",
               "a.off:2: the number of vertices is 5000000000, more than the 4294967295 a mesh can have");
}

TEST(OffReader, RejectsBadNumbersByLine) {
  expect_error("OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "a.off", "a.off:4: a coordinate is not finite: \"nan\"");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.off",
               "a.off:4: the line ends where a coordinate should be");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off",
               "a.off:6: vertex number 3, but the file has 3 vertices, counted from 0");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off",
               "a.off:6: vertex number -1, but the file has 3 vertices, counted from 0");
}

TEST(OffReader, RefusesOtherDimensions) {
  expect_error("4OFF\n1 1 1\n", "a.off", "a.off:1: \"4OFF\": only three-dimensional OFF is read");
  expect_error("nOFF\n5\n1 1 1\n", "a.off", "a.off:1: \"nOFF\": only three-dimensional OFF is read");
}

// Geomview's layout, big endian.
std::string geomview_binary() {
  const auto big = std::endian::big;
  return "CNOFF BINARY\n" + all_bytes_of(big, 3, 1, 0) +
         all_bytes_of(big, 0.F, 0.F, 0.5F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.5F, 1.F) +
         all_bytes_of(big, 1.F, 0.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F) +
         all_bytes_of(big, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F) +
         all_bytes_of(big, 3, 0, 1, 2, 3, 1.F, 1.F, 1.F);
}

TEST(OffReader, ReadsBinaryAsGeomviewHasIt) {
  const ReadResult result = read(geomview_binary(), "a.off");
  EXPECT_EQ(result.mesh.positions[0], Vec3(0, 0, 0.5));
  EXPECT_EQ(result.mesh.normals[1], (std::array<float, 3>{0, 0, 1}));
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0.5F, 1}));
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"face colours are not carried"}));
}

TEST(OffReader, ReadsBinaryAsOpenMeshWritesIt) {
  const auto little = std::endian::little;
  const std::string vertex_part = all_bytes_of(little, 0.F, 0.F, 0.5F, 255, 0, 51) +
                                  all_bytes_of(little, 1.F, 0.F, 0.F, 0, 0, 0) +
                                  all_bytes_of(little, 0.F, 1.F, 0.F, 0, 0, 0);
  const ReadResult result =
      read("COFF BINARY\n" + all_bytes_of(little, 3, 1, 0) + vertex_part + all_bytes_of(little, 3, 0, 1, 2), "a.off");
  EXPECT_EQ(result.mesh.positions[0], Vec3(0, 0, 0.5));
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0.2F, 1}));
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(OffReader, RejectsWrongBinaryDataByOffset) {
  const auto big = std::endian::big;
  const std::string start = "OFF BINARY\n" + all_bytes_of(big, 3, 1, 0);
  const std::string points = all_bytes_of(big, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F);
  expect_error(start + points + all_bytes_of(big, 3, 0, 1, 7, 0), "a.off",
               "a.off: byte 71: vertex number 7, but the file has 3 vertices, counted from 0");
  expect_error(start + points + all_bytes_of(big, 3, 0, 1), "a.off",
               "a.off: byte 59: a face of 3 corners; the file is truncated or invalid");
  expect_error("OFF BINARY\n" + all_bytes_of(big, 1000, 1, 0) + points, "a.off",
               "a.off: byte 11: the file is too short for 1000 vertices and 1 faces; it is truncated or its "
               "counts are wrong");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_error(
      start + all_bytes_of(big, 0.F, nan, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F) + all_bytes_of(big, 3, 0, 1, 2, 0),
      "a.off", "a.off: byte 27: a coordinate is not finite");
}

TEST(OffReader, ExpectsFaceColorsInWrongDataOfGeomviewAlone) {
  const auto file = [](std::endian order) {
    return "OFF BINARY\n" + all_bytes_of(order, 3, 1, 0) +
           all_bytes_of(order, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F) + all_bytes_of(order, 3, 0, 1, 2, 7);
  };
  expect_error(file(std::endian::big), "a.off", "a.off: byte 75: 7 colour components; the file is invalid");
  expect_error(file(std::endian::little), "a.off",
               "a.off: byte 75: the file goes on after the 1 faces it announces; its counts are wrong");
}

}  // namespace
}  // namespace whittle::io
