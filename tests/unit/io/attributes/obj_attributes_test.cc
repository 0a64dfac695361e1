#include <gtest/gtest.h>

#include "attribute_tools.hh"
#include "whittle/core/wedges.hh"

namespace whittle::io {
namespace {

using test::cat;
using test::expect_error;
using test::expect_same_mesh;
using test::expect_same_notes;
using test::read;
using test::read_per_vertex;
using test::written;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string texcoords = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

std::string written_again(const ReadResult& result) {
  return written(result.mesh, Format::obj, {.notes = result.notes});
}

TEST(ObjAttributes, GivesVerticesTheirTextureCoordinates) {
  const ReadResult result = read(square + texcoords + "f 1/1 2/2 3/3\nf 1/1 3/3 4/-1\n", "a.obj");
  EXPECT_TRUE(result.mesh.wedges.empty());
  ASSERT_EQ(result.mesh.attributes.size(), 1U);
  EXPECT_EQ(result.mesh.attributes[0].name, "vt");
  EXPECT_EQ(result.mesh.attributes[0].kind, AttributeKind::texcoord);
  EXPECT_EQ(result.mesh.attributes[0].values, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ObjAttributes, MakesAWedgeForEachValueNotForEachNumber) {
  const std::string twice = texcoords + "vt 0.0 0.0\nvt 0.5 0\n";
  EXPECT_TRUE(read(square + twice + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", "a.obj").mesh.wedges.empty());
  const ReadResult seam = read(square + twice + "f 1/1 2/2 3/3\nf 1/6 3/3 4/4\n", "a.obj");
  EXPECT_EQ(n_wedges(seam.mesh), 5U);
  EXPECT_EQ(seam_edges(seam.mesh).size(), 1U);
}

TEST(ObjAttributes, KeepsCreases) {
  const std::string obj = square + "vn 0 0 2\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n";
  const ReadResult result = read(obj, "a.obj");
  EXPECT_EQ(n_wedges(result.mesh), 6U);
  EXPECT_EQ(result.mesh.normals[result.mesh.wedge(0, 0)], (std::array<float, 3>{0, 0, 1}));
  EXPECT_EQ(result.mesh.normals[result.mesh.wedge(1, 0)], (std::array<float, 3>{0, 1, 0}));
  EXPECT_TRUE(result.warnings.empty());
  const IndexedMesh per_vertex = read_per_vertex(obj, "a.obj").mesh;
  EXPECT_TRUE(per_vertex.wedges.empty());
  EXPECT_EQ(per_vertex.normals.size(), 4U);
}

TEST(ObjAttributes, WedgesFollowTheCornersOfPolygons) {
  // Concave, with texture coordinates that tell the corners; a corner that is repeated; a hole in the list of numbers.
  const std::string obj =
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nvt 0 0\nvt 4 0\nvt 4 4\nvt 2 1\nvt 0 4\n"
      "f 1/1 2/2 2/2 3/3 4/4 5/5 1/1\nf 5 4 3\n";
  const ReadResult result = read(obj, "a.obj");
  ASSERT_EQ(result.mesh.faces.size(), 4U);
  for (std::size_t f = 0; f < 3; ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = result.mesh.positions[result.mesh.faces[f][c]];
      const auto value = result.mesh.attributes[0].value(result.mesh.wedge(f, c));
      EXPECT_EQ(Vec3(value[0], value[1], 0), p) << f;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(result.mesh.attributes[0].value(result.mesh.wedge(3, c))[0], 0);
}

TEST(ObjAttributes, TakesFacesWithAndWithoutNumbers) {
  const std::string obj = square + texcoords + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1//1 3//1 4//1\nf 4 3 2\nf 2 1/4 4\n";
  const ReadResult result = read(obj, "a.obj");
  EXPECT_EQ(result.mesh.normals[result.mesh.wedge(2, 0)], (std::array<float, 3>{0, 0, 0}));
  EXPECT_EQ(result.mesh.attributes[0].value(result.mesh.wedge(3, 1))[1], 1);
  const ReadResult back = read(written_again(result), "a.obj");
  expect_same_mesh(back.mesh, result.mesh, obj);
}

TEST(ObjAttributes, HasThreeTextureCoordinatesWhereTheThirdIsUsed) {
  EXPECT_EQ(read(square + "vt 1 2 0\nvt 3\nf 1/1 2/2 3/1\n", "a.obj").mesh.attributes[0].values,
            (std::vector<double>{1, 2, 3, 0, 1, 2}));
  EXPECT_EQ(read(square + "vt 1 2 0\nvt 3 0 4\nf 1/1 2/2 3/1\n", "a.obj").mesh.attributes[0].values,
            (std::vector<double>{1, 2, 0, 3, 0, 4, 1, 2, 0}));
}

TEST(ObjAttributes, MaterialsAreGroups) {
  const std::string obj = square +
                          "mtllib a.mtl b c.mtl\nf 1 2 3\nusemtl old wood\nusemtl steel #2\nf 1 3 4\nusemtl red\n" +
                          "f 4 3 1\nusemtl steel #2\nf 3 2 1\nusemtl unused\n";
  const ReadResult result = read(obj, "a.obj");
  EXPECT_EQ(result.mesh.group_names, (std::vector<std::string>{"", "steel #2", "red"}));
  EXPECT_EQ(result.mesh.face_groups, (std::vector<Index>{0, 1, 2, 1}));
  EXPECT_EQ(result.notes.material_libraries, (std::vector<std::string>{"a.mtl b c.mtl"}));
  EXPECT_EQ(written_again(result),
            "mtllib a.mtl b c.mtl\n" + square +
                "f 1 2 3\nusemtl steel #2\nf 1 3 4\nusemtl red\nf 4 3 1\nusemtl steel #2\nf 3 2 1\n");
  EXPECT_TRUE(read(square + "f 1 2 3\n", "a.obj").mesh.face_groups.empty());
}

TEST(ObjAttributes, KeepsObjectsGroupsAndSmoothing) {
  const std::string obj =
      "o table\n" + square + "g top  plate\ns 1\nf 1 2 3\ng\nf 1 3 4\ns off\nf 4 3 1\no chair\ns 2\nf 3 2 1\n";
  const ReadResult result = read(obj, "a.obj");
  const std::string expected =
      square + "o table\ng top  plate\ns 1\nf 1 2 3\ng default\nf 1 3 4\ns off\nf 4 3 1\no chair\ns 2\nf 3 2 1\n";
  EXPECT_EQ(written_again(result), expected);
  EXPECT_EQ(result.notes.face_names.at("o"), (std::vector<std::string>{"table", "chair"}));
  ASSERT_EQ(result.mesh.face_attributes.size(), 3U);
  EXPECT_EQ(result.mesh.face_attributes[2].values, (std::vector<double>{1, 1, 0, 2}));
  expect_same_mesh(read(expected, "a.obj").mesh, result.mesh, obj);
}

TEST(ObjAttributes, CostsNothingPerFaceWhereAllFacesAreOfOneObject) {
  const ReadResult result = read("o table\ng top\ns 3\n" + square + "f 1 2 3\nf 1 3 4\n", "a.obj");
  EXPECT_TRUE(result.mesh.face_attributes.empty());
  EXPECT_EQ(written_again(result), square + "o table\ng top\ns 3\nf 1 2 3\nf 1 3 4\n");
  EXPECT_TRUE(read("s off\n" + square + "f 1 2 3\n", "a.obj").notes.face_names.empty());
}

TEST(ObjAttributes, WritesEachValueOnce) {
  const ReadResult result = read(written(test::cube_with_charts(), Format::ply), "a.ply");
  const std::string obj = written(result.mesh, Format::obj);
  const auto count = [&](const std::string& start) {
    std::size_t n = 0;
    for (std::size_t at = obj.find(start); at != obj.npos; at = obj.find(start, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("\nv ") + 1, 8U) << "the first line begins the file";
  EXPECT_EQ(count("\nvt "), 24U);
  EXPECT_EQ(count("\nvn "), 6U);
  const ReadResult back = read(obj, "a.obj");
  EXPECT_EQ(back.mesh.positions, result.mesh.positions);
  EXPECT_EQ(back.mesh.faces, result.mesh.faces);
  EXPECT_EQ(n_wedges(back.mesh), 24U);
}

TEST(ObjAttributes, SplitsVerticesWithSeveralColors) {
  IndexedMesh mesh = test::cube_with_charts();
  mesh.attributes.clear();
  mesh.normals.clear();
  for (std::size_t v = 0; v < 24; ++v) mesh.colors.push_back({v < 4 ? 1.F : 0.F, 0.25F, 0, 1});
  const ReadResult result = read(written(mesh, Format::ply, {.exact_colors = true}), "a.ply");
  EXPECT_EQ(n_wedges(result.mesh), 12U);
  const ReadResult back = read(written(result.mesh, Format::obj), "a.obj");
  EXPECT_EQ(back.file_vertices, 12U);
  expect_same_mesh(back.mesh, result.mesh, "coloured cube");
}

TEST(ObjAttributes, RefusesNumbersOfTextureCoordinatesThatAreNotThere) {
  const std::string start = square + texcoords;
  expect_error(start + "f 1/1 2/2 3/5\n", "a.obj",
               "a.obj:9: texture coordinate number 5, but the file has 4; it may be truncated");
  expect_error(start + "f 1/1 2/2 3/0\n", "a.obj", "a.obj:9: texture coordinate number 0; OBJ counts from 1");
  expect_error(start + "f 1/1 2/2 3/-5\n", "a.obj", "a.obj:9: texture coordinate number -5, but the file has 4");
  expect_error(start + "f 1/1 2/2 3/x\n", "a.obj", "a.obj:9: a texture coordinate number expected, found \"x\"");
  expect_error(start + "vt\nf 1 2 3\n", "a.obj", "a.obj:9: the line ends where a texture coordinate should be");
  EXPECT_EQ(read_per_vertex(start + "f 1/1 2/2 3/5\n", "a.obj").mesh.faces.size(), 1U);
}

TEST(ObjAttributes, IgnoresNumbersOfTextureCoordinatesThatWereTakenOut) {
  for (const std::string number : {"1", "0", "-1"}) {
    const ReadResult result =
        read(cat(square, "vn 0 0 1\nf 1/", number, "/1 2/", number, "/1 3/", number, "/1\n"), "a.obj");
    EXPECT_TRUE(result.mesh.attributes.empty());
    EXPECT_EQ(result.mesh.normals.size(), 3U);
    EXPECT_EQ(result.warnings,
              (std::vector<std::string>{
                  "texture coordinates are ignored: faces use numbers of some, but the file has none"}));
  }
}

TEST(ObjAttributes, TakesManyWedgesAtOneVertex) {
  std::string obj = "v 0 0 0\n";
  const int n = 3000;
  for (int i = 0; i < n; ++i)
    obj += cat("v 1 ", std::to_string(i), " 0\nvt 0.", std::to_string(1000 + i % 1500), " 0\n");
  for (int i = 1; i < n; ++i) {
    const std::string number = std::to_string(i);
    obj += cat("f 1/", number, " ", std::to_string(i + 1), "/1 ", std::to_string(i + 2 > n ? 2 : i + 2), "/1\n");
  }
  const ReadResult result = read(obj, "a.obj");
  std::set<Index> at_first;
  for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) at_first.insert(result.mesh.wedge(f, 0));
  EXPECT_EQ(at_first.size(), 1500U);
}

}  // namespace
}  // namespace whittle::io
