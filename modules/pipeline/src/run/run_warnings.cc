#include "run/run_warnings.hh"

#include <algorithm>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/pipeline/new_intersections.hh"

namespace whittle {
namespace {

/// Collects warnings of a run, each with the name of the scene in front.
class WarningFinder {
 public:
  WarningFinder(const Plan& plan, const Outcome& outcome) : plan_(plan), outcome_(outcome) {}

  std::vector<RunWarning> find() {
    take_those_of_decimation();
    warn_of_nothing_contracted();
    for (const std::string& text : texts_of(outcome_.vanished)) add(RunWarningKind::vanished, text);
    warn_of_folds();
    warn_of_three_edges();
    warn_of_gaps();
    warn_of_new_intersections();
    return std::move(warnings_);
  }

 private:
  const Simplification& simplified() const { return outcome_.simplified; }
  void add(RunWarningKind kind, const std::string& text) { warnings_.push_back({kind, about(plan_.scene.name, text)}); }

  /// Except those that reports have elsewhere.
  void take_those_of_decimation() {
    for (const Warning& warning : simplified().result.warnings) {
      if (warning.kind != WarningKind::pairs_capped) add(RunWarningKind::decimation, warning.text);
    }
  }

  /// A limit of the error that allows nothing at all may surprise.
  void warn_of_nothing_contracted() {
    const DecimateResult& result = simplified().result;
    if (result.stop != StopReason::error || result.n_contractions > 0) return;
    const std::string left = reasons_at_end(result.refused_at_end);
    add(RunWarningKind::nothing_contracted, "nothing is contracted, as no fewer faces are found that keep within " +
                                                length_text(*plan_.target.error_limit(), plan_.diagonal) +
                                                (left.empty() ? "" : "; the pairs left: " + left));
  }

  void warn_of_folds() {
    const std::size_t n = simplified().n_folded_texture_faces;
    if (n == 0) return;
    add(RunWarningKind::folded_texture, faces_text(n) + (n == 1 ? " is" : " are") + " folded over on the texture");
  }

  /// The penalty for valences makes vertices with three edges rare, but refuses none.
  void warn_of_three_edges() {
    if (plan_.options.decimate.valence_weight == 0 || simplified().mesh.faces.empty()) return;
    std::size_t n_vertices = 0;
    for (const auto& [valence, count] : metrics::shape(simplified().mesh).valence.histogram) {
      if (valence <= 3) n_vertices += count;
    }
    if (n_vertices == 0) return;
    add(RunWarningKind::three_edges, std::to_string(n_vertices) + (n_vertices == 1 ? " vertex has" : " vertices have") +
                                         " only three edges: they had them before, or nothing else was left to "
                                         "contract");
  }

  /// Whether a twentieth of the vertices and more lie on open borders.
  bool has_much_border() const {
    const IndexedMesh& mesh = simplified().mesh;
    const auto is_border = detail::border_vertices(mesh.faces, mesh.positions.size());
    return 20 * static_cast<std::size_t>(std::count(is_border.begin(), is_border.end(), 1)) >= mesh.positions.size();
  }

  /// Narrow gaps between borders keep a mesh from getting small: what rounding has taken apart can't merge.
  void warn_of_gaps() {
    if (keeps_meshes(plan_.scene)) return;  // they are not welded to each other
    const bool is_advised =
        outcome_.shortfall && outcome_.shortfall->advice && outcome_.shortfall->advice->names("--weld auto");
    const bool is_welded_exactly = plan_.request.reading.weld && plan_.scene.weld_tolerance == 0;
    if (is_advised || !is_welded_exactly || !has_much_border()) return;
    IndexedMesh mesh = plan_.scene.read.mesh;
    const double tolerance = io::find_border_gaps(mesh).tolerance();
    if (tolerance == 0) return;
    const std::size_t n_welded = io::weld_gaps(mesh, tolerance).welded_vertices;
    if (n_welded == 0) return;
    add(RunWarningKind::border_gaps, "gaps between borders; '--weld auto' welds " + std::to_string(n_welded) +
                                         " vertices that lie at most " + significant(tolerance) + " apart");
  }

  void warn_of_new_intersections() {
    const bool is_refused = plan_.request.self_intersections == SelfIntersections::refuse;
    const auto warn = [&](const std::string& text, const std::string& advice) {
      if (!text.empty()) add(RunWarningKind::new_intersections, text + (is_refused ? "" : advice));
    };
    const NewIntersections found = find_new_intersections(plan_.scene.read.mesh, simplified(), plan_.threads());
    warn(found.of_parts, "; '--self-intersections refuse' keeps parts apart");
    warn(found.of_walls, "; '--self-intersections refuse' prevents it");
  }

  const Plan& plan_;
  const Outcome& outcome_;
  std::vector<RunWarning> warnings_;
};

}  // namespace

std::vector<RunWarning> find_warnings(const Plan& plan, const Outcome& outcome) {
  return WarningFinder(plan, outcome).find();
}

std::vector<std::string> all_warnings(const Plan& plan, const Outcome& outcome) {
  std::vector<std::string> all = plan.scene.warnings;
  all.insert(all.end(), plan.warnings.begin(), plan.warnings.end());
  for (const RunWarning& warning : outcome.warnings) all.push_back(warning.text);
  if (outcome.shortfall) all.push_back(shortfall_text(plan, outcome));
  return all;
}

}  // namespace whittle
