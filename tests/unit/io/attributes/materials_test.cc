#include "whittle/io/materials.hh"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/temporary_folder.hh"
#include "whittle/io/output_file.hh"

namespace whittle::io {
namespace {

using Rgb = std::array<double, 3>;

TEST(Materials, HaveColourOpacityAndTexture) {
  const whittle::test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "lib");
  std::ofstream(folder / "lib/a.mtl") << "Kd 0 1 1\n# newmtl no\nnewmtl red wall\nKa 0 0 0\n Kd 1 0.25 0 \r\nd 0.5\n"
                                         "map_Kd -s 1 1 1 tex\\a b.png\nNEWMTL odd\nKd spectral file.rfl\nKd 0.5\n"
                                         "d -halo 0.5\n";
  std::ofstream(folder / "b.mtl") << "newmtl b\nKd 2 0 1\nnewmtl odd\nKd 0 0 0\n";
  FileNotes notes;
  notes.material_libraries = {"lib/a.mtl none.mtl", "b.mtl"};
  notes.header_lines = {"comment TextureFile all.png"};
  const SurfaceMaterials all = read_materials(notes, folder.path());
  ASSERT_EQ(all.materials.size(), 3U) << "the first of a name counts";
  EXPECT_EQ(all.materials[0].name, "red wall");
  EXPECT_EQ(all.materials[0].diffuse, (Rgb{1, 0.25, 0}));
  EXPECT_EQ(all.materials[0].opacity, 0.5);
  EXPECT_EQ(all.materials[0].texture, "lib/tex/a b.png");
  EXPECT_EQ(all.materials[1].diffuse, (Rgb{0.5, 0.5, 0.5}));
  EXPECT_EQ(all.materials[1].opacity, 1);
  EXPECT_EQ(all.materials[2].diffuse, (Rgb{1, 0, 1}));
  EXPECT_EQ(all.textures, std::vector<std::filesystem::path>{"all.png"});
  EXPECT_EQ(all.missing, std::vector<std::filesystem::path>{"none.mtl"});
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.stream() << text;
  file.commit();
}

TEST(ReadMaterials, FindsColoursAndTextures) {
  const whittle::test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "m");
  write_file(folder.path() / "m" / "a.mtl",
             "Kd 9 9 9\nnewmtl red one \r\nKd 1 0 0.5\nd 0.25\nTr 1\nmap_Kd -s 1 1 1 images\\a b.png\n"
             "newmtl grey\n kd 0.5\nnewmtl odd\nKd x\nd -1\nKd 7 0 0\nnewmtl grey\nKd 1 1 1\n");
  FileNotes notes;
  notes.material_libraries = {"m\\a.mtl none.mtl"};
  const SurfaceMaterials all = read_materials(notes, folder.path());
  ASSERT_EQ(all.materials.size(), 3U);
  EXPECT_EQ(all.materials[0].name, "red one");
  EXPECT_EQ(all.materials[0].diffuse, (std::array<double, 3>{1, 0, 0.5}));
  EXPECT_EQ(all.materials[0].opacity, 0.25);
  EXPECT_EQ(all.materials[0].texture, std::filesystem::path("m/images/a b.png"));
  EXPECT_EQ(all.materials[1].name, "grey");
  EXPECT_EQ(all.materials[1].diffuse, (std::array<double, 3>{0.5, 0.5, 0.5}));
  EXPECT_TRUE(all.materials[1].texture.empty());
  EXPECT_EQ(all.materials[2].diffuse, (std::array<double, 3>{1, 0, 0})) << "shares are at most 1";
  EXPECT_EQ(all.materials[2].opacity, 1);
  EXPECT_EQ(all.missing, std::vector<std::filesystem::path>{"none.mtl"});
}

TEST(ReadMaterials, FindsTheTexturesOfPly) {
  FileNotes notes;
  notes.header_lines = {"comment TextureFile a b.png", "comment made by hand", "comment TextureFile c.jpg"};
  const SurfaceMaterials all = read_materials(notes, {});
  EXPECT_EQ(all.textures, (std::vector<std::filesystem::path>{"a b.png", "c.jpg"}));
  EXPECT_TRUE(all.materials.empty());
}

}  // namespace
}  // namespace whittle::io
