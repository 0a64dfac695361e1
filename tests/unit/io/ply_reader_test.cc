#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "io_test_tools.hh"

namespace whittle::io {
namespace {

using test::all_bytes_of;
using test::bytes_of;
using test::cat;
using test::error_of;
using test::expect_error;
using test::read;

const std::string ascii_start = "ply\nformat ascii 1.0\n";
const std::string three_vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string end = "end_header\n";
const std::string triangle = ascii_start + three_vertices + one_face + end + "0 0 0.5\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(PlyReader, ReadsText) {
  const ReadResult result = read(triangle, "a.ply");
  EXPECT_EQ(result.mesh.positions[0], Vec3(0, 0, 0.5));
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(result.format, Format::ply);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(PlyReader, TakesNamesInUpperCaseWhereNoOtherPropertyHasThem) {
  const std::string names =
      "property float X\nproperty float Y\nproperty float Z\nproperty uchar Red\n"
      "property uchar Green\nproperty uchar Blue\n";
  const std::string rows = "0 0 0.5 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n";
  const ReadResult result = read(cat(ascii_start, "element vertex 3\n", names, one_face, end, rows), "a.ply");
  EXPECT_EQ(result.mesh.positions[0], Vec3(0, 0, 0.5));
  ASSERT_EQ(result.mesh.colors.size(), 3U);
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0, 1}));
  EXPECT_TRUE(result.mesh.attributes.empty());

  const std::string both = cat(three_vertices, "property float X\n");
  const ReadResult apart =
      read(cat(ascii_start, both, one_face, end, "0 0 0.5 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n"), "a.ply");
  EXPECT_EQ(apart.mesh.positions[1], Vec3(1, 0, 0));
  ASSERT_EQ(apart.mesh.attributes.size(), 1U);
  EXPECT_EQ(apart.mesh.attributes[0].name, "X");
}

TEST(PlyReader, TakesEveryKindOfLineEnd) {
  for (const std::string line_end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : triangle) text += c == '\n' ? line_end : std::string(1, c);
    EXPECT_EQ(read(text, "a.ply").mesh.faces.size(), 1U);
  }
}

template <class Number>
void put(std::string& bytes, std::endian order, double value) {
  bytes += bytes_of(static_cast<Number>(value), order);
}

struct Type {
  std::string name;
  void (*put)(std::string&, std::endian, double);
};

const std::vector<Type> integer_types = {{"char", put<std::int8_t>},   {"uint8", put<std::uint8_t>},
                                         {"short", put<std::int16_t>}, {"uint16", put<std::uint16_t>},
                                         {"int32", put<std::int32_t>}, {"uint", put<std::uint32_t>}};
const std::vector<Type> all_types = [] {
  std::vector<Type> types = integer_types;
  types.push_back({"float32", put<float>});
  types.push_back({"double", put<double>});
  return types;
}();

TEST(PlyReader, ReadsCoordinatesOfEveryTypeInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const Type& type : all_types) {
      const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
      std::string bytes = cat("ply\nformat ", format, " 1.0\nelement vertex 3\nproperty ", type.name, " x\nproperty ",
                              type.name, " y\nproperty ", type.name, " z\n", one_face, end);
      for (const double x : {1, 2, 3, 40, 50, 60, 7, 8, 100}) type.put(bytes, order, x);
      bytes += bytes_of(std::uint8_t{3}) + all_bytes_of(order, 0, 1, 2);
      const ReadResult result = read(bytes, "a.ply");
      EXPECT_EQ(result.mesh.positions[1], Vec3(40, 50, 60)) << format << " " << type.name;
      EXPECT_EQ(result.mesh.positions[2], Vec3(7, 8, 100)) << format << " " << type.name;
    }
  }
}

TEST(PlyReader, ReadsListsOfEveryTypeInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const Type& length_type : all_types) {
      for (const Type& type : all_types) {
        const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
        std::string bytes = cat("ply\nformat ", format, " 1.0\n", three_vertices, "element face 1\nproperty list ",
                                length_type.name, " ", type.name, " vertex_index\n", end,
                                all_bytes_of(order, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F));
        length_type.put(bytes, order, 3);
        for (const double corner : {2, 0, 1}) type.put(bytes, order, corner);
        EXPECT_EQ(read(bytes, "a.ply").mesh.faces[0], (Triangle{2, 0, 1})) << length_type.name << " " << type.name;
      }
    }
  }
}

TEST(PlyReader, TakesPropertiesInAnyOrderAndElementsToo) {
  const ReadResult result = read(ascii_start + one_face +
                                     "element vertex 3\nproperty uchar blue\nproperty float z\nproperty double y\n"
                                     "property uchar red\nproperty int x\nproperty uchar green\n" +
                                     end + "3 0 1 2\n51 5 0 255 1 0\n0 0 1 0 0 0\n0 0 0 0 0 0\n",
                                 "a.ply");
  EXPECT_EQ(result.mesh.positions[0], Vec3(1, 0, 5));
  EXPECT_EQ(result.mesh.colors[0], (Color{1, 0, 0.2F, 1}));
  EXPECT_EQ(result.mesh.faces[0], (Triangle{0, 1, 2}));
}

TEST(PlyReader, CarriesNormalsAndColorsOfEveryScale) {
  const std::string positions = three_vertices;
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  const auto colors = [](const std::string& type) {
    return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\nproperty " + type +
           " alpha\n";
  };
  const auto color_of = [&](const std::string& type, const std::string& values) {
    const ReadResult result = read(ascii_start + positions + normals + colors(type) + one_face + end + "0 0 0 0 0 4 " +
                                       values + "\n1 0 0 0 1 0 0 0 0 0\n0 1 0 0 0 0 0 0 0 0\n3 0 1 2\n",
                                   "a.ply");
    EXPECT_EQ(result.mesh.normals[0], (std::array<float, 3>{0, 0, 1}));
    EXPECT_EQ(result.mesh.normals[2], (std::array<float, 3>{0, 0, 0}));
    return result.mesh.colors[0];
  };
  EXPECT_EQ(color_of("uchar", "255 51 0 102"), (Color{1, 0.2F, 0, 0.4F}));
  EXPECT_EQ(color_of("uchar", "1 1 0 0"), (Color{1 / 255.F, 1 / 255.F, 0, 0}));
  EXPECT_EQ(color_of("ushort", "65535 13107 0 0"), (Color{1, 0.2F, 0, 0}));
  EXPECT_EQ(color_of("float", "1 0.2 0 0.4"), (Color{1, 0.2F, 0, 0.4F}));
  EXPECT_EQ(color_of("float", "255 51 0 102"), (Color{1, 0.2F, 0, 0.4F}));
}

TEST(PlyReader, NamesPropertiesAndElementsItDoesNotCarry) {
  const std::string ply =
      ascii_start + "comment made up\nobj_info none\n" + three_vertices +
      "property float confidence\nproperty uchar red\nproperty list uchar float extra\n" + one_face +
      "property uchar flags\nproperty list uchar float texcoord\nproperty list uchar int holes\nelement edge 2\n"
      "property int vertex1\nproperty int vertex2\nelement nothing 0\nproperty int a\nelement empty 9\n" +
      end + "0 0 0 0.5 9 2 1 2\n1 0 0 0.5 9 0\n0 1 0 0.5 9 1 3\n3 0 1 2 7 6 0 0 0.5 0.5 1 1 0\n0 1\n1 2\n";
  EXPECT_EQ(read(ply, "a.ply").warnings,
            (std::vector<std::string>{"vertex properties not carried: extra", "face properties not carried: holes",
                                      "elements \"edge\" are not carried"}));
  EXPECT_EQ(test::read_per_vertex(ply, "a.ply").warnings,
            (std::vector<std::string>{"vertex properties not carried: confidence, red, extra",
                                      "face properties not carried: flags, texcoord, holes",
                                      "elements \"edge\" are not carried"}));
}

TEST(PlyReader, RoundsTextToTheDeclaredType) {
  const std::string rest =
      "element face 1\nproperty list uchar int vertex_indices\n" + end + "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(read(ascii_start + three_vertices + rest, "a.ply").mesh.positions[0].x(), static_cast<double>(0.1F));
  const std::string doubles = "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
  EXPECT_EQ(read(ascii_start + doubles + rest, "a.ply").mesh.positions[0].x(), 0.1);
}

TEST(PlyReader, ReadsTriangleStripsWithRestarts) {
  const std::string vertices = "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string positions = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
  const std::vector<Triangle> expected = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {0, 2, 5}};
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const ReadResult text =
      read(ascii_start + vertices + strips + end + positions + "11 0 1 2 3 4 5 -1\n0 2 5 -1\n", "a.ply");
  EXPECT_EQ(text.mesh.faces, expected);
  EXPECT_EQ(text.file_faces, 5U);

  const auto little = std::endian::little;
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\n" + vertices +
      "element tristrips 2\nproperty uchar kind\nproperty list int uint vertex_indices\n" + end +
      all_bytes_of(little, 0.F, 0.F, 0.F, 0.F, 1.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 2.F, 0.F, 0.F, 2.F, 1.F, 0.F) +
      "a" + all_bytes_of(little, 7, 0, 1, 2, 3, 4, 5, -1) + "b" + all_bytes_of(little, 3, 0, 2, 5);
  EXPECT_EQ(read(binary, "a.ply").mesh.faces, expected);
}

/// They are of the file's vertices, also of those that are in no face, or become one.
TEST(PlyReader, GivesTolerancesAsStored) {
  const std::string header =
      "element vertex 4\nproperty float x\nproperty double tolerance\nproperty float y\nproperty float z\n" + one_face +
      end;
  const std::vector<double> expected{0.5, 1e-300, 0, -2};
  const std::string text = ascii_start + header + "0 0.5 0 0\n1 1e-300 0 0\n0 0 1 0\n9 -2 9 9\n3 0 1 2\n";
  EXPECT_EQ(read(text, "a.ply").tolerances, expected);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    const std::string bytes =
        "ply\nformat " + format + " 1.0\n" + header +
        all_bytes_of(order, 0.F, 0.5, 0.F, 0.F, 1.F, 1e-300, 0.F, 0.F, 0.F, 0.0, 1.F, 0.F, 9.F, -2.0, 9.F, 9.F) +
        bytes_of(std::uint8_t{3}, order) + all_bytes_of(order, 0, 1, 2);
    EXPECT_EQ(read(bytes, "a.ply").tolerances, expected);
  }
  EXPECT_TRUE(read(triangle, "a.ply").tolerances.empty());
}

TEST(PlyReader, TakesEqualVerticesInAStripForItsSeams) {
  const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const ReadResult result =
      read(ascii_start + vertices + "element tristrips 1\nproperty list int int vertex_indices\n" + end +
               "0 0 0\n1 0 0\n0 1 0\n0 0 1\n8 0 1 2 2 0 0 2 3\n",
           "a.ply");
  EXPECT_EQ(result.mesh.faces, (std::vector<Triangle>{{0, 1, 2}, {2, 0, 3}}));
  EXPECT_EQ(result.repairs.degenerate_faces, 0U);
}

TEST(PlyReader, TakesDataThatBeginsWithALineBreak) {
  // The data begin with 0x0A. Only the line break of end_header may be skipped.
  const std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\n"
      "property uchar y\nproperty uchar z\n" +
      one_face + end + std::string("\x0A\x0D\x0A\x01\x00\x00\x00\x01\x00", 9) + "\x03" +
      all_bytes_of(std::endian::little, 0, 1, 2);
  EXPECT_EQ(read(bytes, "a.ply").mesh.positions[0], Vec3(10, 13, 10));
}

TEST(PlyReader, RejectsBadHeadersByLine) {
  const std::string rest = three_vertices + one_face + end;
  expect_error("ply\n" + rest, "a.ply", "a.ply:8: the header has no format line");
  expect_error("ply\nformat binary 1.0\n" + rest, "a.ply", "a.ply:2: unknown format \"binary\"");
  expect_error(ascii_start + "property float x\n" + rest, "a.ply", "a.ply:3: a property before any element");
  expect_error(ascii_start + "elements vertex 3\n" + rest, "a.ply", "a.ply:3: unknown word \"elements\" in the header");
  expect_error(ascii_start + "element vertex -3\n", "a.ply", "a.ply:3: the number of vertex elements is negative");
  expect_error(ascii_start + "element vertex x\n", "a.ply",
               "a.ply:3: the number of vertex elements expected, found \"x\"");
  expect_error(ascii_start + "element vertex 3\nproperty quad x\n", "a.ply",
               "a.ply:4: a property type expected, found \"quad\"");
  expect_error(ascii_start + "element vertex 3\nproperty float\n", "a.ply", "a.ply:4: a property without a name");
  expect_error(ascii_start + three_vertices + three_vertices, "a.ply", "a.ply:7: element vertex is declared twice");
  expect_error(ascii_start + three_vertices, "a.ply", "a.ply:7: the header has no end_header; the file is truncated");
}

TEST(PlyReader, RejectsMissingProperties) {
  expect_error(
      ascii_start + "element vertex 3\nproperty float x\nproperty float y\n" + one_face + end + "0 0\n1 0\n0 1\n",
      "a.ply", "a.ply:9: vertices need the properties x, y and z; the header lacks one");
  expect_error(ascii_start + three_vertices + "element face 1\nproperty list uchar int corners\n" + end +
                   "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
               "a.ply", "a.ply:12: elements \"face\" have no list vertex_indices");
}

TEST(PlyReader, RejectsWrongTextByLine) {
  const std::string header = ascii_start + three_vertices + one_face + end;
  expect_error(header + "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", "a.ply", "a.ply:11: a coordinate is not finite");
  expect_error(header + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.ply",
               "a.ply:11: the line ends where a vertex property should be");
  expect_error(header + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n", "a.ply",
               "a.ply:11: more numbers in a line than the header announces");
  expect_error(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.ply",
               "a.ply:13: vertex number 3, but the file has 3 vertices, counted from 0");
  expect_error(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.ply",
               "a.ply:13: vertex number -1, but the file has 3 vertices, counted from 0");
  expect_error(header + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "a.ply",
               "a.ply:13: a list vertex_indices of length -3; the file is truncated or invalid");
  expect_error(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "a.ply",
               "a.ply:14: the file goes on after what its header announces; its counts are wrong");
  expect_error(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1", "a.ply",
               "a.ply:13: the file ends where a vertex number should be; it may be truncated");
}

TEST(PlyReader, RejectsWrongBinaryDataByOffset) {
  const auto little = std::endian::little;
  const std::string header = "ply\nformat binary_little_endian 1.0\n" + three_vertices + one_face + end;
  const std::string points = all_bytes_of(little, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F);
  const std::string start = header + points + '\x03';
  const auto at = [](std::size_t offset) { return "a.ply: byte " + std::to_string(offset) + ": "; };
  expect_error(start + all_bytes_of(little, 0, 1, 7), "a.ply",
               at(start.size() + 8) + "vertex number 7, but the file has 3 vertices, counted from 0");
  expect_error(start + all_bytes_of(little, 0, 1), "a.ply",
               at(start.size() + 8) + "the file ends where a vertex number should be; it is truncated");
  expect_error(start + all_bytes_of(little, 0, 1, 2, 3), "a.ply",
               at(start.size() + 12) + "the file goes on after what its header announces; its counts are wrong");
  EXPECT_EQ(read(start + all_bytes_of(little, 0, 1, 2) + "\n", "a.ply").mesh.faces.size(), 1U);
  const float inf = std::numeric_limits<float>::infinity();
  expect_error(header + all_bytes_of(little, 0.F, 0.F, 0.F, 1.F, 0.F, inf, 0.F, 1.F, 0.F) + '\x03' +
                   all_bytes_of(little, 0, 1, 2),
               "a.ply", at(header.size() + 20) + "a coordinate is not finite");
  const std::string float_list = "ply\nformat binary_little_endian 1.0\n" + three_vertices +
                                 "element face 1\nproperty list uchar float vertex_indices\n" + end + points + '\x03';
  expect_error(float_list + all_bytes_of(little, 0.F, 1.5F, 2.F), "a.ply",
               at(float_list.size() + 4) + "a vertex number is not whole");
}

TEST(PlyReader, RejectsAbsurdCountsBeforeItAllocates) {
  const std::string vertices = "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n";
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const auto error =
        error_of(cat("ply\nformat ", format, " 1.0\n", vertices, one_face, end, "0 0 0\n1 0 0\n"), "a.ply");
    EXPECT_NE(std::string(error->what()).find("too short for 4000000000 elements \"vertex\""), std::string::npos)
        << error->what();
  }
  const std::string list = "ply\nformat binary_little_endian 1.0\n" + three_vertices +
                           "element face 1\nproperty list uint int vertex_indices\n" + end + std::string(36, '\0');
  const auto error = error_of(list + all_bytes_of(std::endian::little, 4000000000U, 0, 1, 2), "a.ply");
  EXPECT_NE(std::string(error->what()).find("a list vertex_indices of length 4000000000"), std::string::npos);
}

TEST(PlyReader, RejectsMoreElementsThanAMeshCanHave) {
  expect_error(ascii_start + "element vertex 5000000000\n", "a.ply",
               "a.ply:3: the number of vertex elements is 5000000000, more than the 4294967295 a mesh can have");
}

TEST(PlyReader, SkipsElementsWithoutPropertiesHoweverMany) {
  const ReadResult result = read(ascii_start + three_vertices + one_face + "element ghost 9000000000000000000\n" + end +
                                     "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                                 "a.ply");
  EXPECT_EQ(result.mesh.faces.size(), 1U);
}

TEST(PlyReader, LetsListsGoOverSeveralLines) {
  const ReadResult result =
      read(ascii_start + three_vertices + one_face + end + "0 0 0\n1 0 0\n0 1 0\n3 0\n1\n2\n", "a.ply");
  EXPECT_EQ(result.mesh.faces[0], (Triangle{0, 1, 2}));
}

}  // namespace
}  // namespace whittle::io
