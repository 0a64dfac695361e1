#pragma once

#include "whittle/core/geometry/box.hh"
#include "whittle/openmesh/detail/feature_bits.hh"
#include "whittle/openmesh/placing_module.hh"

namespace whittle {

template <class MeshT>
void PlacingModuleT<MeshT>::require(bool condition, const std::string& what) const {
  if (!condition) throw std::invalid_argument("Mod" + this->name() + "T: " + what);
}

template <class MeshT>
void PlacingModuleT<MeshT>::set_max_cost(double max_cost) {
  require(max_cost >= 0, "max_cost is negative or not a number");
  max_cost_ = max_cost;
}

template <class MeshT>
void PlacingModuleT<MeshT>::set_valence_weight(double weight) {
  require(weight >= 0 && std::isfinite(weight), "valence_weight is negative or not finite");
  valence_weight_ = weight;
  note_new_options();
}

template <class MeshT>
std::optional<double> PlacingModuleT<MeshT>::max_cost() const {
  if (!max_cost_) return std::nullopt;
  return *max_cost_ * this->error_tolerance_factor_;
}

template <class MeshT>
std::optional<CostOptions> PlacingModuleT<MeshT>::engine_options() const {
  CostOptions options = plain_options();
  options.valence_weight = active_valence_weight_;
  return options;
}

template <class MeshT>
void PlacingModuleT<MeshT>::adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics,
                                  bool /*were_collapses*/) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    numbers_[VertexHandle(static_cast<int>(vertices[i]))] = static_cast<Index>(i);
  }
  quadrics_ = std::move(quadrics);
  has_quadrics_ = true;
  for (const VertexHandle v : mesh_.vertices()) {
    if (mesh_.is_isolated(v)) add_vertex(v);
  }
}

template <class MeshT>
void PlacingModuleT<MeshT>::initialize() {
  active_valence_weight_ = valence_weight_;
  has_new_options_ = false;
  pending_.reset();
  frame_ = frame_of_mesh();
  has_quadrics_ = false;
}

template <class MeshT>
Frame PlacingModuleT<MeshT>::frame_of_mesh() const {
  for (const VertexHandle v : mesh_.vertices()) {
    if (to_vec3(mesh_.point(v)).allFinite()) continue;
    require(false, "vertex " + std::to_string(v.idx()) + " has a coordinate that is not finite");
  }
  return Frame::of_box(mesh_bounds(mesh_));
}

template <class MeshT>
void PlacingModuleT<MeshT>::make_quadrics() const {
  has_quadrics_ = true;
  quadrics_.clear();
  quadrics_.reserve(mesh_.n_vertices());
  for (const VertexHandle v : mesh_.vertices()) add_vertex(v);
  add_planes();
}

/// Its quadric has no planes yet.
template <class MeshT>
void PlacingModuleT<MeshT>::add_vertex(VertexHandle v) const {
  numbers_[v] = static_cast<Index>(quadrics_.size());
  quadrics_.push_back({frame_.to_frame(to_vec3(mesh_.point(v))), {}});
}

// Evaluation ----------------------------------------------------------------------------------------------------------

template <class MeshT>
PairEvaluation PlacingModuleT<MeshT>::evaluate(VertexHandle first, VertexHandle second,
                                               PairConstraint constraint) const {
  PairEvaluation evaluation = evaluate_plain(first, second, constraint);
  if (active_valence_weight_ > 0 && evaluation.cost >= 0) {  // others are refused
    evaluation.cost = valence_change(first, second).penalize(evaluation.cost, active_valence_weight_);
  }
  return evaluation;
}

template <class MeshT>
ValenceChange PlacingModuleT<MeshT>::valence_change(VertexHandle first, VertexHandle second) const {
  ValenceChange change;
  int n_common = 0;
  const OpenMesh::HalfedgeHandle h = mesh_.find_halfedge(first, second);
  for (const OpenMesh::HalfedgeHandle side : {h, mesh_.opposite_halfedge_handle(h)}) {
    if (mesh_.is_boundary(side)) continue;
    ++n_common;
    const VertexHandle wing = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(side));
    const int valence = static_cast<int>(mesh_.valence(wing));
    change.add_before(valence, mesh_.is_boundary(wing));
    change.add_after(valence - 1, mesh_.is_boundary(wing));
  }
  const int valence_first = static_cast<int>(mesh_.valence(first));
  const int valence_second = static_cast<int>(mesh_.valence(second));
  const bool first_on_border = mesh_.is_boundary(first);
  const bool second_on_border = mesh_.is_boundary(second);
  change.add_before(valence_first, first_on_border);
  change.add_before(valence_second, second_on_border);
  change.add_after(valence_first + valence_second - 2 - n_common, first_on_border || second_on_border);
  return change;
}

template <class MeshT>
PairEvaluation PlacingModuleT<MeshT>::evaluate(const CollapseInfo& collapse) const {
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  PairEvaluation evaluation = evaluate_cheapest(collapse);
  if (!is_cost(evaluation.cost)) return evaluation;
  const Vec3 position = this->place(first, second, evaluation);
  evaluation.cost = this->final_cost(first, second, evaluation, position);
  evaluation.position = position;
  return evaluation;
}

/// The evaluation at the position of least cost, before `place` and `final_cost`.
template <class MeshT>
PairEvaluation PlacingModuleT<MeshT>::evaluate_cheapest(const CollapseInfo& collapse) const {
  // OpenMesh collapses a feature v0 along feature edges only. Then v̄ must stay on that line.
  const auto& at_v1 = mesh_.status(collapse.v1);
  const bool v1_stays = at_v1.locked() || at_v1.feature() || mesh_.status(collapse.v0).feature();
  const bool v1_is_first = collapse.v1 < collapse.v0;
  const PairConstraint constraint = !v1_stays     ? PairConstraint::none
                                    : v1_is_first ? PairConstraint::first
                                                  : PairConstraint::second;
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  PairEvaluation evaluation = evaluate(first, second, constraint);
  if (v1_stays) evaluation.position = position(collapse.v1);  // exactly: sums may have rounded it
  return evaluation;
}

// Collapses in OpenMesh's decimaters ----------------------------------------------------------------------------------

template <class MeshT>
float PlacingModuleT<MeshT>::collapse_priority(const CollapseInfo& collapse) {
  const double cost = evaluate(collapse).cost;
  const double dimension = this->cost_dimension();
  const auto limit = max_cost();
  const bool is_legal = is_cost(cost) && !(limit && cost > frame_.cost_to_frame(*limit, dimension));
  own_priority_ = is_legal ? priority_of_cost(cost, dimension) : static_cast<float>(ModBase::ILLEGAL_COLLAPSE);
  return *own_priority_;
}

/// Moves v1 before the collapse, but after `preprocess_collapse` of the other modules. Until our `postprocess_collapse`
/// the decimater and the other modules compute face normals and more: these then use the position of the merged vertex.
template <class MeshT>
void PlacingModuleT<MeshT>::preprocess_collapse(const CollapseInfo& collapse) {
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  if (!pending_) {
    const PairEvaluation evaluation = evaluate_cheapest(collapse);
    place_next(evaluation, this->place(first, second, evaluation), first);
  }
  const bool stays = pending_->position == position(collapse.v1);
  if (!attributes_ || !attributes_->fits(mesh_)) attributes_.emplace(mesh_);
  if (!stays) attributes_->merge(mesh_, collapse.v1, collapse.v0, frame_.to_model(pending_->position));
  const bool is_v0_first = pending_->first == collapse.v0;
  merged_ = merge(pending_->first, is_v0_first ? collapse.v1 : collapse.v0, pending_->evaluation, pending_->position);
  carry_feature_bits(mesh_, collapse);
  if (stays) return;  // don't round a vertex that doesn't move
  mesh_.set_point(collapse.v1, to_point<typename MeshT::Point>(frame_.to_model(pending_->position)));
}

template <class MeshT>
void PlacingModuleT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  placed(collapse.v1) = merged_;
  pending_.reset();
}

}  // namespace whittle
