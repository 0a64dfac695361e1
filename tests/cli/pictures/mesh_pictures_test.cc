// `report --png`, `--frames` and `--animate`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "program/stand_in_programs.hh"
#include "support/temporary_folder.hh"
#include "whittle/render/pixels.hh"

namespace whittle::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using Color = std::array<int, 3>;

constexpr Color ground{0xF4, 0xF4, 0xF1};

Color color_at(const render::Pixels& picture, std::size_t x, std::size_t y) {
  const std::uint8_t* const pixel = &picture.rgba[4 * (y * picture.width + x)];
  return {pixel[0], pixel[1], pixel[2]};
}

/// The share of a part of a picture's columns that isn't background.
double covered(const render::Pixels& picture, std::size_t begin, std::size_t end) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = begin; x < end; ++x) n += color_at(picture, x, y) == ground ? 0 : 1;
  }
  return static_cast<double>(n) / static_cast<double>(picture.height * (end - begin));
}

double covered(const render::Pixels& picture) { return covered(picture, 0, picture.width); }

/// Whether a colour occurs at least so often.
bool has_color(const render::Pixels& picture, const std::function<bool(const Color&)>& is_it, std::size_t least = 50) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) n += is_it(color_at(picture, x, y)) ? 1 : 0;
  }
  return n >= least;
}

/// A mesh, a result, and the run between them; on a machine that can draw.
class MeshPictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_page(folder)) GTEST_SKIP() << "this program was built without the page";
    if (!has_pictures(folder)) GTEST_SKIP() << "nothing can be drawn";
    const Outcome made = whittle({"simplify", data_file("blob.obj"), "-o", mesh, "--faces", "1200", "--quiet"});
    ASSERT_EQ(made.exit_code, 0) << made;
    const Outcome run =
        whittle({"simplify", mesh, "-o", small, "--faces", "200", "--record", folder / "run.rec", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run;
  }

  /// The PNG file that `report` draws of some files.
  std::string drawn(std::vector<std::string> words, const std::string& view = "plain") const {
    const std::string file = folder / "picture.png";
    words.insert(words.begin(), "report");
    words.insert(words.end(), {"--png", file, "--png-size", "320x200", "--view", view, "--quiet"});
    const Outcome outcome = whittle(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return read_text(file);
  }
  render::Pixels picture(const std::vector<std::string>& words, const std::string& view = "plain") const {
    return render::read_image(drawn(words, view));
  }

  const TemporaryFolder folder;
  const std::string mesh = folder / "mesh.ply";  // of few faces, which are measured in little time
  const std::string small = folder / "small.ply";
};

TEST_F(MeshPictures, HaveTheSizeAskedFor) {
  const render::Pixels shown = picture({mesh, small});
  EXPECT_EQ(shown.width, 320U);
  EXPECT_EQ(shown.height, 200U);
  const Outcome outcome = whittle({"report", mesh, "--png", folder / "usual.png", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["png"], folder / "usual.png");
  const render::Pixels usual = render::read_image(read_text(folder / "usual.png"));
  EXPECT_EQ(usual.width, 1280U);
  EXPECT_EQ(usual.height, 720U);
}

TEST_F(MeshPictures, ShowTheOriginalBesideTheResult) {
  const render::Pixels shown = picture({mesh, small});
  EXPECT_EQ(color_at(shown, 0, 0), ground);
  EXPECT_GT(covered(shown, 0, 160), 0.15);
  EXPECT_GT(covered(shown, 160, 320), 0.15);
  EXPECT_LT(covered(shown), 0.9);
  std::size_t n_different = 0;
  for (std::size_t y = 0; y < 200; ++y) {
    for (std::size_t x = 0; x < 160; ++x) n_different += color_at(shown, x, y) == color_at(shown, x + 160, y) ? 0 : 1;
  }
  EXPECT_GT(n_different, 3000U);
}

TEST_F(MeshPictures, AreTheSameBytesForAnyThreadsAndWithoutPrograms) {
  const std::string once = drawn({mesh, small}, "colour=error");
  const StandInPrograms programs(folder);
  std::filesystem::remove_all(folder / "bin");
  EXPECT_EQ(drawn({mesh, small, "--threads", "1"}, "colour=error"), once);
}

TEST_F(MeshPictures, ShowEachViewInItsOwnWay) {
  std::set<std::string> pictures;
  const std::vector<std::string> views{"layout=beside",
                                       "layout=over",
                                       "layout=over,ghost=edges",
                                       "layout=over,ghost=points",
                                       "layout=original",
                                       "layout=result",
                                       "colour=error",
                                       "colour=error,layout=over",
                                       "colour=error,top=1",
                                       "colour=shape",
                                       "colour=valence",
                                       "shading=smooth",
                                       "shading=smooth,colour=shape",
                                       "edges=on",
                                       "up=z",
                                       "up=x",
                                       "turn=40",
                                       "tilt=-30",
                                       "zoom=2",
                                       "plain"};
  for (const std::string& view : views) {
    const std::string bytes = drawn({mesh, small}, view);
    EXPECT_GT(covered(render::read_image(bytes)), 0.1) << view;
    EXPECT_TRUE(pictures.insert(bytes).second) << view;
  }
  EXPECT_EQ(drawn({small}, "edges=off,turn=0"), drawn({small}, "layout=beside"));
}

TEST_F(MeshPictures, NameMeshesUnlessTheyArePlain) {
  const render::Pixels named = picture({mesh, small}, "edges=off");
  const render::Pixels plain = picture({mesh, small}, "plain");
  const auto is_text = [](const Color& color) { return color == Color{0x1C, 0x1C, 0x1A}; };
  EXPECT_TRUE(has_color(named, is_text, 300));
  EXPECT_FALSE(has_color(plain, is_text, 1));
}

/// Errors have the colours of the scale, which the legend shows, too.
TEST_F(MeshPictures, ShowErrorsByTheScale) {
  const auto is_violet = [](const Color& c) { return c[2] > c[1] + 40 && c[0] > c[1]; };
  const auto is_yellow = [](const Color& c) { return c[0] > 120 && c[1] > 120 && c[2] < 60; };
  const render::Pixels shown = picture({mesh, small}, "colour=error,plain");
  EXPECT_TRUE(has_color(shown, is_violet, 500));
  EXPECT_TRUE(has_color(shown, is_yellow));
  const render::Pixels equal = picture({mesh, mesh}, "colour=error,plain");
  EXPECT_TRUE(has_color(equal, is_violet, 5000));
}

/// Borders are orange, edges of three faces red, backs brown. Lines are narrower than a pixel.
TEST_F(MeshPictures, ShowDefects) {
  const std::string terrain = data_file("terrain.ply");
  const auto is_orange = [](const Color& c) { return c[0] > c[1] + 40 && c[1] > c[2] + 20; };
  EXPECT_TRUE(has_color(picture({terrain}, "plain,colour=none"), is_orange, 100));
  EXPECT_FALSE(has_color(picture({terrain}, "plain,colour=none,borders=off"), is_orange, 1));
  const auto is_red = [](const Color& c) { return c[0] > c[1] + 40 && c[2] > c[1] + 20; };
  const std::string nonmanifold = data_file("nonmanifold.obj");
  EXPECT_TRUE(has_color(picture({nonmanifold}, "plain"), is_red, 1));
  EXPECT_FALSE(has_color(picture({nonmanifold}, "plain,nonmanifold=off"), is_red, 1));
  const auto is_brown = [](const Color& c) { return c[0] > c[1] + 20 && c[1] > c[2] && c[0] < 150; };
  EXPECT_TRUE(has_color(picture({terrain}, "plain,colour=none,turn=180"), is_brown, 5000));
}

/// A red PLY, and a glTF file with charts.
TEST_F(MeshPictures, ShowColoursAndTextures) {
  write_text(folder / "red.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
  const auto is_red = [](const Color& c) { return c[0] > 150 && c[1] < 20 && c[2] < 20; };
  EXPECT_TRUE(has_color(picture({folder / "red.obj"}), is_red, 1000));
  EXPECT_FALSE(has_color(picture({folder / "red.obj"}, "colour=none,borders=off,plain"), is_red));
  const std::string cube = folder / "cube.glb";
  write_gltf_cube(cube, 4);
  ASSERT_EQ(whittle({"simplify", cube, "-o", folder / "small.glb", "--face-ratio", "30%", "--quiet"}).exit_code, 0);
  std::set<std::string> pictures;
  for (const char* const colour : {"none", "material", "normals", "texcoord", "normal", "error"}) {
    const std::string bytes = drawn({cube, folder / "small.glb"}, "plain,colour=" + std::string(colour));
    EXPECT_GT(covered(render::read_image(bytes)), 0.1) << colour;
    EXPECT_TRUE(pictures.insert(bytes).second) << colour;
  }
}

/// Four by four red pixels.
TEST_F(MeshPictures, ShowTexturesInWebp) {
  const unsigned char image[] = {0x52, 0x49, 0x46, 0x46, 0x1c, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50,
                                 0x56, 0x50, 0x38, 0x4c, 0x0f, 0x00, 0x00, 0x00, 0x2f, 0x03, 0xc0, 0x00,
                                 0x00, 0x07, 0x10, 0xfd, 0x8f, 0xfe, 0x07, 0x22, 0xa2, 0xff, 0x01, 0x00};
  write_text(folder / "a.webp", {reinterpret_cast<const char*>(image), sizeof image});
  write_text(folder / "a.mtl", "newmtl a\nmap_Kd a.webp\n");
  write_text(folder / "a.obj",
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n");
  const auto is_red = [](const Color& c) { return c[0] > 150 && c[1] < 20 && c[2] < 20; };
  EXPECT_TRUE(has_color(picture({folder / "a.obj"}), is_red, 1000));
  write_text(folder / "a.webp", std::string(reinterpret_cast<const char*>(image), 20));  // the page can't say it
  const Outcome damaged = whittle({"report", folder / "a.obj", "--png", folder / "a.png"});
  EXPECT_EQ(damaged.exit_code, 0) << damaged;
  EXPECT_THAT(damaged.err, HasSubstr("texture a.webp is not drawn"));
}

TEST_F(MeshPictures, ShowTheLevelOfARecording) {
  const auto is_some = [&](const std::string& view) {
    return drawn({folder / "run.rec"}, "plain,layout=result,edges=on," + view);
  };
  const std::string first = is_some("level=0");
  const std::string middle = is_some("level=0.9");
  EXPECT_NE(middle, first);
  EXPECT_NE(is_some("level=1"), middle);
  EXPECT_NE(is_some("level=0.9,spacing=faces"), middle);
  EXPECT_NE(is_some("level=0.9955,movement=continuous"), is_some("level=0.9955"));
  EXPECT_EQ(is_some("level=1"), is_some("level=1,result=0"));
}

std::size_t n_of(const std::string& word, const std::string& bytes) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = bytes.find(word, at)) != std::string::npos; ++at) ++n;
  return n;
}

TEST_F(MeshPictures, ShowARecordingOnItsWay) {
  const Outcome outcome = whittle({"report", folder / "run.rec", "--frames", folder / "f_{i}.png", "--every", "30%",
                                   "--animate", folder / "run.webp", "--png-size", "400x300"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  std::set<std::string> pictures;
  for (int i = 0; i < 5; ++i) {
    const std::string bytes = read_text(folder / ("f_" + std::to_string(i) + ".png"));
    const render::Pixels frame = render::read_image(bytes);
    EXPECT_EQ(frame.width, 400U);
    EXPECT_EQ(frame.height, 300U);
    EXPECT_GT(covered(frame), 0.2);
    EXPECT_TRUE(pictures.insert(bytes).second) << i;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "f_5.png"));
  const std::string animation = read_text(folder / "run.webp");
  EXPECT_THAT(animation, StartsWith("RIFF"));
  EXPECT_EQ(n_of("ANMF", animation), 5U);
}

TEST_F(MeshPictures, ShowARunOfSimplify) {
  const std::string cube = folder / "cube.glb";
  write_gltf_cube(cube, 6);
  for (const auto& [input, out] : {std::pair(mesh, folder / "out.ply"), std::pair(cube, folder / "out.glb")}) {
    const Outcome outcome =
        whittle({"simplify", input, "-o", out, "--face-ratio", "20%", "--frames", folder / "s{i}.png", "--every", "50%",
                 "--animate", folder / "s.webp", "--json", folder / "s.json", "--force"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(parse_json(read_text(folder / "s.json"))["warnings"], IsEmpty()) << outcome;
    const std::string first = read_text(folder / "s0.png");
    const std::string last = read_text(folder / "s2.png");
    EXPECT_NE(first, last);
    EXPECT_EQ(render::read_image(last).width, 1280U);
    EXPECT_EQ(n_of("ANMF", read_text(folder / "s.webp")), 3U);
  }
}

/// The run stands still where its result fills a pipe.
TEST_F(MeshPictures, AreThereWhileARunGoesOnAndGoWithOneThatIsInterrupted) {
  write_text(folder / "w2.png", "of before");
  Running program(command({"simplify", data_file("knot.ply"), "-o", "-", "--format", "ply", "--face-ratio", "50%",
                           "--frames", folder / "w{i}.png", "--every", "50%", "--animate", folder / "w.webp",
                           "--record", folder / "w.rec", "--quiet"}));
  const auto are_there = [this] {
    return std::filesystem::exists(folder / "w0.png") && std::filesystem::exists(folder / "w.webp");
  };
  for (int i = 0; i < 6000 && !are_there(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(are_there());
  program.signal(SIGTERM);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exit_code, 128 + SIGTERM) << outcome;
  EXPECT_FALSE(std::filesystem::exists(folder / "w0.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "w.webp"));
  EXPECT_EQ(read_text(folder / "w2.png"), "of before");
}

/// Nothing is left of a run whose pictures can't be written.
TEST_F(MeshPictures, AreAllWrittenOrNone) {
  const std::string out = folder / "out.ply";
  const Outcome outcome = whittle({"simplify", mesh, "-o", out, "--faces", "150", "--frames", folder / "no/f{i}.png"});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("no"));
  EXPECT_FALSE(std::filesystem::exists(out));
  expect_usage_error(whittle({"simplify", mesh, "-o", out, "--faces", "150", "--frames", folder / "f.png"}),
                     {"--frames", "{i}"});
  expect_usage_error(whittle({"simplify", mesh, "-o", out, "--faces", "150", "--animate", folder / "f.gif"}),
                     {"--animate", ".webp"});
  expect_usage_error(whittle({"report", mesh, "--frames", folder / "f{i}.png"}), {"--frames", "recording"});
  expect_usage_error(whittle({"report", mesh, "--png", folder / "p.png", "--png-size", "10x10"}), {"--png-size"});
}

/// One that is a point, as the original and as a result, and one that is flat.
TEST_F(MeshPictures, AreDrawnOfMeshesWithoutAnExtent) {
  const std::string point = folder / "point.obj";
  write_text(point, "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(covered(picture({point, "--no-weld"})), 0);
  EXPECT_GT(covered(picture({mesh, point, "--no-weld"})), 0.05);
  EXPECT_GT(covered(picture({data_file("flat.off")}, "plain,up=z")), 0.01);
  write_text(folder / "empty.obj", "v 1 2 3\n");
  const Outcome empty = whittle({"report", folder / "empty.obj", "--png", folder / "empty.png"});
  EXPECT_EQ(empty.exit_code, 4) << empty;
  EXPECT_FALSE(std::filesystem::exists(folder / "empty.png"));
}

}  // namespace
}  // namespace whittle::test
