#include <string>
#include <vector>

#include "commands/mesh_kind.hh"
#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "terminal/point_text.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::app {
namespace {

struct InfoOptions {
  std::string input;
  FileOptions files;  ///< `weld` is not used: both ways are shown
  CommonOptions common;
};

/// Facts about one mesh.
struct View {
  metrics::Topology topology;
  metrics::Shape shape;
  std::size_t self_intersections = 0;
};

struct Findings {
  Scene scene;                   ///< after all repairs
  std::optional<View> unwelded;  ///< set if welding changed something
  View repaired;
  MeshKind kind;
  Box bounds;
};

View view(const IndexedMesh& mesh, unsigned threads, const Talk& talk) {
  ProgressBar bar(talk, "comparing faces");
  return {metrics::topology(mesh), metrics::shape(mesh),
          metrics::self_intersections(mesh, threads, part_of(bar, 0, 1)).size()};
}

Findings look_at(const InfoOptions& options, const Talk& talk) {
  const SceneFile file = scene_file(options.input, options.files);
  const unsigned threads = options.common.threads;
  Findings findings;
  findings.scene = file.read(read_options(options.files, threads, io::AttributeScope::all));
  const IndexedMesh& mesh = findings.scene.read.mesh;
  findings.repaired = view(mesh, threads, talk);
  findings.kind = kind_of(mesh, findings.repaired.topology, findings.scene.format->is_document, threads);
  findings.bounds = bounds_of(mesh);
  if (findings.scene.read.repairs.welded_vertices == 0) return findings;
  FileOptions unwelded = options.files;
  unwelded.weld = false;
  unwelded.weld_tolerance = {};
  findings.unwelded = view(file.read(read_options(unwelded, threads)).read.mesh, threads, talk);
  return findings;
}

Json point_json(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

Json view_json(const View& view) {
  const metrics::Topology& topology = view.topology;
  Json json = {{"vertices", topology.vertices}, {"faces", topology.faces}, {"edges", topology.edges}};
  add_topology(json, topology);
  json["boundary_edges"] = topology.boundary_edges;
  json["misoriented_edges"] = topology.misoriented_edges;
  json["oriented"] = topology.oriented;
  json["orientable"] = topology.orientable;
  json["euler"] = topology.euler;
  json["degenerate_faces"] = view.shape.degenerate_faces;
  json["folds"] = view.shape.folds;
  json["self_intersections"] = view.self_intersections;
  return json;
}

std::vector<std::string> attributes_of(const IndexedMesh& mesh) {
  std::vector<std::string> names;
  if (!mesh.normals.empty()) names.emplace_back("vertex normals");
  if (!mesh.colors.empty()) names.emplace_back("vertex colours");
  for (const Attribute& attribute : mesh.attributes) names.push_back(attribute.name);
  for (const Attribute& attribute : mesh.face_attributes) names.push_back(attribute.name + " of faces");
  if (!mesh.face_groups.empty()) names.emplace_back("groups");
  return names;
}

Json suggestions_json(const std::vector<Suggestion>& suggestions) {
  Json json = Json::array();
  for (const auto& [option, reason] : suggestions) json.push_back({{"option", option}, {"reason", reason}});
  return json;
}

Json info_json(const InfoOptions& options, const Findings& findings) {
  const io::ReadResult& read = findings.scene.read;
  Json json = new_report();
  json["path"] = options.input;
  json["format"] = findings.scene.format->name;
  json["file"] = {{"vertices", read.file_vertices}, {"faces", read.file_faces}};
  json["repairs"] = repairs_json(read.repairs);
  json["weld_tolerance"] = findings.scene.weld_tolerance;
  json["diagonal"] = diagonal_of(findings.bounds);
  json["bounds"] = {{"min", point_json(findings.bounds.min())}, {"max", point_json(findings.bounds.max())}};
  json.update(view_json(findings.repaired));
  json["kind"] = findings.kind.words;
  json["flat_edges"] = findings.kind.flat_edges;
  json["suggestions"] = suggestions_json(findings.kind.suggestions);
  json["unwelded"] = findings.unwelded ? view_json(*findings.unwelded) : Json(nullptr);
  json["attributes"] = attributes_of(read.mesh);
  json["warnings"] = read.warnings;
  return json;
}

/// The rows of the table for one view: a title and a value each.
std::vector<std::pair<std::string, std::string>> rows(const View& view) {
  const metrics::Topology& topology = view.topology;
  const auto count = [](std::size_t n) { return std::to_string(n); };
  return {{"vertices", count(topology.vertices)},
          {"faces", count(topology.faces)},
          {"edges", count(topology.edges)},
          {"components", count(topology.components)},
          {"closed (watertight)", yes_no(topology.closed)},
          {"border edges", count(topology.boundary_edges)},
          {"border loops (holes)", count(topology.boundary_loops)},
          {"manifold", yes_no(topology.manifold)},
          {"non-manifold edges", count(topology.nonmanifold_edges)},
          {"non-manifold vertices", count(topology.nonmanifold_vertices)},
          {"Euler number", std::to_string(topology.euler)},
          {"genus", topology.genus ? std::to_string(*topology.genus) : "-"},
          {"oriented alike", topology.oriented     ? "yes"
                             : topology.orientable ? "no, but can be"
                                                   : "no, and can't be"},
          {"misoriented edges", count(topology.misoriented_edges)},
          {"faces without area", count(view.shape.degenerate_faces)},
          {"folds", count(view.shape.folds)},
          {"self-intersections", count(view.self_intersections)}};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

std::string summary_of(const Findings& findings) {
  const io::ReadResult& read = findings.scene.read;
  const std::string repairs = io::to_string(read.repairs);
  std::string text = findings.scene.name + ": " + std::string(findings.scene.format->title) + ", " +
                     vertices_text(read.file_vertices) + ", " + faces_text(read.file_faces) + " in the file\n";
  text += "repairs: " + (repairs.empty() ? "none" : repairs) + '\n';
  const double diagonal = diagonal_of(findings.bounds);
  text += "box: " + point_text(findings.bounds.min(), diagonal) + " to " + point_text(findings.bounds.max(), diagonal) +
          ", diagonal " + significant(diagonal) + '\n';
  text += "attributes: " + joined(attributes_of(read.mesh)) + '\n';
  text +=
      "kind: " + joined(findings.kind.words) + "; " + percent(findings.kind.flat_edges) + " of the edges are flat\n\n";

  Table table;
  const auto repaired = rows(findings.repaired);
  if (findings.unwelded) {
    const auto unwelded = rows(*findings.unwelded);
    table.add({"", "unwelded", "welded"});
    for (std::size_t i = 0; i < repaired.size(); ++i) {
      table.add({repaired[i].first, unwelded[i].second, repaired[i].second});
    }
  } else {
    for (const auto& [name, value] : repaired) table.add({name, value});
  }
  text += table.text();
  const std::vector<Suggestion>& suggestions = findings.kind.suggestions;
  if (!suggestions.empty()) text += "\nOptions of 'simplify' that suit it:\n";
  for (const auto& [option, reason] : suggestions) text.append("  ").append(option).append(": ").append(reason) += '\n';
  return text;
}

ExitCode run_info(const Given& /*given*/, InfoOptions options) {
  check_formats({options.input}, {}, options.files);
  if (options.common.json) check_outputs({{"--json", *options.common.json}}, {options.input}, options.common.force);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  const Findings findings = look_at(options, talk);
  for (const std::string& warning : findings.scene.read.warnings) talk.warning(about(findings.scene.name, warning));
  write_report(
      options.common, [&] { return info_json(options, findings); }, summary_of(findings));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows info_rows(InfoOptions& options) {
  OptionRows rows{mesh_argument(options.input, options.files)};
  append(rows, input_format_rows(options.files));
  OptionRow weld = weld_row(options.files);
  weld.conflicts.clear();
  rows.push_back(std::move(weld));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_info(CLI::App& app, Command& command) {
  const SubcommandText text{"info", "Say what is in a mesh file and what is wrong with it.", "IN [OPTION]...",
                            "Examples:\n"
                            "  whittle info part.stl\n"
                            "  whittle info part.stl --json - | jq .closed"};
  InfoOptions defaults;
  defaults.files.reads_documents = true;
  defaults.files.scope = SceneScope::shown;
  add_subcommand(app, text, defaults, info_rows, run_info, command);
}

}  // namespace whittle::app
