#include "whittle/pipeline/plan.hh"

#include <limits>
#include <utility>

#include "plan/charts.hh"
#include "plan/names.hh"
#include "plan/simplify_options.hh"
#include "plan/tolerance_map.hh"
#include "run/per_mesh.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/text/text.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/scene/errors.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {
namespace {

/// Leaves positions, faces, and what the file says of these.
void drop_attributes(io::ReadResult& read) {
  IndexedMesh& mesh = read.mesh;
  mesh.wedges.clear();
  mesh.normals.clear();
  mesh.colors.clear();
  mesh.attributes.clear();
  mesh.face_attributes.clear();
  mesh.face_groups.clear();
  mesh.group_names.clear();
  const bool has_float32_positions = read.notes.has_float32_positions;
  read.notes = {};
  read.notes.has_float32_positions = has_float32_positions;
}

void set_target(Plan& plan) {
  const IndexedMesh& mesh = plan.scene.read.mesh;
  const Targets& targets = plan.request.targets;
  plan.target = resolve(targets, mesh.positions.size(), mesh.faces.size(), plan.diagonal);
  if (!plan.request.is_per_mesh || !plan.has_faces()) return;
  plan.targets_per_mesh = targets_per_mesh(targets, plan.scene, plan.diagonal);
  plan.target = sum_of(plan.targets_per_mesh);
}

/// Drops small parts from the scene.
void prune(Plan& plan) {
  if (!plan.request.prune) return;
  io::ReadResult& read = plan.scene.read;
  PrunedMesh pruned = without_small_parts(std::move(read.mesh), plan.request.prune->in_units(plan.diagonal));
  if (pruned.mesh.faces.empty()) {
    throw UnsupportedMesh(plan.scene.name + ": nothing is left without the parts smaller than " +
                          to_string(*plan.request.prune) + "; choose a smaller --prune");
  }
  for (Index& v : read.vertex_map) v = v == invalid_index ? v : pruned.vertex_map[v];
  read.mesh = std::move(pruned.mesh);
  plan.n_pruned_parts = pruned.n_dropped_parts;
  if (pruned.n_dropped_parts == 0) return;
  plan.notes.push_back(about(plan.scene.name, "dropped " +
                                                  counted(pruned.n_dropped_parts, "small part", "small parts") + ", " +
                                                  faces_text(pruned.n_dropped_faces)));
}

/// Those of the tolerance map, else those that the file has.
std::vector<double> tolerances_of(Plan& plan) {
  const io::ReadResult& read = plan.scene.read;
  if (!plan.target.error_limit()) return {};
  if (plan.request.tolerance_map) return read_tolerance_map(*plan.request.tolerance_map, read, plan.diagonal);
  std::vector<double> tolerances = tolerances_of_file(read, plan.scene.name);
  if (!tolerances.empty()) plan.notes.push_back(about(plan.scene.name, "keeps to its vertices' property 'tolerance'"));
  return tolerances;
}

/// Of threshold pairs, model units. Warns if it is automatic and no parts lie near one another.
double find_threshold(Plan& plan) {
  const AutomaticLength& threshold = plan.request.threshold;
  if (!threshold.is_automatic) return threshold.length.in_units(plan.diagonal);
  const double found = automatic_threshold(plan.scene.read.mesh, plan.threads());
  if (found == 0) {
    plan.warnings.push_back(
        about(plan.scene.name, "no parts lie near one another, '--threshold auto' contracts edges alone"));
  }
  return found;
}

void warn_of_charts(Plan& plan) {
  if (!has_chart_per_face(plan.scene.read.mesh)) return;
  plan.warnings.push_back(
      about(plan.scene.name,
            "each triangle is a chart of its own on the texture, so each edge is a seam: neither texture nor shape can "
            "be kept well; '--attributes position-only' drops the texture and keeps the shape, and a texture baked "
            "anew in larger charts keeps both"));
}

/// Sets what depends on the mesh, and what depends on the effort.
void settle_options(Plan& plan) {
  const Request& request = plan.request;
  SimplifyOptions& options = plan.options = simplify_options(request);
  DecimateOptions& decimate = options.decimate;
  if (const double threshold = plan.has_faces() ? find_threshold(plan) : 0; threshold > 0) {
    decimate.pairs.threshold = threshold;
  }
  if (plan.diagonal > 0) {
    decimate.feature_tolerance = request.feature_tolerance.in_units(plan.diagonal) / plan.diagonal;
  }
  decimate.threads = plan.threads();
  decimate.keep_steps = request.keeps_steps;
  if (request.decimater) options.pauses = std::vector<double>{};
  options = with_effort(request.effort, std::move(options), plan.scene.read.mesh, plan.target);
}

}  // namespace

RunProgress run_progress(const Progress& progress) {
  return {progress.stage == Stage::polish ? "polishing" : "decimating", progress.fraction, progress.n_faces,
          progress.surface};
}

SimplifyOptions options_by_effort(const Request& request) {
  SimplifyOptions options = simplify_options(request);
  // How long it is depends on the mesh. The effort depends only on whether there is one.
  if (request.has_threshold()) options.decimate.pairs.threshold = std::numeric_limits<double>::infinity();
  return with_effort(request.effort, std::move(options));
}

Plan plan(Scene scene, const Request& request) {
  Plan plan{std::move(scene), request};
  if (!request.keeps_attributes) drop_attributes(plan.scene.read);
  take_categories(request.categories, plan.scene);
  if (plan.has_faces()) plan.diagonal = diagonal_of(plan.scene.read.mesh.positions);
  set_target(plan);
  warn_of_charts(plan);
  if (plan.has_faces()) {
    check_regions(request.simplify.decimate.regions, plan.scene);
    prune(plan);
  }
  if (plan.has_faces() && request.proves()) {
    plan.stretch = widest_stretch(plan.scene);
    const bool is_shown = request.proves_file() && keeps_meshes(plan.scene, request.output);
    if (is_shown) plan.shown = shown_scene(plan.scene, request.reading);
  }
  std::vector<std::uint8_t> held = held_borders(plan.scene, plan.scene.read.mesh, plan.threads(), plan.warnings);
  std::vector<double> tolerances = tolerances_of(plan);
  for (double& tolerance : tolerances) tolerance /= plan.stretch;
  settle_options(plan);
  plan.options.decimate.locked = std::move(held);
  plan.options.decimate.tolerances = std::move(tolerances);
  return plan;
}

}  // namespace whittle
