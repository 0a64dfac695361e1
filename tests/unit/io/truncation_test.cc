// Files cut off at every byte. Reading gives an error or a valid mesh; for binary files always an error.
#include <gtest/gtest.h>

#include <sstream>

#include "io_test_tools.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

IndexedMesh sample() {
  IndexedMesh mesh = whittle::test::octahedron();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.normals.push_back({0, 0, 1});
    mesh.colors.push_back({0.2F, 0.4F, 0.6F, 0.8F});
    mesh.positions[v] *= 1.25e-3;
  }
  return mesh;
}

std::string file_of(Format format, bool ascii) {
  std::ostringstream out;
  write_mesh(out, format, sample(), {.ascii = ascii});
  return out.str();
}

// Formats that are always text come twice.
struct Case {
  Format format;
  bool ascii;

  std::string name() const { return std::string(title_of(format)) + (ascii ? "AsText" : "AsIs"); }
};

std::vector<Case> cases() {
  std::vector<Case> cases;
  for (const Format format : all_formats) {
    cases.push_back({format, true});
    cases.push_back({format, false});
  }
  return cases;
}

class Truncation : public testing::TestWithParam<Case> {};

TEST_P(Truncation, GivesAnErrorOrAValidMesh) {
  const std::string whole = file_of(GetParam().format, GetParam().ascii);
  const std::string name = "a." + std::string(name_of(GetParam().format));
  const std::size_t faces = test::read(whole, name).mesh.faces.size();
  EXPECT_EQ(faces, 8U);
  const bool is_text = whole == file_of(GetParam().format, true);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string what = name + " cut after " + std::to_string(length) + " of " + std::to_string(whole.size());
    try {
      const ReadResult result = test::read(std::string_view(whole).substr(0, length), name);
      test::expect_valid(result, what);
      EXPECT_TRUE(is_text) << what << ": read although truncated";
    } catch (const ReadError& error) {
      EXPECT_EQ(error.file(), name) << what;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Truncation, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name(); });

TEST(Truncation, OfBinaryOffIsAlwaysAnError) {
  const auto big = std::endian::big;
  const std::string whole = "OFF BINARY\n" + test::all_bytes_of(big, 3, 2, 0) +
                            test::all_bytes_of(big, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F) +
                            test::all_bytes_of(big, 3, 0, 1, 2, 0, 3, 0, 2, 1, 0);
  EXPECT_EQ(test::read(whole, "a.off").mesh.faces.size(), 2U);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(test::error_of(whole.substr(0, length), "a.off"), std::nullopt) << length;
  }
}

}  // namespace
}  // namespace whittle::io
