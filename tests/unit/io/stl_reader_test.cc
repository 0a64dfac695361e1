#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "io_test_tools.hh"

namespace whittle::io {
namespace {

using test::all_bytes_of;
using test::bytes_of;
using test::error_of;
using test::expect_error;
using test::read;

std::string facet_text(const std::string& a, const std::string& b, const std::string& c) {
  return "  facet normal 0 0 1\n    outer loop\n      vertex " + a + "\n      vertex " + b + "\n      vertex " + c +
         "\n    endloop\n  endfacet\n";
}

const std::string two_facets = facet_text("0 0 0", "1 0 0", "0 1 0") + facet_text("1 0 0", "1 1 0", "0 1 0");

std::string facet_bytes(const std::vector<float>& corners, std::uint16_t attribute = 0) {
  std::string bytes = all_bytes_of(std::endian::little, 0.F, 0.F, 1.F);
  for (const float x : corners) bytes += bytes_of(x);
  return bytes + bytes_of(attribute);
}

std::string binary(const std::string& header, std::uint32_t count, const std::string& facets) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  return bytes + bytes_of(count) + facets;
}

const std::string two_binary_facets =
    facet_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}) + facet_bytes({1, 0, 0, 1, 1, 0, 0, 1, 0});

TEST(StlReader, ReadsText) {
  const ReadResult result = read("solid two facets\n" + two_facets + "endsolid two facets\n", "a.stl");
  EXPECT_EQ(result.file_vertices, 6U);
  EXPECT_EQ(result.file_faces, 2U);
  EXPECT_EQ(result.mesh.positions.size(), 4U);
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(result.mesh.origins, (std::vector<Index>{0, 1, 2, 4}));
  EXPECT_EQ(result.vertex_map, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(result.repairs.welded_vertices, 2U);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(StlReader, KeepsTheSoupWhenNotWelding) {
  const ReadResult result = read("solid\n" + two_facets + "endsolid\n", "a.stl", false);
  EXPECT_EQ(result.mesh.positions.size(), 6U);
  EXPECT_EQ(result.mesh.origins, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
}

TEST(StlReader, TakesUpperCaseOddSpacingAndLineEnds) {
  std::string text = "SOLID\r\nFACET NORMAL nan nan nan OUTER LOOP\rVERTEX 0 0 0 VERTEX 1 0 0\tVERTEX 0 1 0 ENDLOOP\n";
  EXPECT_NE(error_of(text + "ENDFACET ENDSOLID", "a.stl"), std::nullopt);  // The normal's whole line is skipped.
  text =
      "SOLID\r\n  FACET NORMAL nan nan nan\r\n OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0\tVERTEX 0 1 0 ENDLOOP\rENDFACET "
      "ENDSOLID x";
  EXPECT_EQ(read(text, "a.stl").mesh.faces.size(), 1U);
}

TEST(StlReader, JoinsSeveralSolids) {
  const ReadResult result = read("solid a\n" + facet_text("0 0 0", "1 0 0", "0 1 0") + "endsolid a\n\nsolid b\n" +
                                     facet_text("1 0 0", "1 1 0", "0 1 0") + "endsolid b\n",
                                 "a.stl");
  EXPECT_EQ(result.mesh.faces.size(), 2U);
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"the names of 2 solids are not carried"}));
}

TEST(StlReader, ReadsBinary) {
  const ReadResult result = read(binary("header", 2, two_binary_facets), "a.stl");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(result.mesh.positions[3], Vec3(1, 1, 0));
  EXPECT_TRUE(result.warnings.empty());
}

TEST(StlReader, KnowsABinaryFileThatStartsWithSolidByItsSize) {
  const ReadResult result = read(binary("solid facet normal 0 0 1", 2, two_binary_facets), "a.stl");
  EXPECT_EQ(result.mesh.faces.size(), 2U);
}

TEST(StlReader, SaysThatAttributeBytesAreLost) {
  const ReadResult result = read(binary("", 1, facet_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0x801F)), "a.stl");
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"attribute bytes (often facet colours) are not carried"}));
}

TEST(StlReader, RejectsBinaryFilesWhoseSizeContradictsTheirCount) {
  expect_error(
      binary("x", 3, two_binary_facets), "a.stl",
      "a.stl: byte 80: the file is too short for 3 facets, there are 2; it is truncated or its count is wrong");
  expect_error(binary("solid x", 4000000000, two_binary_facets), "a.stl",
               "a.stl: 4000000000 facets have more corners than the 4294967295 vertices a mesh can have");
  expect_error(binary("x", 1, two_binary_facets), "a.stl",
               "a.stl: byte 80: the file goes on after the 1 facets it announces, to 2; its count is wrong");
  expect_error(binary("x", 0, ""), "a.stl", "a.stl: the file has no faces");
  expect_error("solid", "a.stl",
               "a.stl:1: the file ends where \"facet\" or \"endsolid\" should be; it may be truncated");
  EXPECT_EQ(read(binary("x", 2, two_binary_facets + "  "), "a.stl").warnings,
            (std::vector<std::string>{"2 bytes after the last facet are ignored"}));
}

TEST(StlReader, RejectsCoordinatesThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_error(binary("", 1, facet_bytes({0, 0, 0, 1, nan, 0, 0, 1, 0})), "a.stl",
               "a.stl: byte 112: a coordinate is not finite");
  expect_error("solid\n" + facet_text("0 0 0", "1 inf 0", "0 1 0") + "endsolid\n", "a.stl",
               "a.stl:5: a coordinate is not finite: \"inf\"");
}

TEST(StlReader, RejectsBrokenTextByLine) {
  expect_error("solid\n" + facet_text("0 0 0", "1 0", "0 1 0") + "endsolid\n", "a.stl",
               "a.stl:5: the line ends where a coordinate should be");
  expect_error("solid\n" + two_facets, "a.stl",
               "a.stl:16: the file ends where \"facet\" or \"endsolid\" should be; it may be truncated");
  expect_error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid",
               "a.stl", "a.stl:6: \"vertex\" expected, found \"endloop\"");
  expect_error("solid\nfacets\nendsolid", "a.stl", "a.stl:2: \"facet\" or \"endsolid\" expected, found \"facets\"");
}

}  // namespace
}  // namespace whittle::io
