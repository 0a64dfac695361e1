// Meshes packed with gzip.
#include "bytes/gzip.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "io_test_tools.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

using test::cat;
using test::error_of;
using test::expect_error;
using test::read;

std::string packed(const std::string& bytes) {
  std::ostringstream out;
  GzipBuffer buffer(out);
  std::ostream(&buffer) << bytes;
  buffer.finish();
  return out.str();
}

std::string unpacked(const std::string& bytes) {
  const std::vector<char> result = gunzip(bytes, "a");
  return {result.begin(), result.end()};
}

bool is_same_data(const std::string& a, const std::string& b) {
  try {
    return unpacked(a) == unpacked(b);
  } catch (const ReadError&) {
    return false;
  }
}

std::string packed_or_not(const IndexedMesh& mesh, Format format, bool gzip) {
  std::ostringstream out;
  write_mesh(out, format, mesh, {.gzip = gzip});
  return out.str();
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Gzip, GivesBackWhatItPacked) {
  whittle::test::Random random(1);
  for (const std::size_t size : {0U, 1U, 1000U, 65'535U, 65'536U, 3'000'000U}) {
    std::string noise(size, '\0');
    for (char& c : noise) c = static_cast<char>(random.below(256));
    EXPECT_EQ(unpacked(packed(noise)), noise) << size;
    const std::string zeros(size, '\0');  // these pack to far less than the first guess of the length allows
    EXPECT_EQ(unpacked(packed(zeros)), zeros) << size;
    EXPECT_EQ(packed(noise), packed(noise)) << "no time in the header";
  }
}

TEST(Gzip, IsUnpackedMemberByMember) { EXPECT_EQ(unpacked(packed("ab") + packed("") + packed("cd")), "abcd"); }

TEST(Gzip, TakesAByteAtATime) {
  std::ostringstream out;
  GzipBuffer buffer(out);
  std::ostream stream(&buffer);
  for (const char c : std::string("one by one")) stream.put(c);
  buffer.finish();
  EXPECT_EQ(unpacked(out.str()), "one by one");
}

TEST(Gzip, OfEveryFormatIsReadWhateverTheName) {
  const IndexedMesh mesh = whittle::test::octahedron();
  for (const Format format : all_formats) {
    const std::string bytes = packed_or_not(mesh, format, true);
    ASSERT_TRUE(is_gzip(bytes));
    EXPECT_EQ(unpacked(bytes), packed_or_not(mesh, format, false));
    const std::string name = "a." + std::string(name_of(format));
    for (const std::string& any : {name, name + ".gz"}) {
      EXPECT_EQ(read(bytes, any).mesh.faces.size(), 8U) << any;
      EXPECT_EQ(read(unpacked(bytes), any).mesh.faces.size(), 8U) << any;
    }
  }
}

TEST(Gzip, IsWrittenWhereTheNameAsksForIt) {
  const std::filesystem::path folder = testing::TempDir();
  const IndexedMesh mesh = whittle::test::octahedron();
  const auto written_to = [&](const std::string& name, const WriteOptions& options) {
    write_mesh(folder / name, mesh, options);
    const std::string bytes = read_file(folder / name);
    EXPECT_EQ(read_mesh(folder / name).mesh.positions, mesh.positions) << name;
    std::filesystem::remove(folder / name);
    return bytes;
  };
  EXPECT_TRUE(is_gzip(written_to("whittle_gzip.ply.gz", {})));
  EXPECT_TRUE(is_gzip(written_to("whittle_gzip.OBJ.GZ", {})));
  EXPECT_FALSE(is_gzip(written_to("whittle_gzip.ply", {})));
  EXPECT_FALSE(is_gzip(written_to("whittle_gzip.ply.gz", {.gzip = false})));
  EXPECT_TRUE(is_gzip(written_to("whittle_gzip.ply", {.gzip = true})));
}

TEST(Gzip, CutOffAnywhereIsRefused) {
  const std::string whole = packed_or_not(whittle::test::octahedron(), Format::ply, true);
  for (std::size_t length = 2; length < whole.size(); ++length) {
    expect_error(whole.substr(0, length), "a.ply.gz", "a.ply.gz: the gzip data end too early; the file is truncated");
  }
  for (const std::size_t length : {0U, 1U}) EXPECT_NE(error_of(whole.substr(0, length), "a.ply.gz"), std::nullopt);
}

// What follows the header of ten bytes is covered by the checksum and the length. Few flips unpack to the same bytes:
// those of bits that fill up a byte, or that refer to another place with the same content.
TEST(Gzip, DamagedAnywhereIsRefused) {
  const std::string whole = packed_or_not(whittle::test::octahedron(), Format::ply, true);
  std::size_t n_same = 0;
  for (std::size_t byte = 10; byte < whole.size(); ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = whole;
      damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << bit));
      if (is_same_data(damaged, whole)) {
        ++n_same;
        continue;
      }
      const auto error = error_of(damaged, "a.ply.gz");
      ASSERT_NE(error, std::nullopt) << "byte " << byte << ", bit " << bit;
      EXPECT_TRUE(std::string(error->what()).starts_with("a.ply.gz: the gzip data ") ||
                  std::string(error->what()).starts_with("a.ply.gz: the file goes on after"))
          << error->what();
    }
  }
  EXPECT_LT(n_same, whole.size() / 10);
  std::string wrong_sum = whole;
  wrong_sum[whole.size() - 8] = static_cast<char>(wrong_sum[whole.size() - 8] ^ 1);
  expect_error(wrong_sum, "a.ply.gz", "a.ply.gz: the gzip data are damaged (incorrect data check)");
}

TEST(Gzip, MustEndWithTheFile) {
  const std::string whole = packed_or_not(whittle::test::octahedron(), Format::ply, true);
  expect_error(whole + "more", "a.ply.gz", "a.ply.gz: the file goes on after the end of its gzip data");
}

TEST(Gzip, OfSomethingElseIsRefusedAsThat) {
  expect_error(packed(""), "a.ply.gz", "a.ply.gz: the file is empty");
  const std::string off = packed_or_not(whittle::test::octahedron(), Format::off, true);
  expect_error(off, "a.ply.gz", "a.ply.gz: the content is off, not ply; rename it to .off.gz");
  const auto twice = error_of(packed(off), "a.off.gz");
  EXPECT_NE(std::string(twice->what()).find("the content is compressed with gzip"), std::string::npos) << twice->what();
}

// A thousand times as much as the file holds, and more than is harmless.
TEST(Gzip, ThatWouldFillTheMemoryIsRefused) {
  std::ostringstream out;
  GzipBuffer buffer(out);
  std::ostream stream(&buffer);
  const std::string zeros(std::size_t{1} << 20, '\0');
  for (std::size_t done = 0; done <= harmless_gzip_bytes; done += zeros.size()) stream << zeros;
  buffer.finish();
  const std::string bomb = out.str();
  ASSERT_LT(bomb.size() * most_gzip_ratio, harmless_gzip_bytes);
  const auto error = error_of(bomb, "a.ply.gz");
  EXPECT_NE(std::string(error->what()).find("a.ply.gz: the gzip data unpack to more than 256 MiB"), std::string::npos)
      << error->what();
}

TEST(Gzip, SaysWhenTheStreamFails) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(write_mesh(out, Format::ply, whittle::test::cube(), {.gzip = true}), WriteError);
}

}  // namespace
}  // namespace whittle::io
