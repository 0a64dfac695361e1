#include "commands/simplify/simplify_files.hh"

#include <ostream>
#include <utility>
#include <vector>

#include "commands/page/make_page.hh"
#include "commands/recording/curve.hh"
#include "commands/recording/recorded_notes.hh"
#include "commands/recording/recording_input.hh"
#include "commands/simplify/simplify_report.hh"
#include "files/mesh_output.hh"
#include "pictures/frames.hh"
#include "whittle/core/wedges.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::app {
namespace {

/// For each vertex of the file, its number in the result.
std::vector<Index> vertex_map_of(const SimplifyRecord& record) {
  std::vector<Index> map = record.plan.scene.read.vertex_map;
  for (Index& v : map) v = v == invalid_index ? v : record.outcome.simplified.vertex_map[v];
  return map;
}

/// Writes a line for every vertex of the file: its number in the result, or -1.
void write_map(std::ostream& out, const SimplifyRecord& record) {
  for (const Index written : vertex_map_of(record)) {
    if (written == invalid_index) {
      out << "-1\n";
    } else {
      out << written << '\n';
    }
  }
}

/// Writes a line for every vertex of the result: the numbers of its vertices in the file.
void write_map_back(std::ostream& out, const SimplifyRecord& record) {
  std::vector<std::vector<Index>> sources(record.outcome.simplified.mesh.positions.size());
  const std::vector<Index> map = vertex_map_of(record);
  for (Index v = 0; v < map.size(); ++v) {
    if (map[v] != invalid_index) sources[map[v]].push_back(v);
  }
  for (const std::vector<Index>& vertices : sources) {
    for (std::size_t i = 0; i < vertices.size(); ++i) out << (i == 0 ? "" : " ") << vertices[i];
    out << '\n';
  }
}

progressive::RecordingNotes notes_of(const SimplifyCommand& options, const Scene& input) {
  if (!options.embeds_input) return {};
  progressive::RecordingNotes notes = recorded_notes(input.read.notes);
  if (writes_document(options.output, options.files) && !keeps_meshes(input)) notes[mesh_name_note] = {input.mesh_name};
  return notes;
}

void write_recording_file(std::ostream& out, const SimplifyCommand& options, const SimplifyRecord& record) {
  const Json about = {{"program", program_and_version()},
                      {input_format_key, record.plan.scene.format->name},
                      {"options", simplify_options_json(options)}};
  const progressive::RecordingOptions how{options.embeds_input, options.compresses_recording, options.common.threads,
                                          notes_of(options, record.plan.scene)};
  progressive::write_recording(out, record.plan.scene.read.mesh, record.outcome.simplified.steps,
                               options.request.simplify.decimate.normals, to_text(about), how);
}

void write_curve(std::ostream& out, const SimplifyCommand& options, const SimplifyRecord& record) {
  out << (options.curve->ends_with(".svg") ? curve_svg(record.curve, record.plan.scene.name) : curve_csv(record.curve));
}

/// The input, and the levels of the run.
ShownMeshes shown_run(const SimplifyRecord& record) {
  ShownMeshes shown;
  const std::string& path = record.plan.scene.name;
  shown.original.name = path.substr(path.find_last_of('/') + 1);
  shown.original.mesh = without_attributes(recorded_input(record));
  shown.run.emplace(shown.original.mesh, record.outcome.simplified.steps, Normals::drop);
  return shown;
}

}  // namespace

void write_files(const SimplifyCommand& options, const Talk& talk, const Stopwatch& since_start, SimplifyRecord& record,
                 Json* report) {
  const Stopwatch watch;
  OutputFiles files(options.common.force);
  files.protect(record.plan.scene.needed_files);
  write_result(files, output_of(options.output, options.files, options.gltf), record.plan.scene,
               record.outcome.simplified.mesh, talk, record.warnings);
  const auto write = [&files](const std::optional<std::string>& path, const auto& fill) {
    if (path) files.write(*path, fill);
  };
  write(options.map, [&](std::ostream& out) { write_map(out, record); });
  write(options.map_back, [&](std::ostream& out) { write_map_back(out, record); });
  write(options.certificate, [&](std::ostream& out) { out << record.outcome.certificate; });
  write(options.recording, [&](std::ostream& out) { write_recording_file(out, options, record); });
  write(options.curve, [&](std::ostream& out) { write_curve(out, options, record); });
  if (options.page || options.live) {
    const std::string page = make_page({record.plan.scene, options.output, record.outcome.simplified,
                                        simplify_json(options, record), record.shortfall},
                                       options.common, talk);
    for (const auto& path : {options.page, options.live}) write(path, [&page](std::ostream& out) { out << page; });
  }
  if (options.pictures.is_given()) {
    ShownMeshes shown = shown_run(record);
    write_frames(files, options.pictures, shown, {{}, {}, options.common.threads}, talk);
  }
  record.write_seconds = watch.seconds();
  record.total_seconds = since_start.seconds();
  Json json = report != nullptr || options.common.json ? simplify_json(options, record) : Json();
  commit_with_report(files, options.common, [&json] { return json; });
  if (report != nullptr) *report = std::move(json);
}

}  // namespace whittle::app
