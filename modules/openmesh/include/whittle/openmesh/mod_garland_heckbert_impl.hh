#pragma once

#include <cfloat>

#include "whittle/engine/formula/edge_length_term.hh"
#include "whittle/openmesh/mod_garland_heckbert.hh"

namespace whittle {

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::set_isotropy(double isotropy) {
  this->require(isotropy >= 0 && isotropy <= 1, "isotropy is not in [0, 1]");
  isotropy_ = isotropy;
  this->note_new_options();
}

template <class MeshT>
double ModGarlandHeckbertT<MeshT>::cost_dimension() const {
  const double of_quadric = QuadricModule::cost_dimension();
  return active_isotropy_ > 0 ? isotropic_dimension(of_quadric, active_isotropy_) : of_quadric;
}

template <class MeshT>
std::optional<CostOptions> ModGarlandHeckbertT<MeshT>::engine_options() const {
  if (stock_) return std::nullopt;
  return QuadricModule::engine_options();
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::initialize() {
  this->use_options();
  active_isotropy_ = isotropy_;
  stock_.reset();
  if (arithmetic_ == Arithmetic::stock) {
    stock_.emplace(this->mesh());
    this->forget_new_options();
  } else {
    QuadricModule::initialize();
  }
}

template <class MeshT>
PairEvaluation ModGarlandHeckbertT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second,
                                                          PairConstraint constraint) const {
  if (active_isotropy_ == 0) return QuadricModule::evaluate_plain(first, second, constraint);
  return evaluate_isotropic(placed(first), placed(second), active_isotropy_, active().placement, constraint);
}

// With stock arithmetic -----------------------------------------------------------------------------------------------

template <class MeshT>
float ModGarlandHeckbertT<MeshT>::collapse_priority(const CollapseInfo& collapse) {
  if (!stock_) return QuadricModule::collapse_priority(collapse);
  const double cost = stock_->cost(collapse);
  return static_cast<float>(cost < this->max_cost().value_or(DBL_MAX) ? cost : double{Base::ILLEGAL_COLLAPSE});
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::preprocess_collapse(const CollapseInfo& collapse) {
  if (!stock_) QuadricModule::preprocess_collapse(collapse);
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  if (!stock_) return QuadricModule::postprocess_collapse(collapse);
  stock_->merge(collapse);
}

}  // namespace whittle
