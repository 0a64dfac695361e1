#include <gtest/gtest.h>

#include <fstream>

#include "notes/mtl_materials.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/file_notes.hh"

namespace whittle::io {
namespace {

TEST(MtlMaterials, HaveColourOpacityAndTexture) {
  const auto materials = mtl_materials(
      "Kd 1 1 1\n# newmtl no\nnewmtl red wall\nKa 0 0 0\n Kd 1 0.25 0 \r\nd 0.5\nmap_Kd -s 1 1 1 a b.png\n"
      "NEWMTL glass\nKd 0.5\nTr 0.75\nnewmtl odd\nKd spectral file.rfl\nKd 2 -1 nan\nd -halo 0.5\n");
  ASSERT_EQ(materials.size(), 3U);
  EXPECT_EQ(materials[0].name, "red wall");
  EXPECT_EQ(materials[0].color, (Color{1, 0.25F, 0, 0.5F}));
  EXPECT_EQ(materials[0].texture, "a b.png");
  EXPECT_EQ(materials[1].color, (Color{0.5F, 0.5F, 0.5F, 0.25F}));
  EXPECT_EQ(materials[2].color, (Color{1, 0, 1, 1}));
}

TEST(Materials, AreThoseOfAllLibraries) {
  const whittle::test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "lib");
  std::ofstream(folder / "lib/a.mtl") << "newmtl a\nKd 0 0 0\nmap_Kd tex\\a.png\n";
  std::ofstream(folder / "b.mtl") << "newmtl b\nKd 0 0 1\n";
  FileNotes notes;
  notes.material_libraries = {"lib/a.mtl none.mtl", "b.mtl"};
  notes.header_lines = {"comment TextureFile all.png"};
  const std::vector<Material> materials = read_materials(notes, folder.path());
  ASSERT_EQ(materials.size(), 3U);
  EXPECT_EQ(materials[0].name, "");
  EXPECT_EQ(materials[0].texture, "all.png");
  EXPECT_EQ(materials[1].texture, "lib/tex/a.png");
  EXPECT_EQ(materials[1].color, (Color{1, 1, 1, 1})) << "a black one would leave nothing of the texture";
  EXPECT_EQ(materials[2].color, (Color{0, 0, 1, 1}));
}

TEST(FileNotes, AreThoseThatAFormatHas) {
  FileNotes notes;
  notes.material_libraries = {"a.mtl"};
  notes.header_lines = {"comment TextureFile a.png"};
  EXPECT_TRUE(notes_in(Format::obj, notes).header_lines.empty());
  EXPECT_EQ(notes_in(Format::obj, notes).material_libraries, notes.material_libraries);
  EXPECT_EQ(notes_in(Format::ply, notes).header_lines, notes.header_lines);
  EXPECT_EQ(notes_in(Format::ply, notes).material_libraries, notes.material_libraries);
  EXPECT_TRUE(notes_in(Format::stl, notes).material_libraries.empty());
}

}  // namespace
}  // namespace whittle::io
