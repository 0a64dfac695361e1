// What the program does with a file, the library does with a call, to the byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/pieces.hh"
#include "whittle/engine/cost_traits.hh"
#include "whittle/io/write.hh"
#include "whittle/pipeline/simplify_file.hh"

namespace whittle::test {
namespace {

/// A run: the file that is simplified, the extension of the result, and the options.
struct Run {
  std::string input;
  std::string extension;
  std::string options;
};

/// "--faces 100 --certify" as arguments.
std::vector<std::string> arguments_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The options of the program that say how files are read and written.
void set_file_option(const std::string& name, Request& request) {
  if (name == "--no-weld") request.reading.weld = false;
  if (name == "--ascii") request.output.ascii = true;
  if (name == "--compress") request.output.gltf.compress = true;
  if (name == "--quantize") request.output.gltf.quantize = true;
}

Request request_of(const std::string& options) {
  Request request;
  OptionRows rows = option_rows(request);
  const std::vector<std::string> words = arguments_of(options);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const OptionRow* const row = find_row(rows, words[i]);
    if (row != nullptr) {
      row->access.set(row->access.meta.empty() ? "on" : words[++i]);
    } else if (words[i] == "--weld") {
      automatic_length(request.reading.weld_tolerance).set(words[++i]);
    } else {
      set_file_option(words[i], request);
    }
  }
  return request;
}

/// Files that runs read: they are written once for all.
class Inputs {
 public:
  Inputs() {
    write_gltf_cube(folder_ / "cube.glb", 12);
    write_gltf_scene(folder_ / "scene.glb", {sphere(3), knot_like()},
                     {{{"mesh", 0}, {"translation", {3, 0, 0}}}, {{"mesh", 1}}, {{"mesh", 0}, {"scale", {2, 2, 2}}}},
                     {0, 1, 2});
    write_textured();
    io::write_mesh(folder_ / "two.ply", two_spheres());
    io::write_mesh(folder_ / "gaps.stl", soup_with_gaps());
  }

  std::string path(const std::string& name) const {
    const std::string own = folder_ / name;
    return std::filesystem::exists(own) ? own : data_file(name);
  }

 private:
  static IndexedMesh knot_like() { return torus(24, 12); }

  static IndexedMesh two_spheres() {
    IndexedMesh mesh = sphere(3);
    IndexedMesh other = sphere(3);
    for (Vec3& p : other.positions) p.x() += 2.05;
    append_mesh(mesh, std::move(other));
    return mesh;
  }

  static IndexedMesh soup_with_gaps() {
    IndexedMesh mesh = sphere(3);
    IndexedMesh soup;
    for (const Triangle& face : mesh.faces) {
      const auto first = static_cast<Index>(soup.positions.size());
      for (const Index v : face) {
        const double shift = 1e-5 * static_cast<double>(soup.positions.size() % 3);
        soup.positions.push_back(mesh.positions[v] + Vec3(shift, 0, 0));
      }
      soup.faces.push_back({first, first + 1, first + 2});
    }
    return soup;
  }

  void write_textured() {
    std::string text = "mtllib grid.mtl\n";
    constexpr int n = 20;
    for (int y = 0; y <= n; ++y) {
      for (int x = 0; x <= n; ++x) {
        const std::string s = std::to_string(x) + ' ' + std::to_string(y);
        text += "v " + s + ' ' + std::to_string((x * x + 3 * y * y) % 7 * 0.05) + '\n';
        text += "vt " + std::to_string(x / double{n}) + ' ' + std::to_string(y / double{n}) + '\n';
      }
    }
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (x == 0 && y % 10 == 0)
          text += "g part" + std::to_string(y / 10) + "\nusemtl m" + std::to_string(y / 10) + '\n';
        const auto corner = [&](int dx, int dy) {
          const std::string v = std::to_string((y + dy) * (n + 1) + x + dx + 1);
          return ' ' + v + '/' + v;
        };
        text += "f" + corner(0, 0) + corner(1, 0) + corner(1, 1) + corner(0, 1) + '\n';
      }
    }
    write_text(folder_ / "grid.obj", text);
    write_text(folder_ / "grid.mtl", "newmtl m0\nKd 1 0 0\nnewmtl m1\nKd 0 1 0\n");
  }

  TemporaryFolder folder_;
};

const Inputs& inputs() {
  static const Inputs all;
  return all;
}

class Library : public testing::TestWithParam<Run> {};

/// What a run has written, or what it says is wrong.
struct Result {
  std::string bytes;
  std::vector<std::string> warnings;
  bool met = false;
};

Result result_of_program(const Run& run, const TemporaryFolder& folder) {
  const std::string out = folder / "out." + run.extension;
  std::vector<std::string> arguments{"simplify", inputs().path(run.input), "-o", out, "--json", folder / "report.json"};
  const std::vector<std::string> options = arguments_of(run.options);
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = whittle(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  const nlohmann::json json = parse_json(read_text(folder / "report.json"));
  return {read_text(out), json["warnings"].get<std::vector<std::string>>(), json["target"]["met"].get<bool>()};
}

Result result_of_library(const Run& run, const TemporaryFolder& folder) {
  const std::string out = folder / "out." + run.extension;
  const FileRun file_run = simplify_file(inputs().path(run.input), out, request_of(run.options));
  return {read_text(out), file_run.warnings(), file_run.outcome.met};
}

TEST_P(Library, DoesWhatTheProgramDoes) {
  const TemporaryFolder folder;
  const Result program = result_of_program(GetParam(), folder);
  const Result library = result_of_library(GetParam(), folder);
  EXPECT_TRUE(program.bytes == library.bytes) << program.bytes.size() << " and " << library.bytes.size() << " bytes";
  EXPECT_EQ(program.warnings, library.warnings);
  EXPECT_EQ(program.met, library.met);
  EXPECT_FALSE(library.bytes.empty());
}

std::vector<Run> single_runs() {
  return {
      {"knot.ply", "ply", "--faces 2000"},
      {"knot.ply", "off", "--vertices 1500 --normals drop"},
      {"knot.ply", "stl", "--max-error 0.5%"},
      {"terrain.ply", "ply", "--face-ratio 5% --boundary locked"},
      {"terrain.ply", "ply", "--face-ratio 5% --boundary free --topology free"},
      {"terrain.ply", "obj", "--max-error 1% --max-error-borders 0.2%"},
      {"terrain.ply", "glb", "--face-ratio 10%"},
      {"cubes.obj", "obj", "--faces 20"},
      {"cubes.obj", "obj", "--faces 4 --prune 20%"},
      {"cubes.obj", "ply", "--faces 12 --threshold auto --effort fast"},
      {"two.ply", "ply", "--faces 100 --threshold 5%"},
      {"two.ply", "ply", "--faces 100 --threshold auto --max-pairs 4 --across-walls"},
      {"two.ply", "ply", "--faces 30 --self-intersections refuse"},
      {"two.ply", "ply", "--faces 200 --self-intersections count"},
      {"gaps.stl", "ply", "--faces 200"},
      {"gaps.stl", "ply", "--faces 200 --weld auto"},
      {"gaps.stl", "ply", "--faces 200 --weld 0.01%"},
      {"gaps.stl", "stl", "--faces 600 --no-weld --ascii"},
      {"nonmanifold.obj", "ply", "--faces 2"},
      {"cylinder.off", "ply", "--max-error 0.1%"},
      {"cylinder.off", "ply", "--feature-angle 40 --face-ratio 30%"},
      {"cylinder.off", "ply", "--feature-angle 40 --feature-tolerance 1% --max-error 1%"},
      {"flat.off", "off", "--max-error 0.01%"},
      {"flat.off", "ply", "--faces 2 --certify"},
      {"blob.obj", "ply", "--face-ratio 10% --isotropic 0.5 --cost quadric"},
      {"blob.obj", "ply", "--face-ratio 10% --valence 0.5"},
      {"blob.obj", "ply", "--face-ratio 10% --min-radius-ratio 0.3 --max-normal-flip 40"},
      {"blob.obj", "ply", "--face-ratio 10% --order exact"},
      {"blob.obj", "ply", "--face-ratio 10% --weights uniform --cost quadric"},
      {"blob.obj", "ply", "--face-ratio 10% --placement endpoint --cost quadric"},
      {"blob.obj", "ply", "--face-ratio 10% --polish 0"},
      {"blob.obj", "ply", "--face-ratio 10% --fit max"},
      {"blob.obj", "gltf", "--face-ratio 10%"},
      {"grid.obj", "obj", "--faces 100"},
      {"grid.obj", "ply", "--faces 100 --seams keep"},
      {"grid.obj", "glb", "--faces 60 --normals recompute --crease-angle 30"},
      {"grid.obj", "obj", "--faces 100 --attributes position-only"},
      {"grid.obj", "obj", "--faces 10 --regions g"},
      {"cube.glb", "glb", "--face-ratio 20%"},
      {"cube.glb", "gltf", "--max-error 1%"},
      {"cube.glb", "glb", "--face-ratio 20% --compress"},
      {"cube.glb", "glb", "--face-ratio 20% --quantize"},
      {"cube.glb", "obj", "--faces 100"},
      {"cube.glb", "glb", "--faces 60 --attributes position-only"},
      {"scene.glb", "glb", "--face-ratio 20%"},
      {"scene.glb", "glb", "--face-ratio 20% --per-mesh"},
      {"scene.glb", "glb", "--max-error 1% --prune 1%"},
      {"scene.glb", "ply", "--faces 300"},
      {"scene.glb", "glb", "--faces 300 --certify"},
  };
}

/// Each cost and each kind of target with each effort, and more.
std::vector<Run> runs() {
  std::vector<Run> all = single_runs();
  for (const char* effort : {"fast", "normal", "best"}) {
    for (const CostTraits& traits : all_cost_traits) {
      const std::string cost(traits.name);
      all.push_back({"blob.obj", "ply", "--face-ratio 20% --effort " + std::string(effort) + " --cost " + cost});
    }
    for (const char* target : {"--max-error 0.3%", "--faces 40", "--max-cost 1e-6", "--ratio 30% --max-error 1%"}) {
      all.push_back({"bracket.stl", "obj", std::string(target) + " --effort " + effort});
    }
  }
  return all;
}

/// Letters and digits alone, as names of tests have them.
std::string test_name(const testing::TestParamInfo<Run>& run) {
  std::string name = run.param.input + "_" + run.param.extension + "_" + run.param.options;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return std::to_string(run.index) + "_" + name;
}

TEST(SimplifyFile, ReplacesNoFileThatTheInputNeeds) {
  const TemporaryFolder folder;
  const std::string input = folder / "scene.gltf";
  ASSERT_EQ(whittle({"simplify", inputs().path("scene.glb"), "-o", input, "--ratio", "0.9"}).exit_code, 0);
  const std::string buffer = folder / "scene.bin";
  const std::string bytes = read_text(buffer);
  const std::string document = read_text(input);
  EXPECT_THROW(simplify_file(input, input, request_of("--ratio 0.5")), io::WriteError);
  EXPECT_EQ(read_text(buffer), bytes);
  EXPECT_EQ(read_text(input), document);
  const std::string output = folder / "smaller.gltf";
  simplify_file(input, output, request_of("--ratio 0.5"));
  EXPECT_LT(std::filesystem::file_size(folder / "smaller.bin"), bytes.size());
}

INSTANTIATE_TEST_SUITE_P(Options, Library, testing::ValuesIn(runs()), test_name);

}  // namespace
}  // namespace whittle::test
