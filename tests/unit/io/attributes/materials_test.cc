#include "whittle/io/materials.hh"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.hh"

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

}  // namespace
}  // namespace whittle::io
