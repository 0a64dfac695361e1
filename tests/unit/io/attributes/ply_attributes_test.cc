#include <gtest/gtest.h>

#include "attribute_tools.hh"
#include "whittle/core/wedges.hh"

namespace whittle::io {
namespace {

using test::all_bytes_of;
using test::cat;
using test::expect_error;
using test::expect_same_mesh;
using test::expect_same_notes;
using test::read;
using test::written;

const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_indices\n";

std::string header(const std::string& vertex, const std::string& face, const std::string& comments = {}) {
  return cat(ascii, comments, "element vertex 3\n", xyz, vertex, "element face 1\n", corners, face, "end_header\n");
}

const Attribute& attribute(const IndexedMesh& mesh, const std::string& name) {
  for (const auto* const all : {&mesh.attributes, &mesh.face_attributes}) {
    for (const Attribute& a : *all) {
      if (a.name == name) return a;
    }
  }
  throw std::runtime_error("no attribute " + name);
}

TEST(PlyAttributes, CarriesEveryScalarOfAVertexUnderItsNameAndType) {
  const std::string ply =
      header("property double quality\nproperty short label\nproperty uint intensity\nproperty char class\n", "") +
      "0 0 0 0.1 -7 4000000000 -3\n1 0 0 1e-300 8 1 0\n0 1 0 nan 9 2 5\n3 0 1 2\n";
  const ReadResult result = read(ply, "a.ply");
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_EQ(attribute(result.mesh, "quality").type, ScalarType::float64);
  EXPECT_EQ(attribute(result.mesh, "quality").kind, AttributeKind::scalar);
  EXPECT_EQ(attribute(result.mesh, "quality").values[1], 1e-300);
  EXPECT_TRUE(std::isnan(attribute(result.mesh, "quality").values[2]));
  EXPECT_EQ(attribute(result.mesh, "label").kind, AttributeKind::category);
  EXPECT_EQ(attribute(result.mesh, "label").type, ScalarType::int16);
  EXPECT_EQ(attribute(result.mesh, "label").values, (std::vector<double>{-7, 8, 9}));
  EXPECT_EQ(attribute(result.mesh, "intensity").kind, AttributeKind::scalar);
  EXPECT_EQ(attribute(result.mesh, "intensity").values[0], 4e9);
  EXPECT_EQ(attribute(result.mesh, "class").type, ScalarType::int8);
}

TEST(PlyAttributes, TakesPairsForTextureCoordinates) {
  for (const std::string pair : {"s,t", "u,v", "texture_u,texture_v", "texture_s,texture_t", "u1,v1"}) {
    const std::size_t comma = pair.find(',');
    const std::string u = pair.substr(0, comma);
    const std::string v = pair.substr(comma + 1);
    for (const bool is_turned : {false, true}) {
      const std::string properties =
          cat("property float ", is_turned ? v : u, "\nproperty int between\nproperty float ", is_turned ? u : v, "\n");
      const std::string ply = header(properties, "") + "0 0 0 .5 1 .25\n1 0 0 0 2 0\n0 1 0 0 3 0\n3 0 1 2\n";
      const ReadResult result = read(ply, "a.ply");
      const Attribute& texcoords = attribute(result.mesh, pair);
      EXPECT_EQ(texcoords.kind, AttributeKind::texcoord) << pair;
      EXPECT_EQ(texcoords.value(0)[is_turned ? 1 : 0], 0.5) << pair;
      EXPECT_EQ(texcoords.value(0)[is_turned ? 0 : 1], 0.25) << pair;
      const std::string again = written(result.mesh, Format::ply, {.ascii = true, .notes = result.notes});
      EXPECT_NE(again.find(properties), std::string::npos) << again;
    }
  }
  const ReadResult alone =
      read(header("property float u\nproperty int v\n", "") + "0 0 0 .5 1\n1 0 0 0 2\n0 1 0 0 3\n3 0 1 2\n", "a.ply");
  EXPECT_EQ(attribute(alone.mesh, "u").kind, AttributeKind::scalar);
}

TEST(PlyAttributes, CarriesEveryScalarOfAFace) {
  const std::string face = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty char kind\n";
  const std::string ply = header("", face) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 51 255 0 -4\n";
  const ReadResult result = read(ply, "a.ply");
  EXPECT_EQ(attribute(result.mesh, "red,green,blue").values, (std::vector<double>{0.2, 1, 0}));
  EXPECT_EQ(attribute(result.mesh, "red,green,blue").kind, AttributeKind::color);
  EXPECT_EQ(attribute(result.mesh, "kind").values, (std::vector<double>{-4}));
  const std::string again = written(result.mesh, Format::ply, {.ascii = true, .notes = result.notes});
  EXPECT_NE(again.find(face), std::string::npos) << again;
  EXPECT_TRUE(again.ends_with("3 0 1 2 51 255 0 -4\n")) << again;
}

TEST(PlyAttributes, GivesTheValuesOfAPolygonToItsTriangles) {
  const std::string ply = cat(ascii, "element vertex 5\n", xyz, "element face 3\nproperty float hue\n", corners,
                              "property list uchar float texcoord\nend_header\n",
                              "0 0 0\n2 0 0\n2 2 0\n1 .5 0\n0 2 0\n0.5 5 0 1 2 3 4 10 0 0 2 0 2 2 1 .5 0 2\n",
                              "0.25 2 0 1 4 9 9 9 9\n0.75 3 0 4 3 0\n");
  const ReadResult result = read(ply, "a.ply");
  EXPECT_EQ(result.repairs.triangulated_polygons, 1U);
  ASSERT_EQ(result.mesh.faces.size(), 4U);
  EXPECT_EQ(result.mesh.face_attributes[0].values, (std::vector<double>{0.5, 0.5, 0.5, 0.75}));
  const Attribute& texcoords = attribute(result.mesh, "texcoord");
  for (std::size_t f = 0; f < 3; ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = result.mesh.positions[result.mesh.faces[f][c]];
      EXPECT_EQ(texcoords.value(result.mesh.wedge(f, c))[0], p.x()) << f;
      EXPECT_EQ(texcoords.value(result.mesh.wedge(f, c))[1], p.y()) << f;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(texcoords.value(result.mesh.wedge(3, c))[0], 0) << "it has none";
}

TEST(PlyAttributes, MakesWedgesOfTextureCoordinatesAtFaces) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const std::string start =
      cat(ascii, "element vertex 4\n", xyz, "element face 2\nproperty list uchar float texcoord\n", corners,
          "end_header\n", vertices);
  const ReadResult equal = read(start + "6 0 0 1 0 0 1 3 0 1 2\n6 0 1 1 0 1 1 3 2 1 3\n", "a.ply");
  EXPECT_TRUE(equal.mesh.wedges.empty());
  EXPECT_EQ(attribute(equal.mesh, "texcoord").values, (std::vector<double>{0, 0, 1, 0, 0, 1, 1, 1}));
  const ReadResult seam = read(start + "6 0 0 1 0 0 1 3 0 1 2\n6 .5 1 1 0 1 1 3 2 1 3\n", "a.ply");
  EXPECT_EQ(n_wedges(seam.mesh), 5U);
  const std::string again = written(seam.mesh, Format::ply, {.ascii = true, .notes = seam.notes});
  EXPECT_NE(again.find("element vertex 4\n"), std::string::npos) << "the list is written again, no vertex is split";
  EXPECT_TRUE(again.ends_with("6 0.5 1 1 0 1 1 3 2 1 3\n")) << again;
}

TEST(PlyAttributes, ReadsTheSameFromBinaryAndText) {
  IndexedMesh mesh = test::tube_with_seam(7, 3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.colors.push_back({static_cast<float>(v % 256) / 255, 0, 1, 1});
  mesh.attributes.push_back(
      {.name = "label", .kind = AttributeKind::category, .values = {}, .type = ScalarType::uint16});
  mesh.attributes.back().values.resize(mesh.positions.size(), 700);
  mesh.face_attributes.push_back(
      {.name = "part", .kind = AttributeKind::category, .values = {}, .type = ScalarType::int8});
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.face_attributes[0].values.push_back(-double(f % 100));
  const ReadResult binary = read(written(mesh, Format::ply), "a.ply");
  const ReadResult text = read(written(mesh, Format::ply, {.ascii = true}), "a.ply");
  expect_same_mesh(binary.mesh, text.mesh, "binary and text");
  expect_same_notes(binary.notes, text.notes, "binary and text");
  EXPECT_FALSE(binary.mesh.wedges.empty());
}

TEST(PlyAttributes, WritesIntegersRoundedAndClamped) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}};
  mesh.attributes.push_back({.name = "a", .values = {2.5, -9e9, std::nan("")}, .type = ScalarType::int16});
  mesh.colors = {{0.5F, 2, -1, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}};
  mesh.attributes.push_back({.name = "c c", .values = {4294967295.0, -1, 0.4}, .type = ScalarType::uint32});
  const std::string ply = written(mesh, Format::ply, {.ascii = true});
  EXPECT_NE(ply.find("property uint c_c\n"), std::string::npos);
  EXPECT_NE(ply.find("0 0 0 128 255 0 3 4294967295\n1 0 0 0 0 0 -32768 0\n0 1 0 255 255 255 0 0\n"), std::string::npos)
      << ply;
}

// A reader takes integers for plain numbers: what they stand for in glTF would be lost.
TEST(PlyAttributes, WritesRealsForIntegersThatStandForThem) {
  IndexedMesh mesh = read(header("", "") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply").mesh;
  const auto add = [&mesh](const std::string& name, AttributeKind kind, std::vector<double> values, ScalarType type,
                           bool is_normalized) {
    const std::size_t n = values.size() / 3;
    mesh.attributes.push_back({name, kind, n, std::move(values), type, is_normalized});
  };
  add("TEXCOORD_0", AttributeKind::texcoord, {0, 1, 0.25, 0.5, 0.75, 1}, ScalarType::uint16, true);
  add("TEXCOORD_1", AttributeKind::texcoord, {0, 255, 64, 128, 200.5, 1}, ScalarType::uint8, false);
  add("TANGENT", AttributeKind::tangent, {0, 0, 1, 1, 0, 0, 1, -1, 0.5, 0, 0.5, 1}, ScalarType::int8, true);
  add("COLOR_1", AttributeKind::color, {0, 0.5, 1, 1, 1, 1, 0, 0, 0}, ScalarType::uint8, true);
  add("_WET", AttributeKind::scalar, {0, 0.5, 1}, ScalarType::uint16, true);
  add("JOINTS_WEIGHTS", AttributeKind::joint_weights, {7, 0.25, 8, 0.5, 9, 1}, ScalarType::uint8, false);
  add("target 0 POSITION", AttributeKind::displacement, {0.5, 0, 0, 0, -1.5, 0, 0, 0, 300}, ScalarType::int8, false);
  add("_PART", AttributeKind::category, {1, 2, 3}, ScalarType::uint8, false);
  const ReadResult back = read(written(mesh, Format::ply), "a.ply");
  EXPECT_EQ(attribute(back.mesh, "s,t").values, mesh.attributes[0].values);
  EXPECT_EQ(attribute(back.mesh, "s,t").kind, AttributeKind::texcoord);
  EXPECT_EQ(attribute(back.mesh, "s1,t1").values, mesh.attributes[1].values);
  EXPECT_EQ(attribute(back.mesh, "TANGENT_3").values, (std::vector<double>{1, -1, 1}));
  EXPECT_EQ(attribute(back.mesh, "TANGENT_2").values, (std::vector<double>{1, 1, 0.5}));
  EXPECT_EQ(attribute(back.mesh, "COLOR_1_1").values, (std::vector<double>{0.5, 1, 0}));
  EXPECT_EQ(attribute(back.mesh, "_WET").values, mesh.attributes[4].values);
  EXPECT_EQ(attribute(back.mesh, "JOINTS_WEIGHTS_1").values, (std::vector<double>{0.25, 0.5, 1}));
  EXPECT_EQ(attribute(back.mesh, "target_0_POSITION_2").values, (std::vector<double>{0, 0, 300}));
  EXPECT_EQ(attribute(back.mesh, "_PART").type, ScalarType::uint8);
}

TEST(PlyAttributes, NamesNumbersThatHaveNoNamesOfTheirOwn) {
  IndexedMesh mesh = read(header("", "") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply").mesh;
  const std::vector<double> six{0, 1, 2, 3, 4, 5};
  mesh.attributes.push_back({.name = "TEXCOORD_0", .kind = AttributeKind::texcoord, .n_components = 2, .values = six});
  mesh.attributes.push_back({.name = "TEXCOORD_1", .kind = AttributeKind::texcoord, .n_components = 2, .values = six});
  mesh.attributes.push_back({.name = "WIND", .n_components = 2, .values = six});
  const ReadResult back = read(written(mesh, Format::ply), "a.ply");
  EXPECT_EQ(attribute(back.mesh, "s,t").values, six);
  EXPECT_EQ(attribute(back.mesh, "s1,t1").values, six);
  EXPECT_EQ(attribute(back.mesh, "WIND_1").values, (std::vector<double>{1, 3, 5}));
}

TEST(PlyAttributes, KeepsGroupsAndNamesThroughComments) {
  IndexedMesh mesh = test::cube_with_charts();
  mesh.group_names = {"red paint", "", "b\nc"};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.face_groups.push_back(static_cast<Index>(f % 3));
  FileNotes notes;
  notes.material_libraries = {"a b.mtl c.mtl"};
  notes.face_names["o"] = {"cube"};
  const ReadResult back = read(written(mesh, Format::ply, {.notes = notes}), "a.ply");
  EXPECT_EQ(back.mesh.face_groups, mesh.face_groups);
  EXPECT_EQ(back.mesh.group_names, (std::vector<std::string>{"red paint", "", "b c"}));
  EXPECT_EQ(back.notes.material_libraries, notes.material_libraries);
  EXPECT_EQ(back.notes.face_names, notes.face_names);
}

TEST(PlyAttributes, LeavesAGroupPropertyWithoutNamesAnAttribute) {
  const std::string data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1\n";
  for (const std::string comments :
       {"", "comment name group 0 a\n", "comment name group 1 a\ncomment name group x b\n"}) {
    const ReadResult result = read(header("", "property int group\n", comments) + data, "a.ply");
    EXPECT_TRUE(result.mesh.face_groups.empty()) << comments;
    EXPECT_EQ(attribute(result.mesh, "group").values, (std::vector<double>{1})) << comments;
  }
}

TEST(PlyAttributes, KeepsLinesThatNameTexturesAndNoOthers) {
  const std::string lines = "comment TextureFile   my  file.jpg\nobj_info atlas colour.PNG\ncomment made by hand\n";
  const ReadResult result = read(header("", "", lines) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply");
  EXPECT_EQ(result.notes.header_lines,
            (std::vector<std::string>{"comment TextureFile   my  file.jpg", "obj_info atlas colour.PNG"}));
  const ReadResult back = read(written(result.mesh, Format::ply, {.notes = result.notes}), "a.ply");
  expect_same_notes(back.notes, result.notes, "written and read again");
}

TEST(PlyAttributes, KeepsTheTypeOfColors) {
  for (const std::string type : {"float", "ushort", "uchar"}) {
    const std::string colors = cat("property ", type, " red\nproperty ", type, " green\nproperty ", type, " blue\n");
    const std::string values = type == "float" ? " 0.123 1 0\n" : " 12 255 0\n";
    const std::string vertices = "0 0 0" + values + "1 0 0" + values + "0 1 0" + values;
    const ReadResult result = read(header(colors, "") + vertices + "3 0 1 2\n", "a.ply");
    const std::string again = written(result.mesh, Format::ply, {.ascii = true, .notes = result.notes});
    EXPECT_NE(again.find(colors), std::string::npos) << again;
    EXPECT_NE(again.find(vertices), std::string::npos) << again;
  }
}

TEST(PlyAttributes, RefusesListsOfTheWrongLength) {
  const std::string start = header("", "property list uchar float texcoord\n") + "0 0 0\n1 0 0\n0 1 0\n";
  expect_error(start + "3 0 1 2 5 0 0 1 0 0\n", "a.ply",
               "a.ply:14: a list texcoord of length 5 for a face of 3 corners; it needs two numbers a corner");
  expect_error(start + "3 0 1 2 6 0 0 1 0 0", "a.ply",
               "a.ply:14: the file ends where a texture coordinate should be; it may be truncated");
  EXPECT_EQ(read(start + "3 0 1 2 0\n", "a.ply").mesh.attributes.size(), 0U) << "no face has texture coordinates";
  const auto little = std::endian::little;
  const std::string binary =
      cat("ply\nformat binary_little_endian 1.0\nelement vertex 3\n", xyz, "element face 1\n", corners,
          "property list uchar float texcoord\nend_header\n",
          all_bytes_of(little, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F), '\x03', all_bytes_of(little, 0, 1, 2));
  const auto at = [](std::size_t offset) { return "a.ply: byte " + std::to_string(offset) + ": "; };
  expect_error(
      binary + '\x04' + all_bytes_of(little, 0.F, 0.F, 1.F, 0.F), "a.ply",
      at(binary.size() - 13) + "a list texcoord of length 4 for a face of 3 corners; it needs two numbers a corner");
  expect_error(binary + '\x06' + all_bytes_of(little, 0.F, 0.F, 1.F, 0.F), "a.ply",
               at(binary.size() + 17) + "the file ends where a texture coordinate should be; it is truncated");
}

TEST(PlyAttributes, ReplacesTextureCoordinatesThatAreNotFinite) {
  const ReadResult result = read(
      header("property float s\nproperty float t\n", "") + "0 0 0 nan 1\n1 0 0 0 inf\n0 1 0 0 3\n3 0 1 2\n", "a.ply");
  EXPECT_EQ(attribute(result.mesh, "s,t").values, (std::vector<double>{0, 1, 0, 0, 0, 3}));
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"texture coordinates that are not finite became 0"}));
}

TEST(PlyAttributes, GivesFacesOfStripsZeros) {
  const std::string ply = cat(
      ascii, "element vertex 4\n", xyz, "element tristrips 1\nproperty list int int vertex_indices\nelement face 1\n",
      corners, "property uchar part\nelement end 0\nend_header\n", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3 7\n");
  EXPECT_EQ(attribute(read(ply, "a.ply").mesh, "part").values, (std::vector<double>{0, 7}));
}

}  // namespace
}  // namespace whittle::io
