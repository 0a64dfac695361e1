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
      link_condition_(mesh_),
      versions_(mesh_.n_halfedges()),
      is_waiting_(mesh_.n_halfedges()) {
  if (target.max_cost) {
    target_.max_cost = decimater.cost_->frame().cost_to_frame(*target.max_cost, decimater.cost_->cost_dimension());
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
  queue_.push({move->evaluation.cost, std::min(survivor, removed), std::max(survivor, removed), survivor, candidate,
               versions_[number]});
}

template <class MeshT>
bool MeshContractionLoopT<MeshT>::target_reached() const {
  return (target_.faces && result_.n_faces <= *target_.faces) ||
         (target_.vertices && result_.n_vertices <= *target_.vertices);
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
  const std::optional<Move> move = move_of(entry.candidate);
  if (!move || move->evaluation.cost > entry.cost) {  // a module has locked or changed something meanwhile
    enqueue(entry.candidate);
    return std::nullopt;
  }
  if (target_.max_cost && move->evaluation.cost > *target_.max_cost) return StopReason::cost;
  const Refusal refusal = find_refusal(*move);
  if (refusal != Refusal::none) {
    count(refusal);
    is_waiting_[static_cast<std::size_t>(entry.candidate.idx())] = true;
    return std::nullopt;
  }
  contract(*move);
  if (!decimater_.notify_observer(result_.n_contractions)) return StopReason::cancelled;
  return std::nullopt;
}

// Costs ---------------------------------------------------------------------------------------------------------------

template <class MeshT>
typename MeshContractionLoopT<MeshT>::Rule MeshContractionLoopT<MeshT>::rule_of(VertexHandle first, VertexHandle second,
                                                                                HalfedgeHandle edge) const {
  const bool first_is_feature = mesh_.status(first).feature();
  const bool second_is_feature = mesh_.status(second).feature();
  const bool along_feature = first_is_feature && second_is_feature && mesh_.status(mesh_.edge_handle(edge)).feature();
  const bool first_stays = is_fixed(first) || (first_is_feature && !along_feature);
  const bool second_stays = is_fixed(second) || (second_is_feature && !along_feature);
  if (first_stays && second_stays) return Rule::refused;
  if (first_stays) return Rule::first_stays;
  if (second_stays) return Rule::second_stays;
  return along_feature ? Rule::along_feature : Rule::free;
}

template <class MeshT>
PairEvaluation MeshContractionLoopT<MeshT>::evaluate(VertexHandle first, VertexHandle second, Rule rule) const {
  const auto evaluate_pinned = [&](Pinned pinned) { return decimater_.cost_->evaluate(first, second, pinned); };
  switch (rule) {
    case Rule::free:
      return evaluate_pinned(Pinned::none);
    case Rule::first_stays:
    case Rule::refused:  // when its turn comes
      return evaluate_pinned(Pinned::first);
    case Rule::second_stays:
      return evaluate_pinned(Pinned::second);
    case Rule::along_feature:
      break;
  }
  const PairEvaluation at_first = evaluate_pinned(Pinned::first);
  const PairEvaluation at_second = evaluate_pinned(Pinned::second);
  return at_first.cost <= at_second.cost ? at_first : at_second;
}

/// The higher index survives, as in the engine, unless the lower may not vanish.
template <class MeshT>
typename MeshContractionLoopT<MeshT>::Move MeshContractionLoopT<MeshT>::move_by_own_cost(
    HalfedgeHandle candidate) const {
  const VertexHandle from = mesh_.from_vertex_handle(candidate);
  const VertexHandle to = mesh_.to_vertex_handle(candidate);
  const auto [first, second] = std::minmax(from, to);
  const Rule rule = rule_of(first, second, candidate);
  const VertexHandle survivor = rule == Rule::first_stays ? first : second;
  return {survivor == to ? candidate : mesh_.opposite_halfedge_handle(candidate), evaluate(first, second, rule)};
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
  if (!link_condition_(candidate) || !decimater_.is_collapse_legal(collapse)) {
    count(Refusal::link);
    return std::nullopt;
  }
  const float priority = decimater_.foreign_cost_->collapse_priority(collapse);
  if (priority >= 0) return Move{candidate, {priority, priority, to_vec3(collapse.p1)}};
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

template <class MeshT>
typename MeshContractionLoopT<MeshT>::Refusal MeshContractionLoopT<MeshT>::find_refusal(const Move& move) {
  const CollapseInfo collapse(mesh_, move.to_survivor);
  if (!is_foreign()) {  // otherwise tested by now
    const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
    if (rule_of(first, second, move.to_survivor) == Rule::refused) return Refusal::locked;
    if (!link_condition_(move.to_survivor)) return Refusal::link;
  }
  if (turns_a_face(collapse, move.evaluation.position)) return Refusal::flip;
  return modules_refuse(collapse, move.evaluation.position) ? Refusal::module : Refusal::none;
}

template <class MeshT>
bool MeshContractionLoopT<MeshT>::turns_a_face(const CollapseInfo& collapse, const Vec3& to) const {
  const auto position = [this](VertexHandle v) { return position_of(v); };
  return is_exceeded_around(flip_limit_, mesh_, collapse.v0, collapse.v1, to, position) ||
         is_exceeded_around(flip_limit_, mesh_, collapse.v1, collapse.v0, to, position);
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
    decimater_.count_rejection(*module);
    return true;
  }
  return false;
}

template <class MeshT>
void MeshContractionLoopT<MeshT>::count(Refusal refusal) {
  result_.rejections.locked += refusal == Refusal::locked;
  result_.rejections.link += refusal == Refusal::link;
  result_.rejections.flip += refusal == Refusal::flip;
}

// Contraction ---------------------------------------------------------------------------------------------------------

template <class MeshT>
void MeshContractionLoopT<MeshT>::contract(const Move& move) {
  const VertexHandle survivor = mesh_.to_vertex_handle(move.to_survivor);
  const VertexHandle removed = mesh_.from_vertex_handle(move.to_survivor);
  const auto* own = decimater_.cost_;
  const double cost =
      own ? own->frame().cost_to_model(move.evaluation.cost, own->cost_dimension()) : move.evaluation.cost;
  result_.n_faces -= decimater_.contract(move.to_survivor, move.evaluation);
  --result_.n_vertices;
  ++result_.n_contractions;
  result_.max_cost = std::max(result_.max_cost, cost);
  if (decimater_.listener_) {
    decimater_.listener_({static_cast<Index>(survivor.idx()), static_cast<Index>(removed.idx()),
                          to_model(move.evaluation.position), cost});
  }
  find_affected(survivor);
  for (const HalfedgeHandle candidate : affected_) enqueue(candidate);
}

/// Candidates that the contraction may have made cheaper or allowed: with costs of ours those at the merged vertex, and
/// what waits around it; with a foreign cost, which may look at whole stars, all around it.
template <class MeshT>
void MeshContractionLoopT<MeshT>::find_affected(VertexHandle survivor) {
  affected_.clear();
  const auto add = [this](HalfedgeHandle h, bool only_waiting) {
    if (!only_waiting || is_waiting_[static_cast<std::size_t>(h.idx())]) affected_.push_back(h);
  };
  const auto add_edge = [&](HalfedgeHandle h, bool only_waiting) {
    const OpenMesh::EdgeHandle e = mesh_.edge_handle(h);
    add(mesh_.halfedge_handle(e, 0), only_waiting);
    if (is_foreign()) add(mesh_.halfedge_handle(e, 1), only_waiting);
  };
  for (const HalfedgeHandle h : mesh_.voh_range(survivor)) {
    add_edge(h, false);
    for (const HalfedgeHandle g : mesh_.voh_range(mesh_.to_vertex_handle(h))) add_edge(g, !is_foreign());
  }
  std::sort(affected_.begin(), affected_.end());
  affected_.erase(std::unique(affected_.begin(), affected_.end()), affected_.end());
}

}  // namespace whittle
