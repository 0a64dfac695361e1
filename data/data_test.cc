#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>
#include <whittle/io/read.hh>
#include <whittle/metrics/self_intersections.hh>

#include "support/meshes.hh"
#include "support/topology.hh"

namespace whittle::test {
namespace {

io::ReadResult read(const std::string& name) { return io::read_mesh(data_mesh(name)); }

/// A row "| `name` | faces | … |" of the README.
struct Row {
  std::string name;
  std::size_t faces;
};
std::vector<Row> table() {
  std::ifstream readme(std::filesystem::path(WHITTLE_DATA_DIR) / "README.md");
  const std::regex pattern(R"(\| *`([^`]+)` *\| *([0-9,]+) *\|.*)");
  std::vector<Row> rows;
  std::smatch match;
  for (std::string line; std::getline(readme, line);) {
    if (!std::regex_match(line, match, pattern)) continue;
    rows.push_back({match[1], std::stoul(std::regex_replace(match[2].str(), std::regex(","), ""))});
  }
  return rows;
}

TEST(Data, HasTheFilesAndFacesOfItsTable) {
  std::vector<std::string> listed;
  for (const Row& row : table()) {
    listed.push_back(row.name);
    EXPECT_EQ(read(row.name).file_faces, row.faces) << row.name;
  }
  std::vector<std::string> present;
  for (const auto& file : std::filesystem::directory_iterator(WHITTLE_DATA_DIR)) {
    const std::string ending = file.path().extension().string();
    if (ending == ".obj" || ending == ".off" || ending == ".ply" || ending == ".stl")
      present.push_back(file.path().filename().string());
  }
  EXPECT_FALSE(present.empty());
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(present));
}

TEST(Data, ShowsWhatItsTableSays) {
  struct Case {
    const char* name;
    bool closed, manifold;
    int components, border_loops;
    std::optional<int> genus;
  };
  for (const Case& c : {Case{"knot.ply", true, true, 1, 0, 1}, Case{"blob.obj", true, true, 1, 0, 0},
                        Case{"terrain.ply", false, true, 1, 1, {}}, Case{"cylinder.off", false, true, 1, 2, {}},
                        Case{"bracket.stl", true, true, 1, 0, 1}, Case{"cubes.obj", true, true, 25, 0, 0},
                        Case{"flat.off", false, true, 1, 1, {}}, Case{"nonmanifold.obj", false, false, 3, 1, {}}}) {
    const Topology t = topology(read(c.name).mesh);
    EXPECT_EQ(t.closed(), c.closed) << c.name << ' ' << t;
    EXPECT_EQ(t.manifold(), c.manifold) << c.name << ' ' << t;
    EXPECT_EQ(t.components, c.components) << c.name << ' ' << t;
    EXPECT_EQ(t.border_loops, c.border_loops) << c.name << ' ' << t;
    EXPECT_EQ(t.misoriented_edges, 0) << c.name << ' ' << t;
    if (c.genus) {
      EXPECT_EQ(t.genus(), *c.genus) << c.name << " " << t;
    }
  }
}

TEST(Data, NeedsNoRepairButTheWeldingOfStl) {
  for (const Row& row : table()) {
    const io::Repairs repairs = read(row.name).repairs;
    const bool is_stl = row.name.ends_with(".stl");
    EXPECT_EQ(repairs.welded_vertices > 0, is_stl) << row.name;
    EXPECT_EQ(repairs.degenerate_faces + repairs.duplicate_faces + repairs.isolated_vertices, 0u) << row.name;
  }
}

TEST(Data, DoesNotIntersectItself) {
  for (const char* name : {"knot.ply", "blob.obj", "terrain.ply", "cylinder.off", "bracket.stl", "cubes.obj"})
    EXPECT_TRUE(metrics::self_intersections(read(name).mesh).empty()) << name;
}

TEST(Data, HasColoursOnTheTerrain) {
  const IndexedMesh mesh = read("terrain.ply").mesh;
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
}

}  // namespace
}  // namespace whittle::test
