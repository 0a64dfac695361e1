#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io::test {

inline ReadResult read(std::string_view bytes, std::string_view name, bool weld = true,
                       AttributeScope attributes = AttributeScope::all) {
  return read_mesh(std::span<const char>(bytes.data(), bytes.size()), name, {.weld = weld, .attributes = attributes});
}

/// The bytes of a file.
inline std::string written(const IndexedMesh& mesh, Format format, const WriteOptions& options = {}) {
  std::ostringstream out;
  write_mesh(out, format, mesh, options);
  return out.str();
}

/// With normals and colours of vertices alone.
inline ReadResult read_per_vertex(std::string_view bytes, std::string_view name) {
  return read(bytes, name, true, AttributeScope::per_vertex);
}

/// The error that reading ends with. Without an error the test fails and nothing is returned.
inline std::optional<ReadError> error_of(std::string_view bytes, std::string_view name) {
  try {
    read(bytes, name);
  } catch (const ReadError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_EQ(error.file(), name);
    return error;
  }
  ADD_FAILURE() << "read without an error: " << name;
  return std::nullopt;
}

inline void expect_error(std::string_view bytes, std::string_view name, std::string_view message) {
  const auto error = error_of(bytes, name);
  EXPECT_EQ(std::string(error ? error->what() : ""), message);
}

/// Checks what every reader promises of its result.
inline void expect_valid(const ReadResult& result, const std::string& what) {
  const IndexedMesh& mesh = result.mesh;
  const std::size_t vertices = mesh.positions.size();
  ASSERT_FALSE(mesh.faces.empty()) << what;
  std::vector<char> is_used(vertices, 0);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      ASSERT_LT(v, vertices) << what;
      is_used[v] = 1;
    }
    ASSERT_TRUE(has_three_corners(face)) << what;
  }
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 0), 0) << what << ": isolated vertices";
  for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite()) << what;
  EXPECT_NO_THROW(check_attributes(mesh, "a reader")) << what;
  if (!mesh.wedges.empty()) {
    EXPECT_EQ(n_wedges(mesh), std::set<Index>(mesh.wedges.begin(), mesh.wedges.end()).size()) << what;
  }
  for (const auto& n : mesh.normals) {
    const double length = std::hypot(double{n[0]}, double{n[1]}, double{n[2]});
    ASSERT_TRUE(length == 0 || std::abs(length - 1) < 2e-4) << what << ": normal of length " << length;
  }
  for (const Color& color : mesh.colors) {
    for (const float c : color) ASSERT_TRUE(c >= 0 && c <= 1) << what << ": colour component " << c;
  }
  ASSERT_EQ(mesh.origins.size(), vertices) << what;
  for (std::size_t v = 0; v < vertices; ++v) {
    ASSERT_LT(mesh.origins[v], result.file_vertices) << what;
    ASSERT_TRUE(v == 0 || mesh.origins[v - 1] < mesh.origins[v]) << what << ": origins don't ascend";
  }
}

/// Concatenates all parts.
template <class... Parts>
std::string cat(const Parts&... parts) {
  std::string all;
  ((all += parts), ...);
  return all;
}

/// The bytes of a number in the given byte order.
template <class Number>
std::string bytes_of(Number value, std::endian order = std::endian::little) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::string(bytes.begin(), bytes.end());
}

template <class... Numbers>
std::string all_bytes_of(std::endian order, Numbers... values) {
  return (bytes_of(values, order) + ...);
}

}  // namespace whittle::io::test
