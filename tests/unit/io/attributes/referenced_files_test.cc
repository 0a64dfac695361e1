#include "whittle/io/file_notes.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "attribute_tools.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/read.hh"

namespace whittle::io {
namespace {

TEST(MtlTextures, FindsNamesAfterOptions) {
  const std::string mtl =
      "# map_Kd no.png\nnewmtl a\nKd 1 0 0\nmap_Kd plain.png\n  map_Ka -s 1.0 1.0 1.0 -o 0 0 0 ambient.gif\r\n"
      "MAP_BUMP -bm 0.2 bump 01.png\nbump -imfchan r -clamp on  b.png  \nrefl -type sphere -mm 0 1 sky\\clouds.hdr\n"
      "map_d -o 0.5 alpha.png\ndisp -texres 256 -blendu off -boost 2 d.tif\nnorm n.png\nmap_Kd plain.png\n"
      "map_aat on\nillum 2\nmap_Kd\nmap_Ks -unknown x.png\nmap_Kd -s 1 2 3 4.png";
  EXPECT_EQ(mtl_textures(mtl),
            (std::vector<std::string>{"plain.png", "ambient.gif", "bump 01.png", "b.png", "sky\\clouds.hdr",
                                      "alpha.png", "d.tif", "n.png", "-unknown x.png", "4.png"}));
}

TEST(MtlTextures, MakesOneSeparatorOfAll) {
  EXPECT_EQ(path_of_reference("materials\\\\images\\a b.png"), "materials/images/a b.png");
  EXPECT_EQ(path_of_reference(".\\a.jpg"), "./a.jpg");
  EXPECT_EQ(path_of_reference("/home/a//b.jpg"), "/home/a/b.jpg");
}

TEST(TextureLines, FindsNames) {
  EXPECT_EQ(texture_of_line("comment TextureFile   fuze uv.jpg "), "fuze uv.jpg");
  EXPECT_EQ(texture_of_line("comment texturefile: a.bin"), "a.bin");
  EXPECT_EQ(texture_of_line("obj_info picture of a.JPEG"), "a.JPEG");
  EXPECT_EQ(texture_of_line("comment made by hand"), "");
  EXPECT_EQ(texture_of_line("comment"), "");
  EXPECT_EQ(texture_of_line("comment .png"), "");
}

std::vector<std::string> files_of(const std::filesystem::path& file) {
  const ReadResult result = read_mesh(file);
  std::vector<std::string> names;
  for (const std::filesystem::path& name : referenced_files(result.notes, file.parent_path())) {
    names.push_back(name.generic_string());
  }
  return names;
}

TEST(ReferencedFiles, ListsWhatAssetsRefer) {
  WHITTLE_ASSETS_OR_SKIP(objs, "obj", ".obj");
  using Names = std::vector<std::string>;
  const auto files_of_asset = [&objs = objs](const std::string& name) {
    const auto at = std::find_if(objs.begin(), objs.end(), [&](const auto& path) { return path.filename() == name; });
    return at == objs.end() ? Names{} : files_of(*at);
  };
  EXPECT_EQ(files_of_asset("box-windows-paths.obj"),
            (Names{"materials/box-windows-paths.mtl", "materials/images/cesium.png"}));
  EXPECT_EQ(files_of_asset("box mtllib.obj"),
            (Names{"box mtllib red.mtl", "box mtllib green.mtl", "box mtllib blue.mtl"}));
  EXPECT_EQ(files_of_asset("box-texture-options.obj"),
            (Names{"box-texture-options.mtl", "ambient.gif", "emission.jpg", "diffuse.png", "specular.jpeg",
                   "shininess.png", "bump.png"}));
  EXPECT_EQ(files_of_asset("fuze.obj"), (Names{"fuze.obj.mtl", "fuze uv.jpg"}));
  EXPECT_EQ(files_of_asset("texture-filename-with-whitespace.obj"),
            (Names{"texture-filename-with-whitespace.mtl", "texture 01.png", "bump 01.png"}));
  EXPECT_EQ(files_of_asset("spider.obj").size(), 6U);
  WHITTLE_ASSETS_OR_SKIP(plys, "ply/tri_fuze", ".ply");
  EXPECT_EQ(files_of(plys.front()), Names{"fuze uv.jpg"});
}

TEST(ReferencedFiles, ListsLibrariesThatAreNotThere) {
  FileNotes notes;
  notes.material_libraries = {"none.mtl", "no extension", "  a.MTL   b.mtl "};
  const std::vector<std::filesystem::path> expected = {"none.mtl", "no extension", "a.MTL", "b.mtl"};
  EXPECT_EQ(referenced_files(notes, "/no/such/folder"), expected);
}

}  // namespace
}  // namespace whittle::io
