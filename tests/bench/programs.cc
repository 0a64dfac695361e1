#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/command_line.hh"
#include "bench/processes/clock.hh"
#include "bench/processes/process.hh"
#include "bench/results/csv.hh"
#include "bench/results/statistics.hh"
#include "terminal/table.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

// `whittle simplify` beside other programs, from file to file, as whole processes. run.sh --programs builds and calls
// it.

namespace whittle::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Options {
  std::string mesh;
  double ratio = 0.1;
  Rounds rounds;
  std::string folder = "bench-programs";
  RowsFile rows{.csv = "programs.csv"};
  // Paths of the programs; a program without a path is left out.
  std::string whittle;
  std::string openmesh;
  std::string meshoptimizer;
  std::string gltfpack;
};

/// The same mesh in files of both formats, coordinates rounded to float.
struct Input {
  fs::path ply;
  fs::path obj;
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
};

struct Program {
  std::string name;
  std::string formats;
  std::vector<std::string> command;
  fs::path output;
  fs::path report;                         ///< JSON report it can write; empty if it can't
  std::vector<std::string> report_option;  ///< the options that write the report; that takes time which must not count
};

bool is_ours(const Program& program) { return program.name.starts_with("whittle"); }

/// Stages of `whittle simplify`, in seconds.
struct Stages {
  double read;
  double decimate;
  double write;
};

struct Result {
  std::string failure;
  std::size_t n_faces = 0;
  std::vector<double> seconds;
  std::vector<Stages> stages;  ///< one per round; empty for programs other than ours
};

void write_obj(const fs::path& path, const IndexedMesh& mesh) {
  std::string text;
  for (const Vec3& p : mesh.positions) {
    text += 'v';
    for (const double x : p) {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof(digits), static_cast<float>(x)).ptr;
      text.append(" ").append(digits, end);
    }
    text += '\n';
  }
  for (const auto& [a, b, c] : mesh.faces)
    text += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' + std::to_string(c + 1) + '\n';
  std::ofstream(path, std::ios::binary) << text;
}

Input make_input(const Options& options) {
  IndexedMesh mesh = io::read_mesh(options.mesh).mesh;
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  const fs::path folder = options.folder;
  fs::create_directories(folder);
  Input input{folder / "input.ply", folder / "input.obj", mesh.positions.size(), mesh.faces.size()};
  io::write_mesh(input.ply, mesh);
  write_obj(input.obj, mesh);
  return input;
}

/// `whittle simplify` from one of the inputs to a file of the same format.
Program our_program(const Options& options, const fs::path& input, bool all_cores) {
  const fs::path folder = options.folder;
  const bool is_ply = input.extension() == ".ply";
  Program program;
  program.name = all_cores ? "whittle, all cores" : "whittle";
  program.formats = is_ply ? "PLY to PLY" : "OBJ to OBJ";
  program.output = folder / (is_ply ? "output.ply" : "output.obj");
  program.report = folder / "whittle.json";
  program.report_option = {"--json", program.report};
  program.command = {options.whittle, "simplify",
                     "--effort",      "fast",
                     input,           "-o",
                     program.output,  "--quiet",
                     "--ratio",       formatted("%g", options.ratio)};
  if (!all_cores) program.command.insert(program.command.end(), {"--threads", "1"});
  return program;
}

Program openmesh_program(const Options& options, const Input& input, const fs::path& file) {
  const fs::path folder = options.folder;
  const bool is_ply = file.extension() == ".ply";
  const fs::path output = folder / (is_ply ? "output.ply" : "output.obj");
  // A negative number means vertices to keep.
  const long n = -static_cast<long>(options.ratio * static_cast<double>(input.n_vertices));
  return {"OpenMesh commandlineDecimater",
          is_ply ? "PLY to PLY" : "OBJ to OBJ",
          {options.openmesh, "-M", "Q", "-M", "NF", "-n", std::to_string(n), "-i", file, "-o", output},
          output,
          {},
          {}};
}

Program meshoptimizer_program(const Options& options, const Input& input) {
  const fs::path output = fs::path(options.folder) / "output.obj";
  return {"meshoptimizer, 20 lines",
          "OBJ to OBJ",
          {options.meshoptimizer, input.obj, output, formatted("%g", options.ratio)},
          output,
          {},
          {}};
}

Program gltfpack_program(const Options& options, const Input& input) {
  const fs::path output = fs::path(options.folder) / "output.glb";
  const fs::path report = fs::path(options.folder) / "gltfpack.json";
  return {"gltfpack",
          "OBJ to GLB",
          {options.gltfpack, "-i", input.obj, "-o", output, "-si", formatted("%g", options.ratio)},
          output,
          report,
          {"-r", report}};
}

/// Ours comes first for each input.
std::vector<Program> programs_of(const Options& options, const Input& input) {
  std::vector<Program> programs;
  for (const fs::path& file : {input.ply, input.obj}) {
    for (const bool all_cores : {false, true}) programs.push_back(our_program(options, file, all_cores));
    if (!options.openmesh.empty()) programs.push_back(openmesh_program(options, input, file));
  }
  if (!options.meshoptimizer.empty()) programs.push_back(meshoptimizer_program(options, input));
  if (!options.gltfpack.empty()) programs.push_back(gltfpack_program(options, input));
  return programs;
}

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

std::size_t faces_of(const Program& program) {
  if (program.output.extension() != ".glb") return io::read_mesh(program.output).mesh.faces.size();
  return read_json(program.report).at("render").at("triangleCount").get<std::size_t>();
}

/// \return seconds by the chosen clock
double run_once(const Program& program, const Options& options, bool with_report, Result& result) {
  fs::remove(program.output);
  std::vector<std::string> command = program.command;
  if (with_report) command.insert(command.end(), program.report_option.begin(), program.report_option.end());
  const ProcessRun run = run_process(command, fs::path(options.folder) / "log.txt", options.rounds.limit_s);
  if (result.failure.empty()) result.failure = run.failure;
  return options.rounds.clock == Clock::cpu ? run.cpu_s : run.wall_s;
}

/// Runs the program once and checks its result. Its time is that of this run until there are rounds.
Result first_result(const Program& program, const Input& input, const Options& options) {
  std::cerr << "   " << program.formats << ", " << program.name << std::endl;
  Result result;
  const double seconds = run_once(program, options, true, result);
  if (!result.failure.empty()) return result;
  result.n_faces = faces_of(program);
  // Some programs count vertices, some faces. Borders and handles make these differ a little.
  const double share = static_cast<double>(result.n_faces) / static_cast<double>(input.n_faces);
  if (std::abs(share / options.ratio - 1) > 0.02) result.failure = "not the number of faces wanted";
  result.seconds = {seconds};
  return result;
}

/// One round of one program: a timed run, and for ours a second run that reports the stages.
void add_round(const Program& program, const Options& options, Result& result) {
  result.seconds.push_back(run_once(program, options, false, result));
  if (!is_ours(program)) return;
  run_once(program, options, true, result);
  if (!result.failure.empty()) return;
  const Json seconds = read_json(program.report).at("seconds");
  result.stages.push_back({seconds.at("read"), seconds.at("decimate"), seconds.at("write")});
}

std::vector<Result> results_of(const std::vector<Program>& programs, const Input& input, const Options& options) {
  std::vector<Result> results;
  std::vector<std::size_t> timed;
  for (const Program& program : programs) {
    results.push_back(first_result(program, input, options));
    Result& result = results.back();
    if (!result.failure.empty() || result.seconds.front() > options.rounds.slow_s) continue;
    timed.push_back(results.size() - 1);
    result.seconds.clear();
  }
  std::cerr << "   " << options.rounds.n << " rounds" << std::endl;
  for (int round = 0; round < options.rounds.n; ++round) {
    for (const std::size_t i : timed) add_round(programs[i], options, results[i]);
  }
  return results;
}

/// The median of one stage.
std::optional<double> stage(const Result& result, double Stages::*member) {
  if (result.stages.empty()) return std::nullopt;
  std::vector<double> values;
  for (const Stages& stages : result.stages) values.push_back(stages.*member);
  return spread_of(values).median;
}

/// The time of reading and writing over that of decimating.
std::optional<double> share_of_files(const Result& result) {
  if (result.stages.empty()) return std::nullopt;
  std::vector<double> values;
  for (const Stages& stages : result.stages) values.push_back((stages.read + stages.write) / stages.decimate);
  return spread_of(values).median;
}

struct Row {
  const Program& program;
  const Result& result;
  std::optional<Spread> spread;
  std::optional<double> ratio_to_whittle;  ///< on one thread, in the same format
};

std::vector<Row> rows_of(const std::vector<Program>& programs, const std::vector<Result>& results) {
  std::map<std::string, const Result*> ours;  // by input format
  std::vector<Row> rows;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string format = programs[i].formats.substr(0, 3);
    if (programs[i].name == "whittle") ours[format] = &results[i];
    Row row{programs[i], results[i], std::nullopt, std::nullopt};
    if (results[i].failure.empty()) {
      row.spread = spread_of(results[i].seconds);
      const Result& reference = *ours.at(format);
      if (reference.failure.empty()) row.ratio_to_whittle = median_ratio(results[i].seconds, reference.seconds);
    }
    rows.push_back(row);
  }
  return rows;
}

std::string to_text(const std::vector<Row>& rows) {
  app::Table table;
  table.add({"", "faces", "min s", "median", "max", "/whittle", "read", "decimate", "write", "files/dec.", "answer"});
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.program.formats + ", " + row.program.name,
                                      std::to_string(row.result.n_faces)};
    for (double Spread::*member : {&Spread::min, &Spread::median, &Spread::max})
      cells.push_back(row.spread ? formatted("%.3f", *row.spread.*member) : "-");
    cells.push_back(text_or_dash(row.ratio_to_whittle, "%.2f"));
    for (double Stages::*member : {&Stages::read, &Stages::decimate, &Stages::write})
      cells.push_back(text_or_dash(stage(row.result, member), "%.3f"));
    cells.push_back(text_or_dash(share_of_files(row.result), "%.2f"));
    cells.push_back(row.result.failure.empty() ? "ok" : row.result.failure);
    table.add(cells);
  }
  return table.text();
}

void write_csv(const std::vector<Row>& rows, const Input& input, const Options& options) {
  std::ofstream file(options.rows.csv);
  file << csv_line({"program", "formats", "mesh", "faces", "result_faces", "s_min", "s_median", "s_max", "rounds",
                    "clock", "ratio_to_whittle", "s_read", "s_decimate", "s_write", "files_to_decimation", "answer",
                    "compiler", "commit"});
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.program.name, row.program.formats, fs::path(options.mesh).stem().string(),
                                      std::to_string(input.n_faces), std::to_string(row.result.n_faces)};
    for (double Spread::*member : {&Spread::min, &Spread::median, &Spread::max})
      cells.push_back(row.spread ? csv_number(*row.spread.*member) : "");
    cells.push_back(std::to_string(row.result.seconds.size()));
    cells.push_back(to_string(options.rounds.clock));
    cells.push_back(csv_number(row.ratio_to_whittle));
    for (double Stages::*member : {&Stages::read, &Stages::decimate, &Stages::write})
      cells.push_back(csv_number(stage(row.result, member)));
    cells.push_back(csv_number(share_of_files(row.result)));
    cells.insert(cells.end(),
                 {row.result.failure.empty() ? "ok" : row.result.failure, WHITTLE_BENCH_COMPILER, options.rows.commit});
    file << csv_line(cells);
  }
  if (!file.flush()) throw std::runtime_error("can't write " + options.rows.csv);
}

int run(const Options& options) {
  const Input input = make_input(options);
  const std::vector<Program> programs = programs_of(options, input);
  const std::vector<Result> results = results_of(programs, input, options);
  const std::vector<Row> rows = rows_of(programs, results);
  std::cout << options.mesh << ": " << input.n_faces << " faces, " << formatted("%g", 100 * options.ratio)
            << " % of them kept\n"
            << to_text(rows);
  write_csv(rows, input, options);
  bool is_right = true;
  for (const Row& row : rows) is_right = is_right && (row.result.failure.empty() || !is_ours(row.program));
  return is_right ? 0 : 1;
}

void set_up(CLI::App& app, Options& options) {
  app.add_option("--mesh", options.mesh, "what to simplify")->type_name("FILE")->check(CLI::ExistingFile)->required();
  app.add_option("--ratio", options.ratio, "share of the vertices or faces to keep")
      ->type_name("R")
      ->check(CLI::Range(1e-6, 0.999))
      ->capture_default_str();
  add_options(app, options.rounds, "programs");
  app.add_option("--folder", options.folder, "for inputs and outputs")->type_name("FOLDER")->capture_default_str();
  add_options(app, options.rows);
  app.add_option("--whittle", options.whittle, "the program")->type_name("FILE")->required();
  app.add_option("--openmesh", options.openmesh, "OpenMesh's commandlineDecimater")->type_name("FILE");
  app.add_option("--meshoptimizer", options.meshoptimizer, "meshoptimizer_obj")->type_name("FILE");
  app.add_option("--gltfpack", options.gltfpack, "gltfpack")->type_name("FILE");
}

}  // namespace
}  // namespace whittle::bench

int main(int argc, char** argv) {
  using namespace whittle::bench;
  CLI::App app("Times whittle beside other programs, from file to file.", "whittle_bench_programs");
  Options options;
  set_up(app, options);
  return run_program(app, argc, argv, [&options] { return run(options); });
}
