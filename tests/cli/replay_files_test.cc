// The last level of a recording is the file of its run, byte for byte, with all that a file says beside its mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

constexpr int n_squares = 12;

/// Waves over a square. \param numbers_of x, y, z → the numbers of a vertex
template <class NumbersOf>
std::string vertex_rows(const NumbersOf& numbers_of) {
  std::string text;
  for (int j = 0; j <= n_squares; ++j) {
    for (int i = 0; i <= n_squares; ++i) text += numbers_of(i, j, 3 * std::sin(i) * std::cos(2 * j)) + '\n';
  }
  return text;
}

/// \param row_of face number and corners → the row of a face
template <class RowOf>
std::string face_rows(const RowOf& row_of) {
  std::string text;
  int face = 0;
  for (int j = 0; j < n_squares; ++j) {
    for (int i = 0; i < n_squares; ++i) {
      const int corner = j * (n_squares + 1) + i;
      text += row_of(face++, corner, corner + 1, corner + n_squares + 2);
      text += row_of(face++, corner, corner + n_squares + 2, corner + n_squares + 1);
    }
  }
  return text;
}

std::string spaced(int a, int b, int c) {
  return std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c);
}

/// \param tags of each third of the faces \param x, z where it begins
std::string obj_of(const std::string& head, const Arguments& tags, int x = 0, int z = 0) {
  const auto vertex = [x, z](int i, int j, double height) {
    return "v " + std::to_string(x + i) + ' ' + std::to_string(j) + ' ' + std::to_string(z + height) + "\nvt " +
           std::to_string(i) + ' ' + std::to_string(j);
  };
  const auto face = [&tags](int number, int a, int b, int c) {
    constexpr int n_faces = 2 * n_squares * n_squares;
    const bool is_first = number % (n_faces / 3) == 0;
    const auto corner = [](int v) { return ' ' + std::to_string(v + 1) + '/' + std::to_string(v + 1); };
    return (is_first ? tags[static_cast<std::size_t>(3 * number / n_faces)] : "") + 'f' + corner(a) + corner(b) +
           corner(c) + '\n';
  };
  return head + vertex_rows(vertex) + face_rows(face);
}

/// Properties in an order of their own, colours of 16 bits, opaque, and labels with names.
std::string labelled_ply() {
  const auto vertex = [](int i, int j, double z) {
    return std::to_string(i) + ' ' + spaced(1000 * i, 1000 * j, 7) + " 65535 " + std::to_string(i) + ' ' +
           std::to_string(j) + ' ' + std::to_string(z);
  };
  const auto face = [](int number, int a, int b, int c) {
    return std::to_string(number / 100) + " 3 " + spaced(a, b, c) + '\n';
  };
  return "ply\nformat ascii 1.0\ncomment TextureFile wall.png\ncomment name label 0 roof\ncomment name label 1 wall\n"
         "comment name label 2 floor\nelement vertex " +
         std::to_string((n_squares + 1) * (n_squares + 1)) +
         "\nproperty float quality\nproperty ushort red\nproperty ushort green\nproperty ushort blue\n"
         "property ushort alpha\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(2 * n_squares * n_squares) +
         "\nproperty int label\nproperty list uchar int vertex_index\nend_header\n" + vertex_rows(vertex) +
         face_rows(face);
}

class ReplayFiles : public testing::Test {
 protected:
  ReplayFiles() {
    options_.folder = folder_.path();
    fs::create_directory(folder_ / "run");
    fs::create_directory(folder_ / "again");
    write("groups.obj", obj_of("", {"g roof\n", "g west wall\n", "g\n"}));
    write("all.obj", obj_of("", {"o house\ng roof\ns 1\n", "g wall a\ns 7\n", "o shed\ng wall b\ns off\n"}));
    write("one.obj", obj_of("o house\ng roof\ns 4\n", {"", "", ""}));
    write("wall.mtl", "newmtl red\nKd 1 0 0\nnewmtl bricks\nmap_Kd wall.png\n");
    write("wall.png", "\x89PNG\r\n\x1A\n an image");
    write("materials.obj", obj_of("mtllib wall.mtl\n", {"g a\nusemtl red\n", "g b\n", "g c\nusemtl bricks\n"}));
    write("labels.ply", labelled_ply());
  }

  void write(const std::string& name, const std::string& text) { write_text(folder_ / name, text); }
  Outcome run(const Arguments& arguments) {
    Outcome outcome = whittle(arguments, options_);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return outcome;
  }
  /// Records a run beside its input and replays it to its end. \param inputs with options
  void expect_same_end(Arguments inputs, const std::string& extension, const Arguments& recording = {},
                       const Arguments& replaying = {}) {
    const std::string out = "run/out" + extension;
    const std::string again = "again/out" + extension;
    Arguments simplify{"simplify", "-o", out, "--ratio", "40%", "--record", "rec", "-q"};
    simplify.insert(simplify.begin() + 1, inputs.begin(), inputs.end());
    simplify.insert(simplify.end(), recording.begin(), recording.end());
    Arguments replay{"replay", "rec", "--at", "1", "-o", again, "-q"};
    replay.insert(replay.end(), replaying.begin(), replaying.end());
    run(simplify);
    run(replay);
    EXPECT_TRUE(read_text(folder_ / out) == read_text(folder_ / again))
        << testing::PrintToString(inputs) << " as " << extension << testing::PrintToString(replaying);
  }

  TemporaryFolder folder_;
  RunOptions options_;
};

TEST_F(ReplayFiles, EndWithTheFileOfTheRun) {
  for (const std::string in : {"groups.obj", "all.obj", "one.obj", "materials.obj", "labels.ply"}) {
    for (const std::string extension : {".off", ".stl", ".gltf"}) expect_same_end({in}, extension);
    for (const std::string extension : {".obj", ".ply", ".glb"}) {
      expect_same_end({in}, extension);
      expect_same_end({in}, extension, {"--zstd", "--attributes", "position-only"});
      expect_same_end({in}, extension, {}, {"--input", in});
      expect_same_end({in}, extension, {"--no-embed"}, {"--input", in});
      expect_same_end({in}, extension, {"--no-embed", "--attributes", "position-only"}, {"--input", in});
    }
  }
}

TEST_F(ReplayFiles, EndWithTheFileOfJoinedFiles) {
  write("b.obj", obj_of("", {"g roof\n", "g b\n", "g c\n"}, 20));
  write("b_materials.obj", obj_of("mtllib wall.mtl\n", {"usemtl red\n", "usemtl bricks\n", ""}, 20));
  for (const std::string extension : {".obj", ".ply", ".glb"}) {
    expect_same_end({"groups.obj", "b.obj", "--join"}, extension);
    expect_same_end({"all.obj", "b.obj", "--join"}, extension);
    expect_same_end({"materials.obj", "b_materials.obj", "--join"}, extension);
    expect_same_end({"materials.obj", "b.obj", "--join"}, extension);
  }
  expect_same_end({"groups.obj", "b.obj", "--join"}, ".obj");
  const std::string text = read_text(folder_ / "again/out.obj");
  for (const std::string tag : {"\no groups\n", "\no b\n", "\ng west wall\n", "\ng c\n"}) {
    EXPECT_THAT(text, testing::HasSubstr(tag));
  }
}

TEST_F(ReplayFiles, EndWithTheFileOfGltf) {
  write_gltf_cube(folder_ / "cube.glb", 8);
  for (const std::string extension : {".obj", ".ply"}) expect_same_end({"cube.glb"}, extension);
  for (const std::string extension : {".obj", ".ply", ".glb"}) {
    expect_same_end({"cube.glb"}, extension, {}, {"--input", "cube.glb"});
    expect_same_end({"cube.glb"}, extension, {"--no-embed"}, {"--input", "cube.glb"});
    expect_same_end({"cube.glb"}, extension, {"--attributes", "position-only"}, {"--input", "cube.glb"});
  }
}

/// Each level of a mesh far from the origin counts from the same place.
TEST_F(ReplayFiles, HaveTheOriginOfTheInputInGltf) {
  write("far.obj", obj_of("", {"g a\n", "g b\n", "g c\n"}, 0, 3'000'001));
  expect_same_end({"far.obj"}, ".gltf");
  expect_same_end({"far.obj"}, ".gltf", {}, {"--input", "far.obj"});
}

TEST_F(ReplayFiles, RefuseNotesThatCannotBe) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}};
  mesh.origins = {0, 1, 2};
  const auto replay = [&](const progressive::RecordingNotes& notes) {
    std::ostringstream recording;
    progressive::write_recording(recording, mesh, {}, Normals::keep, "", {.notes = notes});
    write("rec", recording.str());
    return whittle({"replay", "rec", "--at", "1", "-o", "out.obj"}, options_);
  };
  EXPECT_EQ(replay({{"of a later version", {"a"}}}).exit_code, 0);
  EXPECT_EQ(replay({{"face_names g", {"a\nf 1 2 3"}}}).exit_code, 0);
  EXPECT_THAT(read_text(folder_ / "out.obj"), testing::HasSubstr("\ng a f 1 2 3\n"));
  expect_failure(replay({{"color_type", {"int7"}}}), 4, {"rec: it is damaged: an unknown type of colours"});
}

TEST_F(ReplayFiles, HaveTheirMaterialsBesideTheRecording) {
  run({"simplify", "materials.obj", "-o", "run/out.obj", "--ratio", "40%", "--record", "run/rec"});
  run({"replay", "run/rec", "--at", "0.5", "-o", "again/out.obj"});
  EXPECT_EQ(read_text(folder_ / "again/wall.mtl"), read_text(folder_ / "wall.mtl"));
  EXPECT_EQ(read_text(folder_ / "again/wall.png"), read_text(folder_ / "wall.png"));

  fs::create_directory(folder_ / "alone");
  fs::rename(folder_ / "run/rec", folder_ / "alone/rec");
  const Outcome there = run({"replay", "alone/rec", "--at", "1", "-o", "again/out.obj"});
  EXPECT_EQ(there.err.find("warning"), std::string::npos) << "it has its material library\n" << there;
  fs::create_directory(folder_ / "far");
  const Outcome missing = run({"replay", "alone/rec", "--at", "1", "-o", "far/out.obj"});
  EXPECT_THAT(missing.err, testing::HasSubstr("far/out.obj: needs files that were not copied: wall.mtl (not there)"));
  EXPECT_TRUE(read_text(folder_ / "far/out.obj") == read_text(folder_ / "run/out.obj"));
}

}  // namespace
}  // namespace whittle::test
