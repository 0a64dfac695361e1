#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "io_test_tools.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

using test::written;
using whittle::test::Random;

// Doubles of every size: denormals, huge numbers, whole numbers, −0.
double any_double(Random& random) {
  switch (random.below(6)) {
    case 0:
      return random.uniform(-1, 1);
    case 1:
      return -0.0;
    case 2:
      return static_cast<double>(random.below(1000)) - 500;
    case 3:
      return std::bit_cast<double>(random.bits() & 0x000FFFFFFFFFFFFFU);  // denormal
    case 4:
      return std::ldexp(random.uniform(-1, 1), 1020);
    default:
      break;
  }
  double value = 0;
  do {
    value = std::bit_cast<double>(random.bits());
  } while (!std::isfinite(value));
  return value;
}

float any_float(Random& random) {
  float value = 0;
  do {
    value = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
  } while (!std::isfinite(value));
  return value;
}

template <class Make>
IndexedMesh random_mesh(std::uint64_t seed, const Make& make) {
  Random random(seed);
  IndexedMesh mesh;
  for (Index v = 0; v < 60; ++v) mesh.positions.emplace_back(make(random), make(random), make(random));
  for (Index v = 0; v < 60; ++v) mesh.faces.push_back({v, (v + 7) % 60, (v + 31) % 60});
  return mesh;
}

void add_attributes(IndexedMesh& mesh, std::uint64_t seed, bool bytes) {
  Random random(seed);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Eigen::Vector3f normal(static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)), 1);
    normal.normalize();
    mesh.normals.push_back({normal.x(), normal.y(), normal.z()});
    Color color{};
    for (float& c : color) {
      c = bytes ? static_cast<float>(random.below(256)) / 255.F : static_cast<float>(random.uniform());
    }
    mesh.colors.push_back(color);
  }
}

// Whether the writer reports a loss.
bool holds_all(const IndexedMesh& mesh, Format format, const WriteOptions& options) {
  std::ostringstream out;
  return write_mesh(out, format, mesh, options).warnings.empty();
}

IndexedMesh read_back(const std::string& bytes, Format format) {
  return test::read(bytes, "a." + std::string(name_of(format)), false).mesh;
}

std::string name_of_case(Format format, const WriteOptions& options, std::uint64_t seed) {
  return std::string(name_of(format)) + (options.ascii ? " text" : "") + ", seed " + std::to_string(seed);
}

void expect_same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t v = 0; v < a.size(); ++v) {
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a[v][i]), std::bit_cast<std::uint64_t>(b[v][i]))
          << what << ", vertex " << v << ": " << a[v][i] << " became " << b[v][i];
    }
  }
}

struct Way {
  Format format;
  bool ascii;
};
// STL stores no shared vertices and has tests of its own.
const std::vector<Way> indexed_ways = [] {
  std::vector<Way> ways;
  for (const Format format : all_formats) {
    for (const bool ascii : {true, false}) {
      if (format != Format::stl) ways.push_back({format, ascii});
    }
  }
  return ways;
}();

TEST(RoundTrip, KeepsEveryBitOfEveryDouble) {
  for (const auto& [format, ascii] : indexed_ways) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const IndexedMesh mesh = random_mesh(seed, any_double);
      const WriteOptions options{.ascii = ascii};
      const IndexedMesh back = read_back(written(mesh, format, options), format);
      expect_same_bits(mesh.positions, back.positions, name_of_case(format, options, seed));
      EXPECT_EQ(mesh.faces, back.faces);
    }
  }
}

TEST(RoundTrip, KeepsFloatsInPlyAsFloats) {
  for (const bool ascii : {false, true}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const IndexedMesh mesh = random_mesh(seed, [](Random& random) { return double{any_float(random)}; });
      const std::string bytes = written(mesh, Format::ply, {.ascii = ascii});
      EXPECT_NE(bytes.find("property float x"), std::string::npos);
      expect_same_bits(mesh.positions, read_back(bytes, Format::ply).positions,
                       name_of_case(Format::ply, {.ascii = ascii}, seed));
    }
  }
  const IndexedMesh doubles = random_mesh(0, [](Random& random) { return random.uniform(); });
  EXPECT_NE(written(doubles, Format::ply).find("property double x"), std::string::npos);
}

TEST(RoundTrip, KeepsEveryBitInTextStlAndFloatsInBinaryStl) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const IndexedMesh mesh = random_mesh(seed, any_double);
    const IndexedMesh soup = whittle::test::soup(mesh);
    expect_same_bits(soup.positions, read_back(written(mesh, Format::stl, {.ascii = true}), Format::stl).positions,
                     "text STL, seed " + std::to_string(seed));
    const IndexedMesh floats = random_mesh(seed, [](Random& random) { return double{any_float(random)}; });
    expect_same_bits(whittle::test::soup(floats).positions,
                     read_back(written(floats, Format::stl), Format::stl).positions,
                     "binary STL, seed " + std::to_string(seed));
  }
}

TEST(RoundTrip, KeepsNormalsAndExactColors) {
  for (const auto& [format, ascii] : indexed_ways) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      IndexedMesh mesh = random_mesh(seed, any_double);
      add_attributes(mesh, seed, false);
      if (format == Format::obj) {
        for (Color& color : mesh.colors) color[3] = 1;  // OBJ has no opacity
      }
      const WriteOptions options{.ascii = ascii, .exact_colors = true};
      if (!holds_all(mesh, format, options)) continue;
      const IndexedMesh back = read_back(written(mesh, format, options), format);
      EXPECT_EQ(mesh.normals, back.normals) << name_of_case(format, options, seed);
      EXPECT_EQ(mesh.colors, back.colors) << name_of_case(format, options, seed);
    }
  }
}

TEST(RoundTrip, KeepsColorsOfEightBitsWithoutAsking) {
  for (const auto& [format, ascii] : indexed_ways) {
    IndexedMesh mesh = random_mesh(1, any_double);
    add_attributes(mesh, 1, true);
    if (!holds_all(mesh, format, {.ascii = ascii})) continue;
    const IndexedMesh back = read_back(written(mesh, format, {.ascii = ascii}), format);
    EXPECT_EQ(mesh.colors, back.colors) << name_of_case(format, {.ascii = ascii}, 1);
  }
}

TEST(RoundTrip, LeavesOpacityOutWhereAllIsOpaque) {
  IndexedMesh mesh = random_mesh(1, any_double);
  add_attributes(mesh, 1, true);
  for (Color& color : mesh.colors) color[3] = 1;
  const std::string ply = written(mesh, Format::ply);
  EXPECT_EQ(ply.find("alpha"), std::string::npos);
  EXPECT_EQ(read_back(ply, Format::ply).colors, mesh.colors);
  EXPECT_EQ(read_back(written(mesh, Format::off), Format::off).colors, mesh.colors);
}

TEST(RoundTrip, OfASurfaceThroughStlGivesItBack) {
  const IndexedMesh mesh = whittle::test::torus(12, 8);
  for (const bool ascii : {false, true}) {
    const ReadResult back = test::read(written(mesh, Format::stl, {.ascii = ascii}), "a.stl");
    EXPECT_EQ(back.mesh.positions.size(), mesh.positions.size());
    EXPECT_EQ(back.mesh.faces.size(), mesh.faces.size());
  }
}

TEST(WriteMesh, SaysWhatTheFormatCannotHold) {
  IndexedMesh mesh = random_mesh(1, [](Random& random) { return random.uniform(); });
  add_attributes(mesh, 1, true);
  std::ostringstream out;
  EXPECT_EQ(write_mesh(out, Format::stl, mesh).warnings,
            (std::vector<std::string>{"STL has no vertex normals: they are left out",
                                      "STL has no vertex colours: they are left out"}));
  EXPECT_EQ(write_mesh(out, Format::obj, mesh).warnings,
            (std::vector<std::string>{"OBJ has no opacity: it is left out"}));
  EXPECT_TRUE(write_mesh(out, Format::ply, mesh).warnings.empty());
}

TEST(WriteMesh, SaysHowFarBinaryStlRounds) {
  IndexedMesh mesh = random_mesh(1, [](Random& random) { return 1e6 + random.uniform(); });
  const auto warnings = [&](const FileNotes& notes, bool ascii) {
    std::ostringstream out;
    return write_mesh(out, Format::stl, mesh, {.ascii = ascii, .notes = notes}).warnings;
  };
  ASSERT_EQ(warnings({}, false).size(), 1U);
  EXPECT_THAT(warnings({}, false).front(), testing::HasSubstr("positions are rounded by up to 0.0"));
  EXPECT_TRUE(warnings({}, true).empty());
  const ReadResult of_stl = test::read(written(mesh, Format::stl), "a.stl");
  EXPECT_TRUE(of_stl.notes.has_float32_positions);
  EXPECT_TRUE(warnings(of_stl.notes, false).empty()) << "the file that was read had no more digits";
}

TEST(WriteMesh, RefusesCoordinatesBeyondBinaryStl) {
  IndexedMesh mesh = whittle::test::single_triangle();
  mesh.positions[1] *= 1e300;
  std::ostringstream out;
  EXPECT_THROW(write_mesh(out, Format::stl, mesh), WriteError);
  EXPECT_NO_THROW(write_mesh(out, Format::stl, mesh, {.ascii = true}));
}

TEST(WriteMesh, WritesUnitNormalsOfStlFacets) {
  IndexedMesh mesh = whittle::test::single_triangle();
  mesh.positions = {{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}};
  EXPECT_NE(written(mesh, Format::stl, {.ascii = true}).find("facet normal 0 0 1\n"), std::string::npos);
  mesh.positions[2] = {2e-200, 0, 0};
  EXPECT_NE(written(mesh, Format::stl, {.ascii = true}).find("facet normal 0 0 0\n"), std::string::npos);
}

TEST(WriteMesh, SaysWhenTheStreamFails) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(write_mesh(out, Format::ply, whittle::test::cube()), WriteError);
}

}  // namespace
}  // namespace whittle::io
