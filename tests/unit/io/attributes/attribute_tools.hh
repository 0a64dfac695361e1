#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "../io_test_tools.hh"
#include "whittle/io/write.hh"

namespace whittle::io::test {

/// All numbers that a corner of a face has, as bits.
inline std::vector<std::uint64_t> bits_at_corner(const IndexedMesh& mesh, std::size_t face, std::size_t corner) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  const Index w = mesh.wedge(face, corner);
  if (!mesh.normals.empty()) {
    for (const double x : mesh.normals[w]) add(x);
  }
  if (!mesh.colors.empty()) {
    for (const double x : mesh.colors[w]) add(x);
  }
  for (const Attribute& attribute : mesh.attributes) {
    for (const double x : attribute.value(w)) add(x);
  }
  return bits;
}

inline void expect_same_attributes(const std::vector<Attribute>& a, const std::vector<Attribute>& b,
                                   const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name) << what;
    EXPECT_EQ(a[i].kind, b[i].kind) << what << ": " << a[i].name;
    EXPECT_EQ(a[i].n_components, b[i].n_components) << what << ": " << a[i].name;
    EXPECT_EQ(a[i].type, b[i].type) << what << ": " << a[i].name;
    EXPECT_EQ(a[i].is_normalized, b[i].is_normalized) << what << ": " << a[i].name;
    EXPECT_EQ(a[i].values, b[i].values) << what << ": " << a[i].name;
  }
}

/// Everything but origins, which are numbers of a file.
inline void expect_same_mesh(const IndexedMesh& a, const IndexedMesh& b, const std::string& what) {
  EXPECT_EQ(a.positions, b.positions) << what;
  EXPECT_EQ(a.faces, b.faces) << what;
  EXPECT_EQ(a.wedges, b.wedges) << what;
  EXPECT_EQ(a.normals, b.normals) << what;
  EXPECT_EQ(a.colors, b.colors) << what;
  expect_same_attributes(a.attributes, b.attributes, what);
  expect_same_attributes(a.face_attributes, b.face_attributes, what);
  EXPECT_EQ(a.face_groups, b.face_groups) << what;
  EXPECT_EQ(a.group_names, b.group_names) << what;
}

inline void expect_same_notes(const FileNotes& a, const FileNotes& b, const std::string& what) {
  EXPECT_EQ(a.material_libraries, b.material_libraries) << what;
  EXPECT_EQ(a.header_lines, b.header_lines) << what;
  EXPECT_EQ(a.face_names, b.face_names) << what;
  EXPECT_EQ(a.vertex_properties, b.vertex_properties) << what;
  EXPECT_EQ(a.face_properties, b.face_properties) << what;
  EXPECT_EQ(a.color_type, b.color_type) << what;
}

inline std::vector<std::string> warnings_of(const IndexedMesh& mesh, Format format, const WriteOptions& options = {}) {
  std::ostringstream out;
  return write_mesh(out, format, mesh, options).warnings;
}

/// The files of a kind among the test assets, sorted. Empty if the folder is absent.
/// \param folder "ply" \param extension ".ply"
std::vector<std::filesystem::path> asset_files(const std::string& folder, const std::string& extension);

/// A cube whose sides have a chart each in a texture: vertices of their own along all edges.
IndexedMesh cube_with_charts();

/// A tube whose texture has a seam: the vertices of one line are there twice.
IndexedMesh tube_with_seam(Index around, Index along);

}  // namespace whittle::io::test

/// Defines `files` as the assets of a kind, or skips the test with a message.
#define WHITTLE_ASSETS_OR_SKIP(files, folder, extension)                      \
  const auto files = ::whittle::io::test::asset_files((folder), (extension)); \
  if ((files).empty()) GTEST_SKIP() << "no assets in " << WHITTLE_TEST_ASSETS << " (CMake: WHITTLE_TEST_ASSETS)"
