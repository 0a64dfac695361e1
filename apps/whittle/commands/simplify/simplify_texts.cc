#include "commands/simplify/simplify_texts.hh"

#include <algorithm>

#include "commands/mesh_kind.hh"
#include "commands/simplify/proven_distances.hh"
#include "files/input.hh"
#include "files/report.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/core/wedges.hh"

namespace whittle::app {
namespace {

std::string threshold_pairs(const ThresholdPairCounts& pairs) {
  return "threshold " + significant(pairs.threshold) + ": " + std::to_string(pairs.considered) + " pairs" +
         (pairs.capped ? ", the nearest of each vertex" : "") + ", " + std::to_string(pairs.contracted) + " contracted";
}

std::size_t count_parts(const IndexedMesh& mesh) { return find_parts(mesh.positions.size(), mesh.faces).count; }

/// ", 25 -> 3 parts": with a threshold, parts may join.
std::string parts_text(const SimplifyRecord& record) {
  if (record.threshold == 0) return "";
  return ", " + std::to_string(count_parts(record.input.read.mesh)) + " -> " +
         counted(count_parts(record.simplified.mesh), "part", "parts");
}

/// ", ended by '--max-error',"
std::string ended_by(StopReason stop) {
  const std::string_view option = option_that_ended(stop);
  return option.empty() ? "" : ", ended by '" + std::string(option) + "',";
}

std::vector<std::string> lost_in_openmesh(const SimplifyCommand& options, const Input& input) {
  std::vector<std::string> warnings;
  const auto add = [&](const char* what) {
    warnings.push_back(input.name + ": " + what + " are not carried by --engine openmesh");
  };
  if (!input.read.mesh.normals.empty() && options.request.simplify.decimate.normals != Normals::drop)
    add("vertex normals");
  if (!input.read.mesh.colors.empty()) add("vertex colours");
  return warnings;
}

/// Whether texture coordinates differ between the two faces of each inner edge, at one of its ends at least.
/// \pre the mesh has a table of wedges
bool has_chart_per_face(const IndexedMesh& mesh, const Attribute& texcoords) {
  const std::vector<Index> numbers = faces_without_backs(mesh.faces);
  std::vector<Triangle> faces;
  faces.reserve(numbers.size());
  for (const Index f : numbers) faces.push_back(mesh.faces[f]);
  const detail::EdgeTable edges(faces, mesh.positions.size());
  const auto differ = [&](Index side, Index other) {
    const auto of_corner = [&](Index corner) { return texcoords.value(mesh.wedge(numbers[corner / 3], corner % 3)); };
    const auto a = of_corner(side);
    const auto b = of_corner(other);
    return !std::equal(a.begin(), a.end(), b.begin());
  };
  std::size_t n_inner = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_regular(e, faces)) continue;
    ++n_inner;
    const Index first = edges.sides(e)[0];
    const Index second = edges.sides(e)[1];
    // The sides run in opposite directions.
    if (!differ(first, detail::next_in_face(second)) && !differ(detail::next_in_face(first), second)) return false;
  }
  return n_inner > 0;
}

bool has_chart_per_face(const IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return false;
  return std::any_of(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& attribute) {
    return attribute.kind == AttributeKind::texcoord && has_chart_per_face(mesh, attribute);
  });
}

}  // namespace

std::string refusals(const SimplifyCommand& options, const RefusalCounts& refused) {
  if (options.engine == Engine::openmesh) return "OpenMesh doesn't say what it refused";
  std::string text;
  for (const RefusalRow& row : all_refusals) {
    if (refused[row.refusal] == 0 && !row.is_always_told) continue;
    text += (text.empty() ? "refused: " : ", ") + std::to_string(refused[row.refusal]) + ' ' + std::string(row.words);
  }
  return text;
}

void say_details(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  if (!talk.is_verbose()) return;
  const DecimateResult& result = record.simplified.result;
  talk.detail("contractions: " + std::to_string(result.n_contractions) + ", greatest cost " +
              significant(result.max_cost) + ", stopped by: " + std::string(to_string(result.stop)));
  if (!result.why_in_one_pass.empty())
    talk.detail("in one pass, not in blocks: " + std::string(result.why_in_one_pass));
  if (options.has_cost_by_effort && *options.request.simplify.tries_plain_quadrics &&
      record.simplified.cost == Cost::quadric)
    talk.detail(std::string("by plain quadrics, which came nearer") +
                (is_mostly_flat(record.input.read.mesh) ? ": much of the mesh is flat" : ""));
  talk.detail(refusals(options, result.refusals));
  if (record.threshold > 0) talk.detail(threshold_pairs(result.threshold_pairs));
  const bool is_polished = *options.request.simplify.polish_passes > 0;
  if (is_polished) talk.detail("polish: " + polish_text(record.simplified.polish));
  if (record.distances) {
    const NamesOfRun names{record.input.name, shown_output(options.output), record.diagonal};
    for (const std::string& line : distance_lines(*record.distances, record.target, names)) talk.detail(line);
  }
  talk.detail("read " + seconds_text(record.seconds.read) + ", decimate " + seconds_text(record.seconds.decimate) +
              (is_polished ? ", polish " + seconds_text(record.seconds.polish) : "") +
              (record.distances ? ", certify " + seconds_text(record.seconds.certify) : "") + ", write " +
              seconds_text(record.seconds.write));
  say_effort(talk, record.seconds.total);
}

std::string summary(const SimplifyCommand& options, const SimplifyRecord& record) {
  const IndexedMesh& before = record.input.read.mesh;
  const DecimateResult& after = record.simplified.result;
  return shown_output(options.output) + ": " + std::to_string(before.faces.size()) + " -> " +
         faces_text(after.n_faces) + ", " + std::to_string(before.positions.size()) + " -> " +
         vertices_text(after.n_vertices) + parts_text(record) +
         (record.n_intersections_after ? ", " + std::to_string(*record.n_intersections_before) + " -> " +
                                             std::to_string(*record.n_intersections_after) + " self-intersections"
                                       : "") +
         (record.distances
              ? ", at most " + length_text_rounded_up(proven_distance(record.distances->surface), record.diagonal) +
                    " off"
              : "") +
         (record.met ? "" : ended_by(after.stop)) + " in " + seconds_text(record.seconds.total);
}

std::vector<std::string> input_warnings(const SimplifyCommand& options, const Input& input) {
  std::vector<std::string> warnings;
  if (options.engine == Engine::openmesh) warnings = lost_in_openmesh(options, input);
  if (has_chart_per_face(input.read.mesh)) {
    warnings.push_back(input.name +
                       ": each triangle is a chart of its own on the texture, so each edge is a seam: neither texture "
                       "nor shape can be kept well; '--attributes position-only' drops the texture and keeps the "
                       "shape, and a texture baked anew in larger charts keeps both");
  }
  return warnings;
}

}  // namespace whittle::app
