// What is read, written and read again is the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "attribute_tools.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"

namespace whittle::io {
namespace {

using test::expect_same_mesh;
using test::expect_same_notes;
using test::read;
using test::warnings_of;
using test::written;
using whittle::test::Random;

ReadResult read_back(const ReadResult& result, Format format, bool ascii) {
  return read(written(result.mesh, format, {.ascii = ascii, .notes = result.notes}),
              "again." + std::string(name_of(format)));
}

void expect_round_trips(const ReadResult& result, Format format, const std::string& what) {
  const ReadResult back = read_back(result, format, false);
  expect_same_mesh(back.mesh, result.mesh, what);
  expect_same_notes(back.notes, result.notes, what);
  const ReadResult text = read_back(result, format, true);
  expect_same_mesh(text.mesh, result.mesh, what + " as text");
  EXPECT_EQ(back.warnings, std::vector<std::string>{}) << what;
}

TEST(AttributeRoundTrip, KeepsPlyAssets) {
  WHITTLE_ASSETS_OR_SKIP(files, "ply", ".ply");
  for (const std::filesystem::path& file : files) {
    const ReadResult result = read_mesh(file);
    test::expect_valid(result, file.string());
    EXPECT_TRUE(result.warnings.empty()) << file << ": " << result.warnings.front();
    expect_round_trips(result, Format::ply, file.string());
  }
  EXPECT_EQ(files.size(), 7U);
}

TEST(AttributeRoundTrip, KeepsObjAssets) {
  WHITTLE_ASSETS_OR_SKIP(files, "obj", ".obj");
  std::size_t n_refused = 0;
  for (const std::filesystem::path& file : files) {
    try {
      const ReadResult result = read_mesh(file);
      test::expect_valid(result, file.string());
      EXPECT_TRUE(result.warnings.empty()) << file << ": " << result.warnings.front();
      // One has an object and materials whose faces are all duplicates: only their names are left.
      const bool has_unused_names = result.repairs.duplicate_faces > 0;
      EXPECT_EQ(has_unused_names, file.filename() == "box-mixed-attributes-2.obj") << file;
      expect_round_trips(has_unused_names ? read_back(result, Format::obj, false) : result, Format::obj, file.string());
    } catch (const ReadError& error) {
      EXPECT_EQ(file.filename(), "issue-140-zero-face-idx.obj") << error.what();
      ++n_refused;
    }
  }
  EXPECT_EQ(n_refused, 1U);
}

TEST(AttributeRoundTrip, KeepsObjAssetsThroughPly) {
  WHITTLE_ASSETS_OR_SKIP(files, "obj", ".obj");
  for (const std::filesystem::path& file : files) {
    if (file.filename() == "issue-140-zero-face-idx.obj") continue;
    const ReadResult result = read_mesh(file);
    const ReadResult ply =
        read(written(result.mesh, Format::ply, {.exact_colors = true, .notes = result.notes}), "a.ply");
    EXPECT_EQ(ply.mesh.face_groups, result.mesh.face_groups) << file;
    EXPECT_EQ(ply.mesh.group_names, result.mesh.group_names) << file;
    EXPECT_EQ(ply.notes.face_names, result.notes.face_names) << file;
    EXPECT_EQ(ply.notes.material_libraries, result.notes.material_libraries) << file;
    ASSERT_EQ(ply.mesh.faces.size(), result.mesh.faces.size()) << file;
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(ply.mesh.positions[ply.mesh.faces[f][c]], result.mesh.positions[result.mesh.faces[f][c]]) << file;
        ASSERT_EQ(test::bits_at_corner(ply.mesh, f, c), test::bits_at_corner(result.mesh, f, c)) << file;
      }
    }
  }
}

TEST(AttributeRoundTrip, KeepsSeams) {
  for (const IndexedMesh& mesh : {test::cube_with_charts(), test::tube_with_seam(16, 6)}) {
    const ReadResult ply = read(written(mesh, Format::ply), "a.ply");
    EXPECT_FALSE(ply.mesh.wedges.empty());
    expect_round_trips(ply, Format::ply, "PLY");
    const ReadResult obj = read(written(ply.mesh, Format::obj), "a.obj");
    EXPECT_EQ(n_wedges(obj.mesh), n_wedges(ply.mesh));
    EXPECT_EQ(seam_edges(obj.mesh), seam_edges(ply.mesh));
    expect_round_trips(obj, Format::obj, "OBJ");
    const ReadResult off = read(written(ply.mesh, Format::off), "a.off");
    expect_round_trips(off, Format::off, "OFF");
    expect_same_mesh(off.mesh, ply.mesh, "PLY to OFF");
  }
}

/// A closed surface with charts of random values, attributes of every type, and categories of faces.
IndexedMesh random_rich_mesh(std::uint64_t seed) {
  Random random(seed);
  const IndexedMesh smooth = whittle::test::blob(2, seed);
  IndexedMesh mesh = whittle::test::soup(smooth);
  const auto chart_of = [](const Vec3& p) { return (p.x() > 0 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0); };
  Attribute texcoords{.name = "u,v", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
  Attribute exact{.name = "exact", .values = {}, .type = ScalarType::float64};
  Attribute label{.name = "label", .kind = AttributeKind::category, .values = {}, .type = ScalarType::int16};
  Attribute part{.name = "part", .kind = AttributeKind::category, .values = {}, .type = ScalarType::uint32};
  for (const Triangle& face : mesh.faces) {
    const Vec3 center = mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]];
    const int chart = chart_of(center);
    for (const Index v : face) {
      const Vec3& p = mesh.positions[v];
      texcoords.values.push_back(double{static_cast<float>(p.x() + 3 * chart)});
      texcoords.values.push_back(double{static_cast<float>(p.z())});
      exact.values.push_back(p.y() / 3);
      label.values.push_back(-chart);
      mesh.colors.push_back({static_cast<float>(chart) / 255, 0, static_cast<float>(chart + 1) / 255, 1});
    }
    part.values.push_back(static_cast<double>(random.below(4'000'000'000)));
  }
  mesh.attributes = {texcoords, exact, label};
  mesh.face_attributes = {part};
  return mesh;
}

TEST(AttributeRoundTrip, KeepsRandomMeshes) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const ReadResult ply = read(written(random_rich_mesh(seed), Format::ply), "a.ply");
    EXPECT_FALSE(ply.mesh.wedges.empty());
    expect_round_trips(ply, Format::ply, "seed " + std::to_string(seed));
    const ReadResult obj = read(written(ply.mesh, Format::obj), "a.obj");
    expect_round_trips(obj, Format::obj, "OBJ of seed " + std::to_string(seed));
  }
}

TEST(AttributeRoundTrip, WarnsOfWhatAFormatHasNoPlaceFor) {
  const IndexedMesh mesh = read(written(random_rich_mesh(1), Format::ply), "a.ply").mesh;
  using Lines = std::vector<std::string>;
  EXPECT_EQ(warnings_of(mesh, Format::ply), Lines{});
  EXPECT_EQ(warnings_of(mesh, Format::obj),
            (Lines{"OBJ can't hold the vertex attributes exact, label: they are left out",
                   "OBJ can't hold the face attribute part: it is left out"}));
  EXPECT_EQ(warnings_of(mesh, Format::off),
            (Lines{"OFF can't hold the vertex attributes exact, label: they are left out",
                   "OFF can't hold the face attribute part: it is left out"}));
  EXPECT_EQ(warnings_of(mesh, Format::stl, {.ascii = true}),
            (Lines{"STL has no vertex colours: they are left out",
                   "STL can't hold the vertex attributes u,v, exact, label: they are left out",
                   "STL can't hold the face attribute part: it is left out"}));
  IndexedMesh grouped = test::cube_with_charts();
  grouped.face_groups.resize(grouped.faces.size());
  grouped.group_names = {"paint"};
  FileNotes notes;
  notes.material_libraries = {"a.mtl"};
  EXPECT_EQ(warnings_of(grouped, Format::off, {.notes = notes}),
            (Lines{"OFF has no materials: they are left out", "OFF can't name textures: they are left out"}));
  notes = {};
  notes.header_lines = {"comment TextureFile a.png"};
  EXPECT_EQ(warnings_of(grouped, Format::obj, {.notes = notes}),
            Lines{"OBJ names textures in a material library: those of the file are left out"});
}

}  // namespace
}  // namespace whittle::io
