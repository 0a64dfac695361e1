// The JSON reports, key by key: the tables of docs/user against what the program prints in runs that cover all options.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/report_keys/option_runs.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_sheet.hh"
#include "program/help_text.hh"
#include "program/program.hh"
#include "program/stand_in_programs.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// A key as a page has it, and what the runs have shown of it.
struct DocumentedKey {
  std::string type;
  bool can_be_null = false;  ///< "… or null"
  bool is_always_there = false;
  std::size_t n_values = 0;
  std::size_t n_nulls = 0;
};
using DocumentedKeys = std::map<std::string, DocumentedKey>;

std::string user_page(const std::string& name) {
  return read_text(std::filesystem::path(WHITTLE_DOCS_DIR) / "user" / (name + ".md"));
}

/// Adds the keys of a type that the index describes: a row there for "mesh.path" is one of each object of type "mesh".
/// \return whether the index describes that type
bool add_keys_of_type(const std::string& name, const DocumentedKey& object, const std::vector<KeyText>& index,
                      DocumentedKeys& keys) {
  const std::string prefix = object.type + '.';
  bool is_described = false;
  for (const KeyText& row : index) {
    for (const std::string& key : row.keys) {
      if (!key.starts_with(prefix)) continue;
      is_described = true;
      const std::string full = name + '.' + key.substr(prefix.size());
      const DocumentedKey member{.type = row.type, .is_always_there = object.is_always_there && !object.can_be_null};
      EXPECT_TRUE(keys.emplace(full, member).second) << full << " is there twice";
    }
  }
  return is_described;
}

/// Keys of a page, and those of all reports, which are in the index.
DocumentedKeys documented_keys(const std::string& page) {
  const std::string or_null = " or null";
  const std::vector<KeyText> index = keys_of_page(user_page("README"));
  DocumentedKeys keys;
  for (const KeyText& row : keys_of_page(page)) {
    DocumentedKey key{.type = row.type, .is_always_there = row.when == "always"};
    EXPECT_FALSE(row.meaning.empty() || row.when.empty()) << row.keys.front();
    if (key.type.ends_with(or_null)) {
      key.can_be_null = true;
      key.type.erase(key.type.size() - or_null.size());
    }
    for (const std::string& name : row.keys) {
      const bool has_known_type = add_keys_of_type(name, key, index, keys);
      if (has_known_type && !key.can_be_null) continue;
      DocumentedKey own = key;
      if (has_known_type) own.type = "object";
      EXPECT_TRUE(keys.emplace(name, own).second) << name << " is there twice";
    }
  }
  for (const KeyText& row : index) {
    for (const std::string& name : row.keys) {
      if (name.find('.') != std::string::npos) continue;
      const DocumentedKey key{.type = row.type, .is_always_there = row.when == "always"};
      EXPECT_TRUE(keys.emplace(name, key).second) << name << " is there twice";
    }
  }
  return keys;
}

bool all_of(const Json& json, const std::function<bool(const Json&)>& is_right) {
  for (const Json& element : json) {
    if (!is_right(element)) return false;
  }
  return true;
}

bool has_type(const Json& value, const std::string& type) {
  const auto is_text = [](const Json& json) { return json.is_string(); };
  const auto is_integer = [](const Json& json) { return json.is_number_integer(); };
  const auto is_number = [](const Json& json) { return json.is_number(); };
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number_float();
  if (type == "null") return value.is_null();
  if (type == "object") return value.is_object();
  if (type == "object of integers") return value.is_object() && all_of(value, is_integer);
  if (type == "array of strings") return value.is_array() && all_of(value, is_text);
  if (type == "array of objects" || type == "array of reports") return value.is_array();
  if (type == "array of numbers") return value.is_array() && all_of(value, is_number);
  if (type == "array of 3 numbers") return value.is_array() && value.size() == 3 && all_of(value, is_number);
  ADD_FAILURE() << "'" << type << "' is no type of a key";
  return false;
}

/// Looks up each key of `json` and of the objects in it. An object needs no row of its own, unless it can be null.
/// \param path that of `json`, with a dot at the end; empty for the whole report
void look_up(const Json& json, const std::string& path, DocumentedKeys& keys) {
  for (const auto& [name, value] : json.items()) {
    const std::string key = path + name;
    const auto row = keys.find(key);
    const bool has_row = row != keys.end();
    if (has_row) {
      const bool is_allowed_null = value.is_null() && row->second.can_be_null;
      EXPECT_TRUE(is_allowed_null || has_type(value, row->second.type)) << key << ": " << value;
      ++(is_allowed_null ? row->second.n_nulls : row->second.n_values);
    }
    const bool has_keys = value.is_object() && (!has_row || row->second.type == "object");
    EXPECT_TRUE(has_row || has_keys) << key << " is printed, and not documented";
    if (has_keys) look_up(value, key + '.', keys);
    if (!has_row || row->second.type != "array of objects") continue;
    for (const Json& element : value) look_up(element, key + "[].", keys);
  }
}

/// Looks up a report that lacks the usual keys: that of several runs, or of a run that failed.
void look_up_partial(const Json& json, DocumentedKeys& keys) {
  DocumentedKeys seen = keys;
  look_up(json, "", seen);
  for (auto& [name, key] : keys) {
    if (!key.is_always_there) key = seen.at(name);
  }
}

/// Looks up what a call printed: a report, or one of several runs. \return how many whole reports there were
std::size_t look_up_printed(const Json& printed, DocumentedKeys& keys) {
  if (printed.contains("error")) {
    look_up_partial(printed, keys);
    return 0;
  }
  if (!printed.contains("runs")) {
    look_up(printed, "", keys);
    return 1;
  }
  look_up_partial(printed, keys);
  std::size_t n_reports = 0;
  for (const Json& report : printed["runs"]) n_reports += look_up_printed(report, keys);
  return n_reports;
}

void expect_that_runs_agree(const DocumentedKeys& keys, std::size_t n_runs) {
  for (const auto& [name, key] : keys) {
    const std::size_t n_there = key.n_values + key.n_nulls;
    EXPECT_GT(key.n_values, 0U) << name << " is documented, and never printed" << (n_there > 0 ? " but as null" : "");
    EXPECT_EQ(key.n_nulls > 0, key.can_be_null) << name << " is null in " << key.n_nulls << " runs";
    EXPECT_EQ(n_there == n_runs, key.is_always_there) << name << " is there in " << n_there << " of " << n_runs;
  }
}

/// Every option of the help must be in one of the runs; only then do they show all keys.
void expect_all_options_in(const std::vector<Arguments>& runs, const std::string& subcommand) {
  std::set<std::string> given{"--help"};
  for (const Arguments& run : runs) given.insert(run.begin(), run.end());
  for (const OptionText& option : options_of_help(whittle({subcommand, "--help"}).out)) {
    const std::vector<std::string> names = names_of(option);
    const bool is_given =
        std::any_of(names.begin(), names.end(), [&](const auto& name) { return given.contains(name); });
    EXPECT_TRUE(is_given) << "add a run with " << option.name << " of " << subcommand;
  }
}

/// \param runs everything after the subcommand's name; the report goes to standard output, if not to another place
void expect_documented(const std::string& subcommand, std::vector<Arguments> runs) {
  DocumentedKeys keys = documented_keys(user_page(subcommand));
  EXPECT_GE(keys.size(), 15U) << "docs/user/" << subcommand << ".md has no table of keys";
  std::size_t n_reports = 0;
  for (Arguments& run : runs) {
    run.insert(run.begin(), subcommand);
    run.insert(run.end(), {"--json", "-"});
    const Outcome outcome = whittle(run);
    ASSERT_FALSE(outcome.out.empty()) << outcome;
    n_reports += look_up_printed(parse_json(outcome.out), keys);
  }
  expect_that_runs_agree(keys, n_reports);
  expect_all_options_in(runs, subcommand);
}

/// A face whose corners are in one place: its box has no diagonal.
std::string point_mesh(const TemporaryFolder& folder) {
  write_text(folder.path() / "point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
  return folder / "point.obj";
}

/// A closed surface with an edge without length: welding changes it, though it has no border.
std::string closed_mesh(const TemporaryFolder& folder) {
  write_text(folder.path() / "closed.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1\n"
             "f 1 3 2\nf 1 2 4\nf 2 5 4\nf 2 3 5\nf 3 4 5\nf 3 1 4\n");
  return folder / "closed.obj";
}

TEST(ReportKeys, OfSimplifyAreDocumented) {
  const TemporaryFolder folder;
  if (!has_page(folder) || !has_pictures(folder)) GTEST_SKIP() << "no page, or no pictures";
  const std::string out = folder / "out.obj";
  const std::string bare = folder / "bare";
  const std::string blob = data_file("blob.obj");
  const std::string cubes = data_file("cubes.obj");
  const std::string terrain = data_file("terrain.ply");
  std::filesystem::copy_file(cubes, bare);
  const std::string large = folder / "large.ply";  // goes in blocks
  io::write_mesh(large, torus(600, 150));
  const std::string cube = folder / "cube.glb";
  write_gltf_cube(cube, 4);
  const std::string tolerances = folder / "tolerances";
  std::string lines;
  for (std::size_t v = 0; v < io::read_mesh(terrain).file_vertices; ++v) lines += "0.8%\n";
  write_text(tolerances, lines);
  std::vector<Arguments> runs{
      {cubes, "-o", out, "--faces", "60", "--threshold", "auto", "--max-pairs", "8", "--across-walls"},
      {cubes, "--output", out, "--faces", "10", "--topology", "free", "--prune", "1%", "--verbose"},
      {bare, "-o", bare, "--format", "obj", "--vertices", "150", "--no-weld", "--force"},
      {terrain, "-o", out, "--face-ratio", "10%", "--boundary", "free", "--map", folder / "map"},
      {terrain, "-o", out, "--max-cost", "1e-12", "--boundary-weight", "5", "--feature-angle", "40",
       "--feature-tolerance", "1%", "--max-normal-flip", "90", "--min-radius-ratio", "0.01"},
      {blob, "-o", out, "--ratio", "10%", "--effort", "best", "--quiet", "--threads", "1", "--color", "never",
       "--self-intersections", "count", "--normals", "drop", "--weld", "auto"},
      {blob, "-o", out, "--ratio", "0.1", "--cost", "quadric", "--weights", "uniform", "--placement", "midpoint",
       "--order", "exact", "--polish", "0", "--strict"},
      {blob, "-o", out, "--faces", "20", "--max-error", "1%", "--normals", "recompute", "--crease-angle", "30"},
      {terrain, "-o", out, "--max-error", "1%", "--max-error-borders", "0.5%", "--certificate", folder / "proof",
       "--record", folder / "rec", "--no-embed", "--zstd", "--tolerance-map", tolerances},
      {blob, "-o", out, "--faces", "500", "--certify", "--isotropic", "0.5", "--valence", "1", "--fit", "max",
       "--curve", folder / "curve.svg", "--map-back", folder / "back"},
      {large, "-o", out, "--faces", "1000", "--effort", "fast"},
      {cubes, "-o", out, "--faces", "100", "--frames", folder / "f{i}.png", "--every", "50%", "--animate",
       folder / "a.webp", "--page", folder / "a.html", "--live", folder / "b.html"},
      {blob, "-o", out, "--faces", "500", "--engine", "openmesh"},
      {blob, "-o", out, "--faces", "500", "--attributes", "position-only", "--seams", "keep", "--regions", "none",
       "--categories", "none"},
      {cube, "-o", folder / "weighed.glb", "--faces", "100", "--attribute-weight", "uv=1"},
      {cube, "-o", folder / "small.glb", "--faces", "100", "--compress", "--quantize", "--merge-meshes", "--per-mesh"},
      {blob, cubes, "--join", "-o", out, "--faces", "500"},
      {bare, "missing.ply", "-o", folder / "{stem}.txt", "--input-format", "obj", "--output-format", "ply", "--ascii",
       "--faces", "200"}};
  for (OptionRun& run : runs_with_options(folder)) runs.push_back(std::move(run.arguments));
  expect_documented("simplify", std::move(runs));
}

TEST(ReportKeys, OfMeasureAreDocumented) {
  const TemporaryFolder folder;
  const std::string point = point_mesh(folder);
  const std::string bare = folder / "bare";
  std::filesystem::copy_file(point, bare);
  const std::string terrain = data_file("terrain.ply");
  const std::string bracket = data_file("bracket.stl");
  const std::string low = folder / "low.glb", high = folder / "high.glb", flat = folder / "flat.glb";
  write_gltf_sheet(low, {});
  write_gltf_sheet(high, {.height = 1});
  write_gltf_sheet(flat, {.is_animated = false, .scale = 0});
  expect_documented("measure",
                    {{bracket, bracket, "--color", "never", "--feature-angle", "40", "--samples", "1000", "--seed", "2",
                      "--exact", "0.01"},
                     {terrain, terrain, "--samples", "1000", "--verbose", "--threads", "1", "--weld", "0"},
                     {point, point, "--no-weld", "--samples", "1000", "--quiet", "--exact", "1"},
                     {bare, point, "--no-weld", "--format", "obj", "--samples", "1000", "--force"},
                     {bare, point, "--no-weld", "--input-format", "obj", "--samples", "1000"},
                     {bracket, bracket, "--samples", "10", "--render", "1"},
                     {low, high, "--samples", "10", "--posed", "2"},
                     {flat, flat, "--samples", "10", "--posed", "2"},
                     {terrain, bracket, "--samples", "10", "--render", "1", "--render-image", folder / "a.png"}});
}

TEST(ReportKeys, OfInfoAreDocumented) {
  const TemporaryFolder folder;
  const std::string bare = folder / "bare";
  std::filesystem::copy_file(data_file("terrain.ply"), bare);
  expect_documented("info", {{data_file("knot.ply"), "--verbose", "--color", "never", "--weld", "auto"},
                             {data_file("bracket.stl"), "--threads", "1", "--quiet"},
                             {closed_mesh(folder)},
                             {bare, "--format", "ply", "--force"},
                             {bare, "--input-format", "ply"}});
}

TEST(ReportKeys, OfPolishAreDocumented) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const std::string blob = data_file("blob.obj");
  expect_documented(
      "polish",
      {{blob, blob, "--output", out, "--format", "obj", "--verbose", "--no-weld", "--fit", "mean"},
       {blob, blob, "-o", out, "--format", "obj", "--passes", "0", "--quiet", "--color", "never", "--force",
        "--threads", "1"},
       {blob, blob, "-o", out, "--input-format", "obj", "--output-format", "ply", "--ascii", "--passes", "0", "--weld",
        "0"},
       {blob, blob, "-o", folder / "out.glb", "--passes", "0", "--compress", "--quantize", "--merge-meshes"}});
}

TEST(ReportKeys, OfCompareAreDocumented) {
  const TemporaryFolder folder;
  const std::string point = point_mesh(folder);
  const std::string bare = folder / "bare";
  const std::string blob = data_file("blob.obj");
  std::filesystem::copy_file(blob, bare);
  expect_documented("compare",
                    {{blob, "--ratio", "50%", "--samples", "1000", "--seed", "2", "--verbose", "--weld", "0"},
                     {blob, "--face-ratio", "50%", "--samples", "1000", "--threads", "1", "--quiet"},
                     {bare, "--format", "obj", "--max-cost", "1e-6", "--samples", "1000", "--force"},
                     {bare, "--input-format", "obj", "--vertices", "500", "--effort", "best", "--color", "never",
                      "--samples", "1000"},
                     {point, "--no-weld", "--faces", "1", "--samples", "1000"}});
}

TEST(ReportKeys, OfConvertAreDocumented) {
  const TemporaryFolder folder;
  const std::string bare = folder / "bare";
  std::filesystem::copy_file(data_file("cubes.obj"), bare);
  expect_documented(
      "convert", {{bare, folder / "out", "--format", "obj", "--quiet", "--no-weld", "--force"},
                  {bare, folder / "out.ply", "--input-format", "obj", "--output-format", "ply", "--ascii", "--weld",
                   "auto", "--verbose", "--threads", "1", "--color", "never"},
                  {bare, folder / "out.glb", "--input-format", "obj", "--compress", "--quantize", "--merge-meshes"}});
}

TEST(ReportKeys, OfBakeAreDocumented) {
  const TemporaryFolder folder;
  if (!has_pictures(folder)) GTEST_SKIP() << "no pictures";
  IndexedMesh mesh = sphere(3);
  mesh.colors.assign(mesh.positions.size(), {1, 0.5F, 0, 1});
  const std::string high = folder / "high.ply";
  io::write_mesh(high, mesh);
  const std::string bare = folder / "bare";
  std::filesystem::copy_file(high, bare);
  const std::string low = folder / "low.ply";
  io::write_mesh(low, sphere(1));
  const std::string out = folder / "out.glb";
  expect_documented("bake", {{high, low, "-o", out, "--quiet", "--no-weld", "--threads", "1"},
                             {bare, bare, "--output", out, "--format", "ply", "--texture-size", "64", "--force"},
                             {bare, bare, "-o", out, "--input-format", "ply", "--no-normal-map", "--weld", "auto",
                              "--verbose", "--color", "never"}});
}

/// Writes recordings of the terrain: one with its mesh, and one without.
void write_recordings(const TemporaryFolder& folder, const std::string& rec, const std::string& bare) {
  const std::vector<std::string> simplify{
      "simplify", data_file("terrain.ply"), "-o", folder / "small.ply", "--faces", "500", "--quiet"};
  std::vector<std::string> with_mesh = simplify;
  with_mesh.insert(with_mesh.end(), {"--record", rec});
  std::vector<std::string> without_mesh = simplify;
  without_mesh.insert(without_mesh.end(), {"--record", bare, "--no-embed", "--zstd"});
  ASSERT_EQ(whittle(with_mesh).exit_code, 0);
  ASSERT_EQ(whittle(without_mesh).exit_code, 0);
}

TEST(ReportKeys, OfGeomorphAreDocumented) {
  const TemporaryFolder folder;
  const std::string terrain = data_file("terrain.ply");
  const std::string frames = folder / "out{i}";
  const std::string rec = folder / "rec";
  const std::string bare = folder / "bare";
  write_recordings(folder, rec, bare);
  expect_documented("geomorph",
                    {{rec, "-o", folder / "out.glb", "--from", "2000", "--verbose", "--threads", "1"},
                     {bare, "--output", frames, "--format", "ply", "--input", terrain, "--frames", "3", "--no-weld"},
                     {bare, "-o", frames, "--output-format", "ply", "--input", terrain, "--input-format", "ply",
                      "--frames", "2", "--ascii", "--weld", "0", "--force", "--color", "never"},
                     {rec, "-o", frames, "--output-format", "obj", "--to", "700", "--frames", "2", "--normal-blend",
                      "linear", "--quiet"}});
}

TEST(ReportKeys, OfReportAreDocumented) {
  const TemporaryFolder folder;
  if (!has_page(folder) || !has_pictures(folder)) GTEST_SKIP() << "no page, or no pictures";
  const std::string terrain = data_file("terrain.ply");
  const std::string small = folder / "small";
  const std::string rec = folder / "rec";
  const std::string report = folder / "report";
  ASSERT_EQ(whittle({"simplify", terrain, "-o", small, "--output-format", "ply", "--ratio", "10%", "--record", rec,
                     "--json", report, "--quiet"})
                .exit_code,
            0);
  expect_documented(
      "report", {{terrain, "-o", folder / "a.html", "--format", "ply", "--verbose", "--threads", "1"},
                 {terrain, small, "--output", folder / "b.html", "--input-format", "ply", "--run", report, "--no-weld"},
                 {terrain, rec, "--png", folder / "c.png", "--view", "colour=error", "--png-size", "300x200", "--quiet",
                  "--frames", folder / "f{i}.png", "--every", "0.5", "--animate", folder / "a.webp"},
                 {terrain, "-o", folder / "d.html", "--max-faces", "1000", "--weld", "0", "--force", "--color", "never",
                  "--open"}});
}

TEST(ReportKeys, OfReplayAreDocumented) {
  const TemporaryFolder folder;
  const std::string terrain = data_file("terrain.ply");
  const std::string out = folder / "out";
  const std::string rec = folder / "rec";
  const std::string bare = folder / "bare";
  write_recordings(folder, rec, bare);
  expect_documented(
      "replay", {{rec, "-o", out, "--format", "ply", "--faces", "600", "--verbose", "--ascii"},
                 {rec, "-o", out, "--output-format", "obj", "--vertices", "600", "--quiet", "--threads", "1"},
                 {bare, "--output", out, "--format", "ply", "--input", terrain, "--cost", "1e-9", "--no-weld"},
                 {rec, "-o", folder / "out.glb", "--at", "1", "--compress", "--quantize", "--merge-meshes"},
                 {bare, "-o", out, "--output-format", "ply", "--input", terrain, "--input-format", "ply", "--at", "0.5",
                  "--weld", "0", "--force", "--color", "never"},
                 {rec, "-o", folder / "out{i}.ply", "--steps", "0:1:3"}});
}

TEST(ReportKeys, OfLodAreDocumented) {
  const TemporaryFolder folder;
  const std::string terrain = data_file("terrain.ply");
  const std::string out = folder / "out{i}";
  expect_documented(
      "lod", {{terrain, "-o", out, "--format", "ply", "--faces", "600,300", "--verbose", "--ascii", "--effort", "best"},
              {terrain, "-o", out, "--output-format", "obj", "--ratios", "0.5,10%", "--quiet", "--threads", "1"},
              {terrain, "--output", out, "--format", "ply", "--face-ratios", "10%", "--no-weld", "--fit", "max"},
              {terrain, "-o", out, "--output-format", "ply", "--input-format", "ply", "--errors", "1%", "--weld", "0",
               "--force", "--color", "never"},
              {terrain, "-o", folder / "out.glb", "--faces", "600,300", "--compress", "--quantize", "--merge-meshes"},
              {terrain, "-o", folder / "out.glb", "--distances", "500%", "--target-pixels", "2", "--view-height", "720",
               "--fov", "50"}});
}

TEST(ReportKeys, OfVerifyAreDocumented) {
  const TemporaryFolder folder;
  const std::string point = point_mesh(folder);
  const std::string terrain = data_file("terrain.ply");
  const std::string out = folder / "out";
  const std::string proof = folder / "proof";
  ASSERT_EQ(whittle({"simplify", terrain, "-o", out, "--output-format", "ply", "--max-error", "1%", "--certificate",
                     proof, "--quiet"})
                .exit_code,
            0);
  write_text(folder / "no proof", "");
  expect_documented(
      "verify",
      {{terrain, out, proof, "--format", "ply", "--max-error", "2%", "--max-error-borders", "0.5%", "--verbose"},
       {terrain, out, proof, "--input-format", "ply", "--weld", "auto", "--threads", "1", "--color", "never"},
       {point, point, folder / "no proof", "--no-weld", "--quiet", "--force"}});
}

}  // namespace
}  // namespace whittle::test
