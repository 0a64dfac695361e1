#include "whittle/io/format.hh"

#include "format/foreign.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "format/format_row.hh"
#include "support/shapes/shapes.hh"

namespace whittle::io {
namespace {

std::string refusal(const std::filesystem::path& path) {
  try {
    format_of(path);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " has a format";
  return {};
}

TEST(FormatTable, HasARowForEachFormatInTheirOrder) {
  for (std::size_t i = 0; i < all_formats.size(); ++i) {
    EXPECT_EQ(all_formats[i], detail::format_table[i]->format);
    EXPECT_EQ(&row_of(all_formats[i]), detail::format_table[i]);
  }
  EXPECT_THROW(row_of(static_cast<Format>(all_formats.size())), std::invalid_argument);
}

TEST(FormatTable, GivesEachNameAndExtensionToOneFormat) {
  std::set<std::string_view> names;
  std::set<std::string_view> extensions;
  for (const detail::FormatRow* row : detail::format_table) {
    EXPECT_TRUE(names.insert(row->name).second) << row->name;
    EXPECT_FALSE(row->title.empty()) << row->name;
    for (const std::string_view extension : row->extensions) {
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
      EXPECT_EQ(format_from_extension(extension), row->format);
    }
    EXPECT_TRUE(extensions.contains(row->name)) << row->name;
  }
}

TEST(FormatTable, HasAPageForEachFormat) {
  for (const Format format : all_formats) {
    const std::string page = std::string(name_of(format)) + ".md";
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(WHITTLE_DOCS_DIR) / "user" / "formats" / page)) << page;
  }
}

TEST(FormatTable, IsListedInMessages) {
  for (const Format format : all_formats) {
    EXPECT_NE((", " + format_names() + ",").find(", " + std::string(name_of(format)) + ","), std::string::npos);
    EXPECT_NE(format_titles().find(title_of(format)), std::string::npos);
  }
  EXPECT_TRUE(format_names("|").starts_with("obj|off|ply|stl")) << format_names("|");
  EXPECT_TRUE(format_titles().starts_with("OBJ, OFF, PLY")) << format_titles();
  EXPECT_TRUE(format_titles().ends_with(" or " + std::string(title_of(all_formats.back())))) << format_titles();
}

TEST(FormatTable, SaysWhereAsciiMakesADifference) {
  for (const Format format : all_formats) {
    std::ostringstream text;
    std::ostringstream binary;
    write_mesh(text, format, whittle::test::cube(), {.ascii = true});
    write_mesh(binary, format, whittle::test::cube(), {.ascii = false});
    EXPECT_EQ(text.str() != binary.str(), has_text_and_binary(format)) << name_of(format);
    const bool is_listed = titles_with_text_and_binary().find(title_of(format)) != std::string::npos;
    EXPECT_EQ(is_listed, has_text_and_binary(format)) << name_of(format);
  }
}

TEST(Format, FollowsTheExtensionInUpperAndLowerCase) {
  EXPECT_EQ(format_of("a/b.obj"), Format::obj);
  EXPECT_EQ(format_of("a.b/c.OFF"), Format::off);
  EXPECT_EQ(format_of("x.Ply"), Format::ply);
  EXPECT_EQ(format_of("1002_tray.STL"), Format::stl);
  EXPECT_EQ(format_from_extension(".PLY"), Format::ply);
}

TEST(Format, FollowsTheExtensionBeforeThatOfGzip) {
  EXPECT_EQ(format_of("a/cow.off.gz"), Format::off);
  EXPECT_EQ(format_of("cow.PLY.GZ"), Format::ply);
  EXPECT_EQ(refusal("cow.gz"), refusal("cow"));
  EXPECT_TRUE(has_gzip_extension("a.gz/cow.PLY.GZ"));
  EXPECT_FALSE(has_gzip_extension("a.gz/cow.ply"));
}

TEST(Format, NamesWhatIsKnownButNotSupported) {
  EXPECT_EQ(refusal("Duck.glb"), "is glTF (.glb), a format that is not supported; use " + format_titles());
  EXPECT_NE(refusal("cube.om").find("OpenMesh's own format"), std::string::npos);
  EXPECT_NE(refusal("a.3DS").find("3D Studio"), std::string::npos);
  EXPECT_EQ(refusal("cow.off.xz"), "is compressed (.xz), which is not supported; unpack it first (unxz)");
  EXPECT_EQ(refusal("cow.off.gz.gz"), "is compressed (.gz), which is not supported; unpack it first (gunzip)");
  EXPECT_EQ(refusal("Duck.glb.gz"), refusal("Duck.glb"));
}

TEST(Format, NamesWhatConvertsOthers) {
  const std::pair<const char*, const char*> tools[] = {
      {"a.fbx", "FBX (.fbx), a format that is not supported; convert it with assimp ('assimp export IN OUT.obj')"},
      {"a.dae", "assimp"},
      {"a.3ds", "assimp"},
      {"a.3mf", "assimp"},
      {"a.dxf", "assimp"},
      {"a.step", "'gmsh IN -2"},
      {"a.stp", "FreeCAD"},
      {"a.iges", "FreeCAD"},
      {"a.igs", "FreeCAD"},
      {"a.usd", "Blender"},
      {"a.usda", "Blender"},
      {"a.usdc", "Blender"},
      {"a.usdz", "Blender"},
      {"a.blend", "Blender"},
      {"a.ifc", "IfcConvert"},
      {"a.vrml", "MeshLab"},
      {"a.wrl", "MeshLab"},
      {"a.x3d", "MeshLab"},
      {"a.skp", "the program that made it"},
      {"a.max", "the program that made it"},
      {"a.vtu", "ParaView"},
      {"a.om", "mconvert"},
      {"a.drc", "draco_decoder"},
      {"a.e57", "has no faces"},
  };
  for (const auto& [name, tool] : tools) EXPECT_NE(refusal(name).find(tool), std::string::npos) << refusal(name);
}

TEST(Format, AsksForAnExtensionWhereThereIsNone) {
  EXPECT_EQ(refusal("mesh"), "has no extension that tells its format; name one of " + format_names() + ", glb, gltf");
  EXPECT_EQ(refusal(".obj"), refusal("mesh"));  // A hidden file without an extension.
  EXPECT_EQ(refusal("notes.txt"), "has the unknown extension \".txt\"; use " + mesh_titles());
}

}  // namespace
}  // namespace whittle::io
