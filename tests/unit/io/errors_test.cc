#include "whittle/io/errors.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "io_test_tools.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

using test::error_of;

TEST(ReadError, NamesTheLineOfATextFile) {
  const auto error = error_of("ply\nformat ascii 1.0\nelements vertex 3\n", "a.ply");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->line(), 3U);
  EXPECT_EQ(error->byte_offset(), std::nullopt);
}

TEST(ReadError, NamesTheByteOfABinaryFile) {
  const std::string header(80, ' ');
  const auto error = error_of(header + test::bytes_of(std::uint32_t{3}) + std::string(100, '\0'), "a.stl");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->byte_offset(), 80U);
  EXPECT_EQ(error->line(), std::nullopt);
}

TEST(ReadError, OfAWholeFileNamesNoPlace) {
  const auto error = error_of("", "a.obj");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->line(), std::nullopt);
  EXPECT_EQ(error->byte_offset(), std::nullopt);
}

TEST(WriteError, NamesTheFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "no_such_folder" / "a.ply";
  try {
    write_mesh(path, whittle::test::cube());
    ADD_FAILURE() << "written";
  } catch (const WriteError& error) {
    EXPECT_EQ(error.file(), path.string());
    EXPECT_EQ(std::string(error.what()).find(path.string() + ": cannot be written: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace whittle::io
