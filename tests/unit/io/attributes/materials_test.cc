#include "whittle/io/materials.hh"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/temporary_folder.hh"
#include "whittle/io/output_file.hh"

namespace whittle::io {
namespace {

using Rgba = std::array<double, 4>;

IndexedMesh mesh_with_groups(std::vector<std::string> names) {
  IndexedMesh mesh;
  mesh.group_names = std::move(names);
  return mesh;
}

std::filesystem::path texture_of(const Material& material) {
  return material.base_color_texture ? material.base_color_texture->image->file : std::filesystem::path();
}

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
  const SurfaceMaterials all =
      read_materials(notes, folder.path(), mesh_with_groups({"red wall", "odd", "b", "of no library"}));
  ASSERT_EQ(all.materials.size(), 4U);
  EXPECT_TRUE(all.are_told);
  EXPECT_EQ(all.materials[0].name, "red wall");
  EXPECT_EQ(all.materials[0].base_color, (Rgba{1, 0.25, 0, 0.5}));
  EXPECT_EQ(all.materials[0].alpha_mode, Alpha::blend);
  EXPECT_EQ(texture_of(all.materials[0]), "lib/tex/a b.png");
  EXPECT_FALSE(all.materials[0].base_color_texture->is_tinted);
  EXPECT_EQ(all.materials[1].base_color, (Rgba{0.5, 0.5, 0.5, 1})) << "the first of a name counts";
  EXPECT_EQ(all.materials[1].alpha_mode, Alpha::opaque);
  EXPECT_EQ(texture_of(all.materials[1]), "") << "the library says what it looks like";
  EXPECT_EQ(all.materials[2].base_color, (Rgba{1, 0, 1, 1}));
  EXPECT_EQ(texture_of(all.materials[3]), "all.png");
  for (const Material& material : all.materials) EXPECT_TRUE(material.double_sided);
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
  const SurfaceMaterials all = read_materials(notes, folder.path(), mesh_with_groups({"red one", "grey", "odd"}));
  ASSERT_EQ(all.materials.size(), 3U);
  EXPECT_EQ(all.materials[0].base_color, (Rgba{1, 0, 0.5, 0.25}));
  EXPECT_EQ(texture_of(all.materials[0]), "m/images/a b.png");
  EXPECT_EQ(all.materials[1].base_color, (Rgba{0.5, 0.5, 0.5, 1}));
  EXPECT_EQ(texture_of(all.materials[1]), "");
  EXPECT_EQ(all.materials[2].base_color, (Rgba{1, 0, 0, 1})) << "shares are at most 1";
  EXPECT_EQ(all.missing, std::vector<std::filesystem::path>{"none.mtl"});
}

TEST(ReadMaterials, FindsTheTextureOfPly) {
  FileNotes notes;
  notes.header_lines = {"comment TextureFile a b.png", "comment made by hand"};
  IndexedMesh mesh;
  mesh.attributes.push_back({.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}});
  const SurfaceMaterials one = read_materials(notes, {}, mesh);
  ASSERT_EQ(one.materials.size(), 1U);
  EXPECT_EQ(texture_of(one.materials[0]), "a b.png");
  const Texture& texture = *one.materials[0].base_color_texture;
  EXPECT_EQ(texture.texcoord, "uv");
  EXPECT_EQ(texture.transform * Eigen::Vector2d(0.25, 0.25), Eigen::Vector2d(0.25, 0.75)) << "rows go down in images";
  notes.header_lines.emplace_back("comment TextureFile c.jpg");
  const SurfaceMaterials several = read_materials(notes, {}, mesh);
  EXPECT_TRUE(several.has_several_textures);
  EXPECT_FALSE(several.are_told);
  EXPECT_EQ(texture_of(several.materials[0]), "");
}

TEST(ReadImages, ReadsEachOnce) {
  const whittle::test::TemporaryFolder folder;
  write_file(folder.path() / "a.mtl", "newmtl a\nmap_Kd x.png\nnewmtl b\nmap_Kd x.png\nnewmtl c\nmap_Kd no.png\n");
  write_file(folder.path() / "x.png", "pixels");
  FileNotes notes;
  notes.material_libraries = {"a.mtl"};
  std::vector<Material> all = read_materials(notes, folder.path(), mesh_with_groups({"a", "b", "c", "d"})).materials;
  read_images(all, folder.path());
  EXPECT_EQ(all[0].base_color_texture->image->bytes, "pixels");
  EXPECT_EQ(all[0].base_color_texture->image, all[1].base_color_texture->image);
  EXPECT_EQ(all[2].base_color_texture->image->problem, "the file can't be read");
}

}  // namespace
}  // namespace whittle::io
