// Regions of faces: groups and objects of OBJ, properties and colours of PLY.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int n_cells = 20;

/// A square of cells of two faces. \param begin_cell column and row → what comes before both faces
template <class BeginCell>
std::string square_as_obj(const BeginCell& begin_cell) {
  std::string text;
  for (int y = 0; y <= n_cells; ++y) {
    for (int x = 0; x <= n_cells; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  }
  for (int y = 0; y < n_cells; ++y) {
    for (int x = 0; x < n_cells; ++x) {
      text += begin_cell(x, y);
      const auto number = [](int i, int j) { return " " + std::to_string(j * (n_cells + 1) + i + 1); };
      text += "f" + number(x, y) + number(x + 1, y) + number(x + 1, y + 1) + "\n";
      text += "f" + number(x, y) + number(x + 1, y + 1) + number(x, y + 1) + "\n";
    }
  }
  return text;
}

/// Left, right, and a cell in the middle.
std::string name_of(int x, int y) {
  if (x == n_cells / 2 && y == n_cells / 2) return "dot";
  return 2 * x < n_cells ? "left" : "right";
}

class RegionsOfFaces : public testing::Test {
 protected:
  Outcome simplify(const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simplify", in_, "-o", folder_ / out, "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return whittle(arguments);
  }
  /// Whether the middle of each face lies in the half of the square that its name says, to half a cell.
  static bool keeps_halves(const io::ReadResult& read) {
    const IndexedMesh& mesh = read.mesh;
    const Attribute& attribute = mesh.face_attributes.at(0);
    const std::vector<std::string>& names = read.notes.face_names.at(attribute.name);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      double middle = -n_cells / 2.0;
      for (const Index v : mesh.faces[f]) middle += mesh.positions[v].x() / 3;
      const std::string& name = names.at(static_cast<std::size_t>(attribute.value(f)[0]));
      if ((name == "left" && middle > 0.5) || (name == "right" && middle < -0.5)) return false;
    }
    return true;
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.obj";
};

TEST_F(RegionsOfFaces, OfObjStayAndAreMissedByName) {
  for (const std::string tag : {"g", "o", "usemtl"}) {
    write_text(in_, square_as_obj([&](int x, int y) { return tag + " " + name_of(x, y) + "\n"; }));
    const Outcome kept = simplify("out.obj", {"--faces", "24"});
    ASSERT_EQ(kept.exit_code, 0) << kept;
    const auto report = parse_json(kept.out);
    EXPECT_THAT(report["output"]["vanished_regions"], IsEmpty()) << tag;
    EXPECT_EQ(report["output"]["vanished_charts"], 0);
    EXPECT_TRUE(tag == "usemtl" || keeps_halves(io::read_mesh(folder_ / "out.obj"))) << tag;
    const Outcome least = simplify("out.obj", {"--faces", "2"});
    const std::string what = tag == "usemtl" ? "material" : tag;
    EXPECT_THAT(least.err, HasSubstr("warning: " + in_ + ": nothing is left of " + what + " ")) << tag;
    EXPECT_THAT(parse_json(least.out)["output"]["vanished_regions"], Not(IsEmpty())) << tag;
  }
}

TEST_F(RegionsOfFaces, AreNamedWhereTheirLastFacesAreRefused) {
  const auto of_four_cells = [](int x, int y) {
    return "g part" + std::to_string(x / 2) + "_" + std::to_string(y / 2) + "\n";
  };
  write_text(in_, square_as_obj(of_four_cells));
  const Outcome few = simplify("out.obj", {"--faces", "40", "--verbose"});
  const std::uint64_t n_refused = parse_json(few.out)["rejections"]["area"];
  EXPECT_GT(n_refused, 0U);
  EXPECT_THAT(few.err, HasSubstr(std::to_string(n_refused) + " by the last face of a chart or region"));
}

TEST_F(RegionsOfFaces, AreChosenByName) {
  write_text(in_, square_as_obj([&](int x, int y) {
               return "o " + std::string(2 * y < n_cells ? "low" : "high") + "\ng " + name_of(x, y) + "\n";
             }));
  EXPECT_EQ(parse_json(simplify("out.obj", {"--faces", "30"}).out)["options"]["regions"], "auto");
  const auto none = parse_json(simplify("out.obj", {"--faces", "2", "--regions", "none"}).out);
  EXPECT_THAT(none["output"]["vanished_regions"], IsEmpty()) << "they name nothing";
  EXPECT_EQ(none["rejections"]["area"], 0);
  const auto by_object = parse_json(simplify("out.obj", {"--faces", "4", "--regions", "o"}).out);
  EXPECT_EQ(by_object["options"]["regions"], "o");
  EXPECT_EQ(by_object["output"]["faces"], 4);
  EXPECT_THAT(by_object["output"]["vanished_regions"], IsEmpty());
  expect_failure(whittle({"simplify", in_, "-o", folder_ / "out.obj", "--faces", "4", "--regions", "part"}), 4,
                 {"faces have no property 'part' for --regions; they have o, g"});
  EXPECT_THAT(simplify("out.obj", {"--faces", "4", "--regions", "o,"}).err, HasSubstr("a name is empty"));
}

/// The square as PLY. \param properties of faces \param values column and row → theirs
template <class Values>
std::string square_as_ply(const std::string& properties, const Values& values) {
  const int n = n_cells;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string((n + 1) * (n + 1)) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(2 * n * n) + "\nproperty list uchar int vertex_indices\n" + properties +
                     "end_header\n";
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) text += std::to_string(x) + " " + std::to_string(y) + " 0\n";
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      const auto face = [&](int u, int v, int w) {
        return "3 " + std::to_string(u) + " " + std::to_string(v) + " " + std::to_string(w) + " " + values(x, y) + "\n";
      };
      text += face(a, a + 1, a + n + 2) + face(a, a + n + 2, a + n + 1);
    }
  }
  return text;
}

TEST_F(RegionsOfFaces, OfPlyStayAndAreMissedByName) {
  in_ = folder_ / "in.ply";
  const auto half = [](int x) { return std::string(2 * x < n_cells ? "0" : "1"); };
  const std::vector<std::pair<std::string, std::string>> all{
      {"property int label\n", ""},
      {"property float scalar_Label\n", ""},
      {"property uchar red\nproperty uchar green\nproperty uchar blue\n", " 0 77"}};
  for (const auto& [properties, more] : all) {
    write_text(in_, square_as_ply(properties, [&, rest = more](int x, int y) {
                 return (name_of(x, y) == "dot" ? "7" : half(x)) + rest;
               }));
    const Outcome kept = simplify("out.ply", {"--faces", "24"});
    ASSERT_EQ(kept.exit_code, 0) << kept;
    EXPECT_THAT(parse_json(kept.out)["output"]["vanished_regions"], IsEmpty()) << properties;
    const IndexedMesh mesh = io::read_mesh(folder_ / "out.ply").mesh;
    std::set<double> values;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) values.insert(mesh.face_attributes.at(0).value(f)[0]);
    EXPECT_EQ(values.size(), 3U) << properties;
    const Outcome least = simplify("out.ply", {"--faces", "2"});
    EXPECT_THAT(least.err, HasSubstr("nothing is left of ")) << properties;
  }
  write_text(in_, square_as_ply("property int number\n", [](int x, int y) { return std::to_string(99 * x + y); }));
  EXPECT_THAT(simplify("out.ply", {"--faces", "2", "--regions", "none"}).err, Not(HasSubstr("nothing is left")));
}

}  // namespace
}  // namespace whittle::test
