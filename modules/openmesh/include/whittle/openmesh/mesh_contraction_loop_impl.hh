#pragma once

#include <algorithm>
#include <utility>

#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/mesh_contraction_loop.hh"
#include "whittle/openmesh/pair_decimater.hh"

namespace whittle {

template <class MeshT>
MeshContractionLoopT<MeshT>::MeshContractionLoopT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target,
                                                  bool only_selected)
    : decimater_(decimater),
      mesh_(decimater.mesh()),
      target_(target),
      only_selected_(only_selected),
      flip_limit_(decimater.max_normal_flip_deg()),
      min_radius_ratio_(decimater.min_radius_ratio()),
      link_condition_(mesh_),
      feature_lines_(mesh_, feature_tolerance()),
      versions_(mesh_.n_halfedges()),
      is_waiting_(mesh_.n_halfedges()) {
  if (const auto limit = target.cost_limit()) {
    cost_limit_ = decimater.cost_->frame().cost_to_frame(*limit, decimater.cost_->cost_dimension());
  }
  const auto counts = decimater.count_elements();
  result_.n_vertices = counts.vertices;
  result_.n_faces = counts.faces;
  const std::vector<Index> firsts = first_copies(mesh_);
  has_copies_.resize(firsts.size());
  for (Index v = 0; v < firsts.size(); ++v) {
    if (firsts[v] != v) has_copies_[v] = has_copies_[firsts[v]] = true;
  }
}

/// In the unit of `position_of`.
template <class MeshT>
double MeshContractionLoopT<MeshT>::feature_tolerance() const {
  const double tolerance = decimater_.feature_tolerance_ * mesh_bounds(mesh_).diagonal();
  return is_foreign() ? tolerance : tolerance * decimater_.cost_->frame().scale;
}

template <class MeshT>
DecimateResult MeshContractionLoopT<MeshT>::run() {
  fill_queue();
  std::optional<StopReason> stop;
  while (!stop) {
    if (target_reached()) {
      stop = StopReason::target;
    } else if (const std::optional<Entry> entry = next_entry()) {
      stop = take_turn(*entry);
    } else {
      stop = StopReason::exhausted;
    }
  }
  result_.stop = *stop;
  return result_;
}

// Queue ---------------------------------------------------------------------------------------------------------------

template <class MeshT>
void MeshContractionLoopT<MeshT>::fill_queue() {
  for (const OpenMesh::EdgeHandle e : mesh_.edges()) {
    enqueue(mesh_.halfedge_handle(e, 0));
    if (is_foreign()) enqueue(mesh_.halfedge_handle(e, 1));
  }
}

template <class MeshT>
void MeshContractionLoopT<MeshT>::enqueue(HalfedgeHandle candidate) {
  const auto number = static_cast<std::size_t>(candidate.idx());
  ++versions_[number];
  const std::optional<Move> move = move_of(candidate);
  is_waiting_[number] = !move;
  if (!move) return;
  const int survivor = mesh_.to_vertex_handle(move->to_survivor).idx();
  const int removed = mesh_.from_vertex_handle(move->to_survivor).idx();
  queue_.push(
      {move->cost, std::min(survivor, removed), std::max(survivor, removed), survivor, candidate, versions_[number]});
}

template <class MeshT>
bool MeshContractionLoopT<MeshT>::target_reached() const {
  return target_.is_reached_at(result_.n_faces, result_.n_vertices);
}

template <class MeshT>
std::optional<typename MeshContractionLoopT<MeshT>::Entry> MeshContractionLoopT<MeshT>::next_entry() {
  while (!queue_.empty()) {
    const Entry entry = queue_.top();
    queue_.pop();
    const bool is_deleted = mesh_.status(mesh_.edge_handle(entry.candidate)).deleted();
    if (!is_deleted && entry.version == versions_[static_cast<std::size_t>(entry.candidate.idx())]) return entry;
  }
  return std::nullopt;
}

template <class MeshT>
std::optional<StopReason> MeshContractionLoopT<MeshT>::take_turn(const Entry& entry) {
  std::optional<Move> move = move_of(entry.candidate);
  if (!move || move->cost > entry.cost) {  // a module has locked or changed something meanwhile
    enqueue(entry.candidate);
    return std::nullopt;
  }
  if (is_too_dear(move->cost)) return StopReason::cost;
  const Refusal refusal = place(*move);
  if (refusal != Refusal::none) {
    count(refusal);
    is_waiting_[static_cast<std::size_t>(entry.candidate.idx())] = true;
    return std::nullopt;
  }
  if (move->cost > entry.cost) {  // it waits until that is its turn
    queue_.push({move->cost, entry.low, entry.high, entry.survivor, entry.candidate, entry.version});
    return std::nullopt;
  }
  if (is_too_dear(move->cost)) return StopReason::cost;
  contract(*move);
  if (!decimater_.notify_observer(result_.n_contractions)) return StopReason::cancelled;
  return std::nullopt;
}

// Costs ---------------------------------------------------------------------------------------------------------------

/// Where v̄ may go; nothing if neither vertex may leave its place along this edge.
template <class MeshT>
std::optional<Pinned> MeshContractionLoopT<MeshT>::pinned(VertexHandle first, VertexHandle second,
                                                          HalfedgeHandle edge) const {
  const EdgeHandle e = mesh_.edge_handle(edge);
  const bool first_may_move = !is_fixed(first) && feature_lines_.may_move(first, e);
  const bool second_may_move = !is_fixed(second) && feature_lines_.may_move(second, e);
  if (!first_may_move && !second_may_move) return std::nullopt;
  if (!first_may_move) return Pinned::first;
  if (!second_may_move) return Pinned::second;
  return feature_lines_.is_feature(e) ? Pinned::either : Pinned::none;
}

/// Of a feature edge, the end that goes to the other's place.
template <class MeshT>
OpenMesh::VertexHandle MeshContractionLoopT<MeshT>::moved_vertex(const CollapseInfo& collapse, const Vec3& to) const {
  if (is_foreign()) return collapse.v0;
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  const Pinned where = pinned(first, second, collapse.v0v1).value_or(Pinned::first);
  if (where == Pinned::second) return first;  // even if both are in one place
  return where == Pinned::first || to == position_of(first) ? second : first;
}

/// The higher index survives, as in the engine, unless the lower may not vanish.
template <class MeshT>
typename MeshContractionLoopT<MeshT>::Move MeshContractionLoopT<MeshT>::move_by_own_cost(
    HalfedgeHandle candidate) const {
  const VertexHandle from = mesh_.from_vertex_handle(candidate);
  const VertexHandle to = mesh_.to_vertex_handle(candidate);
  const auto [first, second] = std::minmax(from, to);
  const Pinned where = pinned(first, second, candidate).value_or(Pinned::first);  // refused when its turn comes
  const VertexHandle survivor = where == Pinned::first ? first : second;
  const PairEvaluation evaluation = decimater_.cost_->evaluate(first, second, where);
  return {survivor == to ? candidate : mesh_.opposite_halfedge_handle(candidate), evaluation, evaluation.position,
          evaluation.cost};
}

/// Modules of OpenMesh's are written for collapses that its decimaters call legal: v1 keeps its place, a border vertex
/// stays on the border. They are asked about no others.
template <class MeshT>
std::optional<typename MeshContractionLoopT<MeshT>::Move> MeshContractionLoopT<MeshT>::move_by_foreign_cost(
    HalfedgeHandle candidate) {
  const CollapseInfo collapse(mesh_, candidate);
  if (is_fixed(collapse.v0)) {
    count(Refusal::locked);
    return std::nullopt;
  }
  if (!feature_lines_.may_move(collapse.v0, mesh_.edge_handle(candidate))) {
    count(Refusal::feature);
    return std::nullopt;
  }
  if (!link_condition_(candidate) || !decimater_.is_collapse_legal(collapse)) {
    count(Refusal::link);
    return std::nullopt;
  }
  const float priority = decimater_.foreign_cost_->collapse_priority(collapse);
  if (priority >= 0) return Move{candidate, {priority, priority, to_vec3(collapse.p1)}, to_vec3(collapse.p1), priority};
  decimater_.count_rejection(*decimater_.foreign_cost_);
  return std::nullopt;
}

template <class MeshT>
Vec3 MeshContractionLoopT<MeshT>::position_of(VertexHandle v) const {
  return is_foreign() ? to_vec3(mesh_.point(v)) : decimater_.cost_->position(v);
}

template <class MeshT>
Vec3 MeshContractionLoopT<MeshT>::to_model(const Vec3& position) const {
  return is_foreign() ? position : decimater_.cost_->frame().to_model(position);
}

// Guards --------------------------------------------------------------------------------------------------------------

/// Where the cost is least is second best, if the best place is refused.
template <class MeshT>
typename MeshContractionLoopT<MeshT>::Refusal MeshContractionLoopT<MeshT>::place(Move& move) {
  const CollapseInfo collapse(mesh_, move.to_survivor);
  if (is_foreign()) return find_refusal_at(move.position, collapse);  // the pair has been tested by now
  Refusal refusal = find_refusal_of_pair(collapse);
  if (refusal != Refusal::none) return refusal;
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  const Vec3 best = decimater_.cost_->place(first, second, move.evaluation);
  if (best != move.position && find_refusal_at(best, collapse) == Refusal::none) {
    move.position = best;
  } else {
    refusal = find_refusal_at(move.position, collapse);
  }
  if (refusal == Refusal::none) {
    move.cost = decimater_.cost_->final_cost(first, second, move.evaluation, move.position);
  }
  return refusal;
}

template <class MeshT>
typename MeshContractionLoopT<MeshT>::Refusal MeshContractionLoopT<MeshT>::find_refusal_at(
    const Vec3& to, const CollapseInfo& collapse) {
  if (feature_lines_.bends_a_line(collapse, moved_vertex(collapse, to), to, positions())) return Refusal::feature;
  if (any_moved_face(mesh_, collapse, to, positions(), turns_beyond(flip_limit_))) return Refusal::flip;
  if (min_radius_ratio_ > 0 && any_moved_face(mesh_, collapse, to, positions(), gets_thinner_than(min_radius_ratio_))) {
    return Refusal::shape;
  }
  return modules_refuse(collapse, to) ? Refusal::module : Refusal::none;
}

template <class MeshT>
typename MeshContractionLoopT<MeshT>::Refusal MeshContractionLoopT<MeshT>::find_refusal_of_pair(
    const CollapseInfo& collapse) {
  if (!pinned(collapse.v0, collapse.v1, collapse.v0v1)) {
    return is_fixed(collapse.v0) && is_fixed(collapse.v1) ? Refusal::locked : Refusal::feature;
  }
  return link_condition_(collapse.v0v1) ? Refusal::none : Refusal::link;
}

/// A guard of OpenMesh's looks at the faces of v0 with v0 at p1. So it is asked with v̄ for p1; and where v1 moves,
/// about v1's faces too, as if v1 collapsed.
template <class MeshT>
bool MeshContractionLoopT<MeshT>::modules_refuse(const CollapseInfo& collapse, const Vec3& to) {
  if (decimater_.foreign_guards_.empty()) return false;
  CollapseInfo forward = collapse;
  CollapseInfo backward(mesh_, collapse.v1v0);
  const bool v1_moves = to != position_of(collapse.v1);
  if (v1_moves) forward.p1 = backward.p1 = to_point<typename MeshT::Point>(to_model(to));
  for (Module* module : decimater_.foreign_guards_) {
    if (module->collapse_priority(forward) >= 0 && (!v1_moves || module->collapse_priority(backward) >= 0)) continue;
    refusing_module_ = module;
    return true;
  }
  return false;
}

template <class MeshT>
void MeshContractionLoopT<MeshT>::count(Refusal refusal) {
  result_.rejections.locked += refusal == Refusal::locked;
  result_.rejections.link += refusal == Refusal::link;
  result_.rejections.flip += refusal == Refusal::flip;
  result_.rejections.feature += refusal == Refusal::feature;
  result_.rejections.shape += refusal == Refusal::shape;
  if (refusal == Refusal::module) decimater_.count_rejection(*refusing_module_);
}

// Contraction ---------------------------------------------------------------------------------------------------------

template <class MeshT>
void MeshContractionLoopT<MeshT>::contract(const Move& move) {
  const VertexHandle survivor = mesh_.to_vertex_handle(move.to_survivor);
  const VertexHandle removed = mesh_.from_vertex_handle(move.to_survivor);
  const CollapseInfo collapse(mesh_, move.to_survivor);
  const auto* own = decimater_.cost_;
  const double cost = own ? own->frame().cost_to_model(move.cost, own->cost_dimension()) : move.cost;
  feature_lines_.note_collapse(collapse, moved_vertex(collapse, move.position), positions());
  result_.n_faces -= decimater_.contract(move.to_survivor, move.evaluation, move.position);
  --result_.n_vertices;
  ++result_.n_contractions;
  result_.max_cost = std::max(result_.max_cost, cost);
  if (decimater_.listener_) {
    decimater_.listener_(
        {static_cast<Index>(survivor.idx()), static_cast<Index>(removed.idx()), to_model(move.position), cost});
  }
  find_affected(survivor, {collapse.vl, collapse.vr});
  for (const HalfedgeHandle candidate : affected_) enqueue(candidate);
}

/// Candidates that the contraction may have made cheaper or allowed: with costs of ours those in their reach, and what
/// waits around the merged vertex; with a foreign cost, which may look at whole stars, all around it. Modules may look
/// at the valences of opposite corners, so what waits around the wings is asked anew, too.
template <class MeshT>
void MeshContractionLoopT<MeshT>::find_affected(VertexHandle survivor, const std::array<VertexHandle, 2>& wings) {
  affected_.clear();
  const Reach reach = is_foreign() ? Reach::ring : decimater_.cost_->reach();
  const auto add = [this](HalfedgeHandle h, bool only_waiting) {
    if (!only_waiting || is_waiting_[static_cast<std::size_t>(h.idx())]) affected_.push_back(h);
  };
  const auto add_edges_at = [&](VertexHandle v, bool only_waiting) {
    for (const HalfedgeHandle h : mesh_.voh_range(v)) {
      const EdgeHandle e = mesh_.edge_handle(h);
      add(mesh_.halfedge_handle(e, 0), only_waiting);
      if (is_foreign()) add(mesh_.halfedge_handle(e, 1), only_waiting);
    }
  };
  const auto add_edges_around = [&](VertexHandle v, bool only_waiting) {
    for (const VertexHandle neighbour : mesh_.vv_range(v)) add_edges_at(neighbour, only_waiting);
  };
  add_edges_at(survivor, false);
  add_edges_around(survivor, reach < Reach::ring);
  if (reach == Reach::opposite_rings || !decimater_.foreign_guards_.empty()) {
    for (const VertexHandle wing : wings) {
      if (wing.is_valid()) add_edges_around(wing, reach < Reach::opposite_rings);
    }
  }
  std::sort(affected_.begin(), affected_.end());
  affected_.erase(std::unique(affected_.begin(), affected_.end()), affected_.end());
}

}  // namespace whittle
