// How meshes are read and written, whatever the subcommand.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

IndexedMesh unwelded(const std::string& path) { return io::read_mesh(path, {.weld = false}).mesh; }

TEST(Ascii, WritesTextThatReadsBackAsTheSameNumbers) {
  const TemporaryFolder folder;
  for (const std::string extension : {"ply", "stl"}) {
    const std::string binary = folder / ("binary." + extension);
    const std::string text = folder / ("text." + extension);
    std::vector<std::string> arguments{"simplify", data_file("blob.obj"), "--faces", "500", "-o", binary};
    ASSERT_EQ(whittle(arguments).exit_code, 0);
    arguments.back() = text;
    arguments.emplace_back("--ascii");
    const Outcome outcome = whittle(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << "text loses nothing\n" << outcome;
    const std::string content = read_text(text);
    EXPECT_TRUE(content.starts_with(extension == "ply" ? "ply\nformat ascii 1.0\n" : "solid "))
        << content.substr(0, 40);
    const IndexedMesh mesh = unwelded(text);
    EXPECT_EQ(mesh.faces, unwelded(binary).faces);
    const IndexedMesh expected = unwelded(binary);
    ASSERT_EQ(mesh.positions.size(), expected.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const bool is_same = extension == "ply" ? mesh.positions[v] == expected.positions[v]
                                              : mesh.positions[v].cast<float>() == expected.positions[v].cast<float>();
      EXPECT_TRUE(is_same) << extension << ", vertex " << v;
    }
  }
}

TEST(Ascii, IsTakenByPolishToo) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("blob.obj");
  const Outcome outcome = whittle({"polish", mesh, mesh, "-o", folder / "out.ply", "--ascii", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["options"]["ascii"], true);
  EXPECT_TRUE(read_text(folder / "out.ply").starts_with("ply\nformat ascii"));
}

TEST(Ascii, IsRefusedWhereThereIsNoChoice) {
  const TemporaryFolder folder;
  for (const io::Format format : io::all_formats) {
    if (io::has_text_and_binary(format)) continue;
    const std::string out = folder / ("out." + std::string(io::name_of(format)));
    expect_usage_error(whittle({"simplify", data_file("blob.obj"), "--faces", "500", "-o", out, "--ascii"}),
                       {"--ascii is for PLY or STL", std::string(io::title_of(format)) + " is always"});
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(Gzip, GoesInAndOut) {
  const TemporaryFolder folder;
  const std::string packed = folder / "out.ply.gz";
  std::vector<std::string> arguments{"simplify", data_file("blob.obj"), "--faces", "500", "-o", folder / "out.ply"};
  ASSERT_EQ(whittle(arguments).exit_code, 0);
  arguments.back() = packed;
  const Outcome outcome = whittle(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(run({"gzip", "-dc", packed}).out, read_text(folder / "out.ply"));
  EXPECT_EQ(run({"gzip", "-t", packed}).exit_code, 0);

  const Outcome info = whittle({"info", packed, "--json", "-"});
  EXPECT_EQ(parse_json(info.out)["faces"], 500) << info;
  RunOptions options;
  options.input = read_text(packed);
  EXPECT_EQ(parse_json(whittle({"info", "-", "--format", "ply", "--json", "-"}, options).out)["faces"], 500);
}

TEST(Gzip, ThatIsDamagedIsUnreadable) {
  const TemporaryFolder folder;
  ASSERT_EQ(whittle({"simplify", data_file("blob.obj"), "--faces", "500", "-o", folder / "in.ply.gz"}).exit_code, 0);
  const std::string whole = read_text(folder / "in.ply.gz");
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
  for (const std::string& bytes : {whole.substr(0, whole.size() / 2), flipped, whole + "more"}) {
    write_text(folder / "in.ply.gz", bytes);
    const Outcome outcome = whittle({"simplify", folder / "in.ply.gz", "--faces", "100", "-o", folder / "out.ply"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome;
    EXPECT_NE(outcome.err.find("in.ply.gz: the "), std::string::npos) << outcome;
    EXPECT_NE(outcome.err.find("gzip data"), std::string::npos) << outcome;
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"in.ply.gz"});
}

TEST(InputFormat, AndOutputFormatAreApart) {
  RunOptions options;
  options.input = read_text(data_file("blob.obj"));
  const Outcome outcome = whittle(
      {"simplify", "-", "-o", "-", "--input-format", "obj", "--output-format", "stl", "--faces", "500"}, options);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(io::read_mesh(outcome.out, "a.stl").mesh.faces.size(), 500U);
  // --format is for the side that has none of its own.
  for (const std::string side : {"--input-format", "--output-format"}) {
    const std::string other = side == "--input-format" ? "off" : "obj";
    const std::string own = side == "--input-format" ? "obj" : "off";
    const Outcome mixed =
        whittle({"simplify", "-", "-o", "-", side, own, "--format", other, "--faces", "500"}, options);
    ASSERT_EQ(mixed.exit_code, 0) << mixed.err;
    EXPECT_EQ(mixed.out.substr(0, 4), "OFF\n") << side;
  }
}

TEST(InputFormat, OverrulesTheName) {
  const TemporaryFolder folder;
  write_text(folder / "in.off", read_text(data_file("blob.obj")));
  EXPECT_EQ(whittle({"info", folder / "in.off"}).exit_code, 4);
  EXPECT_EQ(whittle({"info", folder / "in.off", "--input-format", "obj"}).exit_code, 0);
  const std::string mesh = folder / "in.off";
  EXPECT_EQ(whittle({"measure", mesh, mesh, "--input-format", "obj"}).exit_code, 0);
  EXPECT_EQ(whittle({"compare", mesh, "--faces", "500", "--input-format", "obj"}).exit_code, 0);
  const Outcome outcome =
      whittle({"polish", mesh, mesh, "-o", folder / "out.obj", "--input-format", "obj", "--output-format", "ply"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_TRUE(read_text(folder / "out.obj").starts_with("ply\n"));
}

TEST(InputFormat, MayBeGltf) {
  const TemporaryFolder folder;
  const std::string cube = data_file("cubes.obj");
  ASSERT_EQ(whittle({"convert", cube, folder / "a.glb"}).exit_code, 0);
  write_text(folder / "a.ply", read_text(folder / "a.glb"));
  write_text(folder / "a.b3dm_content", read_text(folder / "a.glb"));
  const Outcome named = whittle({"info", folder / "a.ply"});
  EXPECT_EQ(named.exit_code, 4) << named;
  EXPECT_NE(named.err.find("the content is binary glTF; rename it to .glb, or give --input-format glb"),
            std::string::npos)
      << named;
  for (const char* format : {"glb", "gltf"}) {
    for (const char* file : {"a.ply", "a.b3dm_content"}) {
      const Outcome read = whittle({"convert", folder / file, folder / "b.obj", "--input-format", format});
      EXPECT_EQ(read.exit_code, 0) << read;
      EXPECT_EQ(io::read_mesh(folder / "b.obj").mesh.faces.size(), io::read_mesh(cube).mesh.faces.size());
    }
  }
  expect_usage_error(whittle({"info", "-", "--input-format", "glb"}), {"glTF isn't read from standard input"});
}

TEST(InputFormat, IsAdvisedWhereAnotherWasGivenAgainstTheName) {
  const Outcome wrong = whittle({"info", data_file("knot.ply"), "--input-format", "off"});
  EXPECT_EQ(wrong.exit_code, 4) << wrong;
  EXPECT_NE(wrong.err.find("the content is ply, not off; give --input-format ply\n"), std::string::npos) << wrong;
  EXPECT_EQ(whittle({"info", data_file("knot.ply"), "--input-format", "ply"}).exit_code, 0);
}

TEST(Format, IsRefusedWhereNothingIsLeftForIt) {
  const TemporaryFolder folder;
  const std::vector<std::string> both{
      "simplify",        "-",   "-o",       "-",  "--faces", "500", "--input-format", "obj",
      "--output-format", "ply", "--format", "obj"};
  expect_usage_error(whittle(both), {"--format", "another option"});
  expect_usage_error(whittle({"simplify", "-", "-o", folder / "a.obj", "--faces", "500"}), {"'-'", "--input-format"});
  expect_usage_error(whittle({"simplify", data_file("blob.obj"), "-o", "-", "--faces", "500"}),
                     {"'-'", "--output-format"});
}

}  // namespace
}  // namespace whittle::test
