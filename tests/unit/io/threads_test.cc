// Large files are read on all threads. That may change nothing: neither the mesh nor which error is the first.
#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <random>
#include <sstream>

#include "io_test_tools.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

using whittle::test::blob;

/// With normals and colours, 40,962 vertices and 81,920 faces: several ranges of rows.
IndexedMesh large_mesh() {
  IndexedMesh mesh = blob(6, 1);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.normals.push_back({0, 0, v % 2 == 0 ? 1.0F : -1.0F});
    const auto shade = static_cast<float>(v % 256) / 255;
    mesh.colors.push_back({shade, 1 - shade, 0.2F, 1});
  }
  return mesh;
}

std::string text_of(const IndexedMesh& mesh, Format format) {
  std::ostringstream out;
  write_mesh(out, format, mesh);
  return out.str();
}

/// What reading gives or how it fails, as text.
std::string outcome(const std::string& bytes, Format format, unsigned threads) {
  try {
    const ReadResult result = read_mesh(bytes, "file", {.format = format, .threads = threads});
    std::string text = text_of(result.mesh, Format::ply) + to_string(result.repairs);
    for (const std::string& warning : result.warnings) text.append(1, '\n').append(warning);
    return text.append(1, '\n').append(std::to_string(result.file_faces));
  } catch (const ReadError& error) {
    return error.what();
  }
}

void expect_same_outcome(const std::string& bytes, Format format) {
  const std::string expected = outcome(bytes, format, 1);
  for (const unsigned threads : {2U, 3U, 0U}) EXPECT_TRUE(outcome(bytes, format, threads) == expected);
}

template <class Number>
void put(std::string& bytes, std::size_t at, Number value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

TEST(ReadingOnThreads, GivesTheSameMesh) {
  const IndexedMesh mesh = large_mesh();
  for (const Format format : all_formats) {
    expect_same_outcome(text_of(mesh, format), format);
  }
}

TEST(ReadingOnThreads, FindsTheSameRepairs) {
  std::mt19937 random(1);
  IndexedMesh mesh = whittle::test::soup(blob(5, 2));
  for (std::size_t i = 0; i < 1000; ++i) {
    const Triangle face = mesh.faces[random() % mesh.faces.size()];
    mesh.faces.push_back({face[1], face[2], face[0]});
    mesh.faces[random() % mesh.faces.size()][1] = face[0];
  }
  expect_same_outcome(text_of(mesh, Format::ply), Format::ply);
}

TEST(ReadingOnThreads, NamesTheFirstCoordinateThatIsNotFinite) {
  const std::string ply = text_of(blob(6, 1), Format::ply);
  const std::size_t first = ply.find("end_header\n") + 11;
  const std::string stl = text_of(blob(6, 1), Format::stl);
  for (const std::size_t row : {40'000U, 39'999U, 20'000U}) {
    std::string bad_ply = ply;
    std::string bad_stl = stl;
    for (std::size_t r = row; r < 40'962; r += 313) {
      put(bad_ply, first + 24 * r + 8, std::numeric_limits<double>::infinity());
      put(bad_stl, 84 + 50 * r + 12, std::numeric_limits<float>::quiet_NaN());
    }
    expect_same_outcome(bad_ply, Format::ply);
    EXPECT_THAT(outcome(bad_ply, Format::ply, 3), testing::HasSubstr(std::to_string(first + 24 * row + 8)));
    expect_same_outcome(bad_stl, Format::stl);
    EXPECT_THAT(outcome(bad_stl, Format::stl, 3), testing::HasSubstr(std::to_string(84 + 50 * row + 12)));
  }
}

TEST(ReadingOnThreads, TakesPolygonsAmongManyTriangles) {
  std::ostringstream out;
  constexpr std::uint32_t n = 50'000;
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << n + 2
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << n
      << "\nproperty uchar quality\nproperty list uchar uint vertex_indices\nend_header\n";
  const auto write = [&](auto value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  for (std::uint32_t v = 0; v < n + 2; ++v) {
    for (const float x : {static_cast<float>(v / 2), static_cast<float>(v % 2), 0.0F}) write(x);
  }
  for (std::uint32_t f = 0; f < n; ++f) {
    const bool is_quad = f == 30'000;
    write(std::uint8_t{7});
    write(static_cast<std::uint8_t>(is_quad ? 4 : 3));
    for (std::uint32_t i = 0; i < 3; ++i) write(f + i);
    if (is_quad) write(std::uint32_t{0});
  }
  expect_same_outcome(out.str(), Format::ply);
  EXPECT_THAT(outcome(out.str(), Format::ply, 2), testing::HasSubstr("triangulated 1 polygon"));
  std::string bad = out.str();
  put(bad, bad.size() - 4, n + 2);
  expect_same_outcome(bad, Format::ply);
  EXPECT_THAT(outcome(bad, Format::ply, 2), testing::HasSubstr("vertex number 50002"));
}

}  // namespace
}  // namespace whittle::io
