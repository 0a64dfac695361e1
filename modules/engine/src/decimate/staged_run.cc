#include "decimate/staged_run.hh"

#include <algorithm>
#include <utility>

#include "whittle/core/parts.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {

StagedRun::StagedRun(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                     DecimationHost* host)
    : mesh_(mesh),
      target_(target),
      options_(options),
      host_(host),
      frame_(host && host->state() ? host->state()->frame : Frame::of_points(mesh.positions)),
      state_{input(), {}} {}

/// The first surface: the mesh, or with a host that goes on, what that knows of it.
WorkingSurface StagedRun::input() const {
  WorkingSurface surface;
  surface.faces = MaybeOwned<Triangle>::borrowed(mesh_.faces);
  const DecimationState* const earlier = host_ ? host_->state() : nullptr;
  if (earlier == nullptr) {
    surface.positions = MaybeOwned<Vec3>::borrowed(mesh_.positions);
    surface.frame = frame_;
    return surface;
  }
  surface.cost_state.face_area = earlier->face_area;
  for (Index v = 0; v < earlier->vertices.size(); ++v) {
    surface.positions.own().push_back(earlier->vertices[v].position);
    surface.cost_state.faces.push_back({v, earlier->vertices[v].quadric});
  }
  return surface;
}

void StagedRun::begin_anew(double progress) {
  state_ = {input(), {}};
  report().progress = progress;
}

std::vector<DecimateTarget> StagedRun::stops() const {
  std::vector<DecimateTarget> stops;
  const bool has_count = target_.n_faces() || target_.n_vertices();
  for (const double factor : options_.pauses.at) {
    const DecimateTarget stop = target_.with_counts_times(factor);
    if (has_count && !stop.is_reached_at(n_faces_left(), n_vertices_left())) stops.push_back(stop);
  }
  stops.push_back(target_);
  return stops;
}

/// Blocks keep the topology: so the parts of what they have left are those of the input.
Topology StagedRun::topology() {
  if (options_.topology != Topology::automatic) return options_.topology;
  if (!topology_) topology_ = !host_ && may_parts_matter() ? Topology::automatic : Topology::keep;
  return *topology_;
}

/// Whether there are several parts, of which the least faces are some of those that are wanted. Parts of few faces are
/// a surface whose faces aren't joined.
bool StagedRun::may_parts_matter() {
  constexpr double least_faces = 4;  // of a tetrahedron
  constexpr double least_share = 0.01;
  n_parts_ = static_cast<double>(find_parts(n_vertices_left(), surface().faces).count);
  const bool is_soup = least_faces * n_parts_ > static_cast<double>(mesh_.faces.size());
  return n_parts_ > 1 && !is_soup && least_faces * n_parts_ >= least_share * n_faces_wanted();
}

double StagedRun::n_faces_wanted() const {
  return target_.share_of(mesh_.faces.size(), mesh_.positions.size()) * static_cast<double>(mesh_.faces.size());
}

DecimateTarget StagedRun::target_with_parts() const {
  constexpr double least_factor = 8;
  constexpr double faces_of_part = 16;
  return target_.with_counts_times(std::max(least_factor, faces_of_part * n_parts_ / std::max(1.0, n_faces_wanted())));
}

/// Empty where the error alone counts, and with a host, which has guards of its own.
const KeptAreas& StagedRun::areas() {
  if (areas_) return *areas_;
  areas_.emplace();
  const bool are_kept = !host_ && !target_.error_limit();
  if (are_kept) areas_.emplace(mesh_, seam_areas(mesh_, seam_edges(mesh_, face_regions(mesh_, options_.regions))));
  return *areas_;
}

DecimateResult StagedRun::contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan,
                                             const StageLimits& limits) {
  const double begin = state_.report.progress;
  StageReport report{.progress = begin};
  report.result.why_in_one_pass = why_not_in_blocks(mesh_, target, options_, host_, plan, is_told());
  if (report.result.why_in_one_pass.empty()) {
    DecimateOptions options = options_;
    options.topology = Topology::keep;
    const double end = begin + (1 - begin) * way_to(target);
    tell_part_of_progress(begin, end, options);
    if (is_listener_told_at_end()) options.listener = {};
    const std::vector<Index> kept_areas = areas().of(target);
    StageContext context{options, frame_};
    context.limits = limits;
    context.areas.of = kept_areas;
    context.keeps_steps = keeps_steps();
    const bool is_first = surface().is_input();
    look_at_attributes_of_input();
    report = whittle::contract_in_blocks(state_.surface, mesh_, target, plan, context);
    report.progress = begin + (end - begin) * report.progress;
    if (is_first) note_nonmanifold(report.result);
  }
  DecimateResult result = report.result;
  state_.report += std::move(report);
  return result;
}

/// Blocks have counted what isn't manifold in the input. \param result theirs
void StagedRun::note_nonmanifold(const DecimateResult& result) {
  if (!result.why_in_one_pass.empty() || result.stop == StopReason::cancelled) return;
  nonmanifold_before_ = {result.before.nonmanifold_edges, result.before.nonmanifold_vertices};
  // Blocks keep the topology.
  if (nonmanifold_before_->edges == 0 && nonmanifold_before_->vertices == 0) {
    state_.surface.nonmanifold = NonmanifoldCounts{};
  }
}

}  // namespace whittle
