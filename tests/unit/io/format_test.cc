#include "whittle/io/format.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

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

TEST(Format, FollowsTheEndingInUpperAndLowerCase) {
  EXPECT_EQ(format_of("a/b.obj"), Format::obj);
  EXPECT_EQ(format_of("a.b/c.OFF"), Format::off);
  EXPECT_EQ(format_of("x.Ply"), Format::ply);
  EXPECT_EQ(format_of("1002_tray.STL"), Format::stl);
}

TEST(Format, IsFoundByABareEndingAndByItsName) {
  EXPECT_EQ(format_from_ending(".PLY"), Format::ply);
  for (const Format format : all_formats) EXPECT_EQ(format_from_ending(name_of(format)), format);
}

TEST(Format, NamesWhatIsKnownButNotSupported) {
  EXPECT_EQ(refusal("Duck.glb"), "is glTF (.glb), a format that is not supported; use OBJ, OFF, PLY or STL");
  EXPECT_NE(refusal("cube.om").find("OpenMesh's own format"), std::string::npos);
  EXPECT_NE(refusal("a.3DS").find("3D Studio"), std::string::npos);
  EXPECT_NE(refusal("cow.off.gz").find("compressed"), std::string::npos);
}

TEST(Format, AsksForAnEndingWhereThereIsNone) {
  EXPECT_EQ(refusal("mesh"), "has no ending that tells its format; name one of obj, off, ply, stl");
  EXPECT_EQ(refusal(".obj"), refusal("mesh"));  // a hidden file without an ending
  EXPECT_EQ(refusal("notes.txt"), "has the unknown ending \".txt\"; use OBJ, OFF, PLY or STL");
}

}  // namespace
}  // namespace whittle::io
