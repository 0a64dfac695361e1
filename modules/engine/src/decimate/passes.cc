#include "decimate/passes.hh"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "attributes/wedge_map.hh"
#include "cost/rim_edges.hh"
#include "cost/seam_planes.hh"
#include "decimate/changes.hh"
#include "decimate/checks.hh"
#include "decimate/input_lines.hh"
#include "decimate/line_courses.hh"
#include "decimate/output.hh"
#include "loop/contraction_log.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {

/// Asks the progress callback between the stages before the first contraction.
class Preparation {
 public:
  explicit Preparation(const DecimateOptions& options) : options_(options) {}

  bool goes_on(std::uint64_t n_vertices, std::uint64_t n_faces) {
    if (goes_on_ && options_.progress) goes_on_ = options_.progress({n_vertices, n_faces, 0});
    return goes_on_;
  }
  /// For tasks before: they throw `Cancelled` where it doesn't go on.
  ProgressCallback task_progress(std::uint64_t n_vertices, std::uint64_t n_faces) {
    if (!options_.progress) return {};
    return [this, n_vertices, n_faces](const TaskProgress&) { return goes_on(n_vertices, n_faces); };
  }

 private:
  const DecimateOptions& options_;
  bool goes_on_ = true;
};

namespace {

ThresholdPairs threshold_pairs(const IndexedMesh& mesh, const DecimateOptions& options, Preparation& preparation) {
  const auto& [threshold, max_pairs, across_walls] = options.pairs;
  if (!(threshold > 0)) return {};
  try {
    return find_threshold_pairs(mesh.positions, mesh.faces,
                                {*threshold, max_pairs, across_walls, options.threads,
                                 preparation.task_progress(mesh.positions.size(), mesh.faces.size())});
  } catch (const Cancelled&) {
    return {};  // the preparation remembers it
  }
}

ThresholdPairCounts counts_of(const ThresholdPairs& pairs, const DecimateOptions& options) {
  ThresholdPairCounts counts;
  counts.considered = pairs.pairs.size();
  counts.threshold = options.pairs.threshold.value_or(0);
  counts.capped = pairs.capped;
  return counts;
}

SurfaceCounts surface_counts(std::size_t n_components, const NonmanifoldCounts& nonmanifold) {
  return {n_components, nonmanifold.edges, nonmanifold.vertices};
}

/// Parts of the input of which no vertex is left.
std::size_t count_vanished(const Parts& parts, const std::vector<Index>& vertex_map) {
  std::vector<bool> is_left(parts.count);
  for (std::size_t v = 0; v < vertex_map.size(); ++v) {
    if (vertex_map[v] != invalid_index) is_left[parts.part_of[v]] = true;
  }
  return static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), false));
}

/// Fills in components and non-manifold counts of the surface before and after.
void compare_surfaces(const IndexedMesh& input, const NonmanifoldCounts& before, const NonmanifoldCounts& after,
                      const DecimateOptions& options, Decimation& out) {
  out.result.after = surface_counts(find_parts(out.mesh.positions.size(), out.mesh.faces).count, after);
  out.result.before = surface_counts(out.result.after.components, before);
  const bool is_manifold = before.edges == 0 && before.vertices == 0;
  const bool has_pairs = options.pairs.threshold > 0;
  if (!has_pairs && options.topology == Topology::keep && is_manifold) return;  // parts stay parts
  const Parts parts = find_parts(input.positions.size(), input.faces);
  out.result.before.components = parts.count;
  out.result.n_vanished_components = count_vanished(parts, out.vertex_map);
}

std::vector<Warning> warnings_about(const ThresholdPairCounts& pairs) {
  std::vector<Warning> warnings;
  if (pairs.capped) {
    warnings.push_back({WarningKind::pairs_capped,
                        "some vertices had more threshold pairs than max_pairs; the nearest "
                        "were taken"});
  }
  return warnings;
}

/// What a pass does that is cancelled before it starts.
DecimateResult cancelled_at_once(const TriangleComplex& complex) {
  DecimateResult result;
  result.n_vertices = complex.n_vertices();
  result.n_faces = complex.n_faces();
  result.stop = StopReason::cancelled;
  return result;
}

/// The wedges of the input as they are, and the vertex of each; no vertices where each has one wedge.
WedgeMap wedges_of(const IndexedMesh& mesh) {
  WedgeMap map;
  map.of_input.resize(n_wedges(mesh));
  std::iota(map.of_input.begin(), map.of_input.end(), Index{0});
  if (mesh.wedges.empty()) return map;
  map.vertex_of.resize(map.of_input.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) map.vertex_of[mesh.wedge(f, k)] = mesh.faces[f][k];
  }
  return map;
}

/// Adds what was done before to the result of a pass.
void add_earlier(const DecimateResult& earlier, DecimateResult& result) {
  result.n_contractions += earlier.n_contractions;
  result.max_cost = std::max(result.max_cost, earlier.max_cost);
  result.n_degenerate_faces += earlier.n_degenerate_faces;
  result.n_coincident_faces += earlier.n_coincident_faces;
  result.refusals += earlier.refusals;
  result.threshold_pairs.contracted += earlier.threshold_pairs.contracted;
}

}  // namespace

/// What a pass begins with, and what of that is the pass's own.
struct PassStart {
  PassInput input;
  ThresholdPairs found_pairs;
  InputLines found_lines;
  std::vector<std::uint8_t> locked;
  std::vector<Index> areas;
};

Passes::Passes(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host)
    : mesh_(mesh),
      target_(target),
      options_(options),
      host_(host),
      frame_(host && host->state() ? host->state()->frame : Frame::of_points(mesh.positions)) {}

std::string_view Passes::contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan) {
  const std::string_view why_not = why_not_in_blocks(mesh_, target, options_, host_, plan);
  if (!why_not.empty()) return why_not;
  DecimateOptions options = options_;
  if (is_listener_told_at_end()) options.listener = {};
  if (keeps_steps()) reserve_large(done_.steps.contractions, mesh_.positions.size());
  const std::vector<Index> kept_areas = areas().of(target);
  LevelRemainder levels = decimate_in_blocks(
      mesh_, frame_, target, options, plan, {limits_.displacement, keeps_steps() ? &done_.steps : nullptr, kept_areas});
  done_.progress = levels.progress;
  if (levels.is_futile) return "pairs wait for each other all over the mesh";
  done_.is_cancelled = levels.is_cancelled;
  if (!done_.is_cancelled) nonmanifold_before_ = levels.nonmanifold;
  done_.max_cost_in_blocks = levels.result.max_cost;
  done_.result = std::move(levels.result);
  done_.left = std::move(levels);
  return {};
}

/// \param log what the pass did, by the vertices that it began with
void Passes::keep_steps_of_pass(std::span<Contraction> log) {
  tell_by_input(mesh_.positions, frame_, done_.left ? done_.left->origins : std::vector<Index>{}, log);
  done_.steps.contractions.insert(done_.steps.contractions.end(), log.begin(), log.end());
  end_pass(done_.steps);
}

/// \param pass that has ended; what it began with is still there
void Passes::keep_refused_pairs(Pass& pass) {
  const auto input_vertex = [this](Index v) { return done_.left ? done_.left->origins[v] : v; };
  for (const auto& [pair, reason] : pass.refusals()) {
    if (reason) done_.refused.push_back({{input_vertex(pair.a), input_vertex(pair.b)}, *reason});
  }
}

std::vector<DecimateTarget> Passes::stops() const {
  std::vector<DecimateTarget> stops;
  const bool has_count = target_.n_faces() || target_.n_vertices();
  for (const double factor : options_.pauses.at) {
    const DecimateTarget stop = target_.with_counts_times(factor);
    if (has_count && !stop.is_reached_at(n_faces_left(), n_vertices_left())) stops.push_back(stop);
  }
  stops.push_back(target_);
  return stops;
}

/// How much of the way to the target is behind once `stop` is reached, of that which is left now. [0, 1]
double Passes::way_to(const DecimateTarget& stop) const {
  const auto share = [](std::optional<std::uint64_t> from, std::optional<std::uint64_t> to, std::size_t now) {
    if (!from || *to >= now) return 0.0;
    return static_cast<double>(now - std::min<std::uint64_t>(now, *from)) / static_cast<double>(now - *to);
  };
  return std::max(share(stop.n_faces(), target_.n_faces(), n_faces_left()),
                  share(stop.n_vertices(), target_.n_vertices(), n_vertices_left()));
}

void Passes::begin_with_input(PassStart& start, const DecimateOptions& options, Preparation& preparation) {
  start.found_pairs = threshold_pairs(mesh_, options, preparation);
  pairs_ = counts_of(start.found_pairs, options_);
  const bool has_hosted_cost = host_ != nullptr && host_->cost() != nullptr;  // which knows of no seams
  start.found_lines = input_lines(mesh_, options_, options_.holds_seams() || has_hosted_cost);
  start.input.surface = {mesh_.positions, frame_, mesh_.faces};
  start.input.threshold_pairs = start.found_pairs.pairs;
  start.input.lines = &start.found_lines.held;
  const std::vector<VertexPair> rims = held_rims(mesh_, frame_, options_);
  start.input.cost_state.seams = seam_planes(mesh_, frame_, start.found_lines.seams, rims, options_);
  start.input.locked = options_.locked;
}

/// \pre there is one
void Passes::begin_with_remainder(PassStart& start) {
  Remainder& left = *done_.left;
  start.locked = left.of_vertices(options_.locked);
  start.input.surface = {left.positions, Frame{}, left.faces};
  start.input.threshold_pairs = left.threshold_pairs;
  start.input.lines = &left.lines;
  start.input.cost_state = std::move(left.cost_state);
  start.input.context.refusals = left.refusals;
  start.input.locked = start.locked;
}

/// Wedges are as the pass before left them. The first pass that looks at attributes sums them from the input.
void Passes::begin_with_attributes(PassStart& start) {
  SurfaceAttributes& sums = start.input.cost_state.attributes;
  if (sums.wedges.any() || host_ || !looks_at_attributes(options_, mesh_)) return;
  const ScaledAttributes attributes = scaled_attributes(mesh_, frame_, options_.attribute_weights);
  if (attributes.n_components == 0) return;
  WedgeMap map;
  if (done_.left) {
    map = map_wedges(mesh_, done_.left->vertex_map, done_.left->face_origins);
  } else {
    map = wedges_of(mesh_);
  }
  if (map.vertex_of.empty()) {  // a wedge a vertex
    map.vertex_of.resize(n_vertices_left());
    std::iota(map.vertex_of.begin(), map.vertex_of.end(), Index{0});
  }
  const auto& [surface_positions, surface_frame, faces] = start.input.surface;
  std::vector<Vec3> positions(surface_positions.begin(), surface_positions.end());
  for (Vec3& p : positions) p = surface_frame.to_frame(p);
  sums = sum_attributes(mesh_, frame_, attributes, map.of_input, std::move(map.vertex_of), positions, options_.threads);
}

/// Empty where the error alone counts, and with a host, which has guards of its own.
const KeptAreas& Passes::areas() {
  if (areas_) return *areas_;
  areas_.emplace();
  const bool are_kept = !host_ && !target_.error_limit();
  if (are_kept) areas_.emplace(mesh_, seam_areas(mesh_, seam_edges(mesh_, face_regions(mesh_, options_.regions))));
  return *areas_;
}

void Passes::begin_with_areas(PassStart& start, const DecimateTarget& stop) {
  std::vector<Index> of_input = areas().of(stop);
  if (of_input.empty()) return;
  if (done_.left) {
    for (const Index f : done_.left->face_origins) start.areas.push_back(of_input[f]);
  } else {
    start.areas = std::move(of_input);
  }
  start.input.context.areas = {start.input.surface.faces, start.areas, true};
}

DecimateResult Passes::run(Pass& pass, const DecimateTarget& stop, Preparation& preparation) const {
  TriangleComplex& complex = pass.complex();
  DecimateResult result;
  if (!done_.is_cancelled && preparation.goes_on(complex.n_vertices(), complex.n_faces())) {
    pass.start(stop, frame_);
    result = pass.run();
  } else {
    result = cancelled_at_once(complex);
  }
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  return result;
}

/// Of the input. \param pass before its first contraction
void Passes::count_before(Pass& pass) {
  if (nonmanifold_before_) return;
  if (!done_.left) {
    nonmanifold_before_ = pass.complex().count_nonmanifold();
    return;
  }
  nonmanifold_before_ = count_nonmanifold({mesh_.positions, frame_, mesh_.faces});  // blocks not begun are not counted
}

NonmanifoldCounts Passes::count_nonmanifold(const Surface& surface) const {
  TriangleComplex complex(surface.positions, surface.faces, surface.frame, options_.threads);
  complex.connect({}, options_.threads);
  return complex.count_nonmanifold();
}

/// The callbacks are told of a part of the progress, and of the input's vertices. \param end of that part
DecimateOptions Passes::options_of_pass(double end) {
  DecimateOptions options = options_;
  if ((done_.progress > 0 || end < 1) && options.progress) {
    options.progress = [begin = done_.progress, end, callback = options.progress](Progress progress) {
      progress.fraction = begin + (end - begin) * progress.fraction;
      return callback(progress);
    };
  }
  if (is_listener_told_at_end()) options.listener = {};
  if (done_.left && options.listener) {
    options.listener = [this, callback = options.listener](Contraction contraction) {
      contraction.survivor = done_.left->origins[contraction.survivor];
      contraction.removed = done_.left->origins[contraction.removed];
      callback(contraction);
    };
  }
  return options;
}

void Passes::contract_to(const DecimateTarget& stop, bool is_last) {
  const double end = done_.progress + (1 - done_.progress) * way_to(stop);
  const DecimateOptions options = options_of_pass(end);
  Preparation preparation(options);
  PassStart start;
  if (done_.left) {
    begin_with_remainder(start);
  } else {
    begin_with_input(start, options, preparation);
  }
  begin_with_attributes(start);
  begin_with_areas(start, stop);
  start.input.feature_tolerance = options_.feature_tolerance * diagonal_of(mesh_.positions) * frame_.scale;
  start.input.host = host_;
  start.input.context.displacement_limit = limits_.displacement;
  start.input.context.displacement_limits = limits_.displacements;
  start.input.context.error_bound = limits_.error_bound;
  start.input.context.border_bound = limits_.border_bound;
  LargeArray<Contraction> made(keeps_steps() ? n_vertices_left() : 0);
  ContractionLog log{made.data()};
  if (keeps_steps()) start.input.context.log = &log;
  Pass pass(start.input, options);
  count_before(pass);
  DecimateResult result = run(pass, stop, preparation);
  is_last = is_last || (result.stop != StopReason::target && !limits_.displacement);
  done_.progress = end;
  done_.max_cost_of_pass = result.max_cost;
  add_earlier(done_.result, result);
  done_.result = std::move(result);
  if (keeps_steps()) keep_steps_of_pass({made.data(), log.end});
  done_.refused.clear();
  if (done_.result.stop == StopReason::exhausted) keep_refused_pairs(pass);
  if (is_last) done_.nonmanifold = pass.complex().count_nonmanifold();
  done_.left = remainder_of(pass, start.input.surface.faces, done_.left ? &*done_.left : nullptr,
                            {.what_to_go_on_from = !is_last, .quadrics = options_.keep_quadrics});
}

bool Passes::is_beyond_target() const {
  return done_.max_cost_in_blocks && is_exact_in_blocks(options_) && done_.result.stop == StopReason::target &&
         !(*done_.max_cost_in_blocks < done_.max_cost_of_pass);
}

bool Passes::adjust() {
  Remainder& left = *done_.left;
  Decimation paused = geometry_of(mesh_, left.geometry(), frame_);
  paused.result = done_.result;
  const std::vector<Vec3> before = paused.mesh.positions;
  const std::size_t n_faces = paused.mesh.faces.size();
  const bool goes_on = options_.pauses.adjust(paused);
  if (paused.mesh.positions.size() != before.size() || paused.mesh.faces.size() != n_faces) {
    throw std::invalid_argument("decimate: a pause changed the number of vertices or faces");
  }
  check(paused.mesh);
  PassEnd changes;
  if (keeps_steps()) changes.turned = turned_faces(left.faces, paused.mesh.faces, left.origins, left.face_origins);
  left.faces = std::move(paused.mesh.faces);
  const std::vector<Vec3> positions_before = left.positions;
  for (Index v = 0; v < before.size(); ++v) {
    if (paused.mesh.positions[v] == before[v]) continue;
    const Vec3 position = frame_.to_frame(paused.mesh.positions[v]);
    left.positions[v] = position;
    const Index origin = left.origins[v];
    if (keeps_steps()) changes.moved.push_back({origin, to_output(position, mesh_.positions[origin], frame_)});
  }
  left.cost_state.move_origins(positions_before, left.positions);
  if (!left.lines.edges.empty()) find_courses(mesh_, frame_, input_features(mesh_, options_), left);
  if (keeps_steps()) {
    changes.n_contractions = done_.steps.contractions.size();
    done_.steps.pass_ends.back() = std::move(changes);
  }
  return goes_on;
}

void Passes::forget_all() {
  done_ = {};
  done_.progress = 1;
}

Decimation Passes::output(bool keeps_in_charts) {
  if (!done_.nonmanifold) {
    done_.nonmanifold = count_nonmanifold({done_.left->positions, Frame{}, done_.left->faces});
  }
  Decimation out = geometry_of(mesh_, std::move(*done_.left), frame_);
  if (options_.keep_steps) {
    out.steps = std::move(done_.steps);
    if (options_.normals == Normals::recompute) out.steps.crease_angle_deg = options_.crease_angle_deg;
  }
  carry_attributes(mesh_, frame_, options_.normals, out.vertex_map, out.face_origins, out.mesh, options_.threads,
                   keeps_in_charts);
  out.result = std::move(done_.result);
  for (const auto& [pair, reason] : done_.refused) {
    const auto [a, b] = std::minmax(out.vertex_map[pair.a], out.vertex_map[pair.b]);
    if (b != invalid_index) out.refused_pairs.push_back({{a, b}, reason});
  }
  pairs_.contracted = out.result.threshold_pairs.contracted;
  out.result.threshold_pairs = pairs_;
  out.result.warnings = warnings_about(pairs_);
  compare_surfaces(mesh_, *nonmanifold_before_, *done_.nonmanifold, options_, out);
  return out;
}

}  // namespace whittle
