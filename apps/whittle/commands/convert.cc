#include <string>
#include <vector>

#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "system/system.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

struct ConvertCommand {
  std::string input;
  std::string output;
  FileOptions files;
  gltf::WriteOptions gltf;
  CommonOptions common;
};

struct Conversion {
  Input input;
  double write_seconds = 0;
  std::vector<std::string> warnings;
};

/// How files are read and written.
OptionRows setting_rows(ConvertCommand& options) {
  OptionRows rows = file_rows(options.files);
  append(rows, gltf_rows(options.gltf));
  return rows;
}

Json convert_json(ConvertCommand& options, const Conversion& run, double total_seconds) {
  const IndexedMesh& mesh = run.input.read.mesh;
  Json json = new_report();
  json["input"] = input_json(run.input, mesh.faces.empty() ? 0 : diagonal_of(bounds_of(mesh)));
  json["input"]["format"] = run.input.format->name;
  json["options"] = options_json(setting_rows(options));
  json["output"] = {{"path", options.output},
                    {"format", format_for_output(options.output, options.files).name},
                    {"vertices", mesh.positions.size()},
                    {"faces", mesh.faces.size()}};
  json["seconds"] = {{"read", run.input.seconds}, {"write", run.write_seconds}, {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

void check(const ConvertCommand& options) {
  check_formats({options.input}, {options.output}, options.files);
  check_rounding(options.output, options.files, options.gltf);
  std::vector<Output> outputs{{"OUT", options.output}};
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, {options.input}, options.common.force);
}

ExitCode run_convert(const Given& /*given*/, ConvertCommand options) {
  options.files.takes_no_triangles = writes_document(options.output, options.files);
  options.files.scope = scope_for(options.output, options.files);
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  Conversion run;
  run.input = read_input(options.input, options.files, options.common.threads, talk, io::AttributeScope::all);
  run.warnings = run.input.warnings;
  const IndexedMesh& mesh = run.input.read.mesh;
  if (mesh.faces.empty()) {
    run.warnings.push_back(about(run.input.name, why_no_faces(run.input.read) + "; all of it is written as it was"));
    talk.warning(run.warnings.back());
  }
  const Stopwatch writing;
  OutputFiles files(options.common.force);
  files.protect(run.input.needed_files);
  write_result(files, output_of(options.output, options.files, options.gltf), run.input, mesh, talk, run.warnings);
  run.write_seconds = writing.seconds();
  commit_with_report(files, options.common, [&] { return convert_json(options, run, watch.seconds()); });
  talk.say(shown_output(options.output) + ": " + faces_text(mesh.faces.size()) + ", " +
           vertices_text(mesh.positions.size()) + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows convert_rows(ConvertCommand& options) {
  OptionRows rows{
      mesh_argument(options.input, options.files),
      file_argument("OUT", options.output, "the result: a file, replaced if it exists, or '-' for standard output")};
  append(rows, setting_rows(options));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_convert(CLI::App& app, Command& command) {
  const SubcommandText text{"convert", "Write a mesh in another format, and simplify nothing.", "IN OUT [OPTION]...",
                            "Examples:\n"
                            "  whittle convert part.stl part.ply\n"
                            "  whittle convert scan.ply scan.obj.gz\n"
                            "  whittle convert - - --input-format obj --output-format stl < in.obj > out.stl"};
  ConvertCommand defaults;
  defaults.files.reads_documents = defaults.files.writes_documents = true;
  add_subcommand(app, text, defaults, convert_rows, run_convert, command);
}

}  // namespace whittle::app
