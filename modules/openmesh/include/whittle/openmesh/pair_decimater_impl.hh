#pragma once

#include <stdexcept>
#include <utility>

#include "whittle/openmesh/engine_run.hh"
#include "whittle/openmesh/mesh_contraction_loop.hh"
#include "whittle/openmesh/pair_decimater.hh"

namespace whittle {

// Modules -------------------------------------------------------------------------------------------------------------

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  if (!Base::add(handle)) return false;
  ModuleT& module = Base::module(handle);
  Attached attached{&module, nullptr, nullptr, nullptr};
  if constexpr (std::is_base_of_v<PairCostModuleT<MeshT>, ModuleT>) attached.cost = &module;
  if constexpr (std::is_base_of_v<ModFlipGuardT<MeshT>, ModuleT>) attached.flip_guard = &module;
  if constexpr (std::is_base_of_v<ModRadiusRatioT<MeshT>, ModuleT>) attached.radius_guard = &module;
  attached_.push_back(attached);
  is_ready_ = false;
  return true;
}

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::remove(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  const Module* module = handle.is_valid() ? &Base::module(handle) : nullptr;
  if (!Base::remove(handle)) return false;
  std::erase_if(attached_, [module](const Attached& attached) { return attached.module == module; });
  is_ready_ = false;
  return true;
}

template <class MeshT>
bool PairDecimaterT<MeshT>::initialize() {
  this->set_uninitialized();  // the base does nothing a second time, and after a mere reset() lists its modules twice
  is_ready_ = Base::initialize();
  is_fresh_ = is_ready_;
  if (is_ready_) assign_roles();
  return is_ready_;
}

template <class MeshT>
void PairDecimaterT<MeshT>::assign_roles() {
  cost_ = nullptr;
  foreign_cost_ = nullptr;
  flip_guard_ = nullptr;
  radius_guard_ = nullptr;
  foreign_guards_.clear();
  // The base's rule: the module that isn't binary; failing that, the one called "Quadric".
  auto ranking =
      std::find_if(attached_.begin(), attached_.end(), [](const Attached& a) { return !a.module->is_binary(); });
  if (ranking == attached_.end()) {
    const auto is_quadric = [](const Attached& a) { return a.module->name() == "Quadric"; };
    ranking = std::find_if(attached_.begin(), attached_.end(), is_quadric);
  }
  for (auto it = attached_.begin(); it != attached_.end(); ++it) {
    if (it == ranking && it->cost && it->cost->has_placement()) {
      cost_ = it->cost;
    } else if (it == ranking) {
      foreign_cost_ = it->module;
    } else if (it->flip_guard) {
      flip_guard_ = it->flip_guard;
    } else if (it->radius_guard) {
      radius_guard_ = it->radius_guard;
    } else {
      foreign_guards_.push_back(it->module);
    }
  }
}

template <class MeshT>
std::string PairDecimaterT<MeshT>::engine_obstacle() const {
  if (!is_ready_) return "not initialized";
  if (foreign_cost_) return "the costs are those of module " + foreign_cost_->name();
  if (!foreign_guards_.empty()) return "module " + foreign_guards_.front()->name() + " works on the mesh alone";
  if (!cost_->engine_options()) return "the engine doesn't know these costs";
  if (!is_fresh_) return "contractions were made since initialize(), and the engine starts anew";
  return {};
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_pair_options(const PairOptions& options) {
  if (options.threshold && !(*options.threshold >= 0)) {
    throw std::invalid_argument("PairDecimaterT: the pair threshold is negative or not a number");
  }
  pairs_ = options;
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_pair_threshold(std::optional<double> threshold) {
  PairOptions options = pairs_;
  options.threshold = threshold;
  set_pair_options(options);
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_feature_tolerance(double tolerance) {
  if (!(tolerance >= 0)) {
    throw std::invalid_argument("PairDecimaterT: the feature tolerance is negative or not a number");
  }
  feature_tolerance_ = tolerance;
}

// Runs ----------------------------------------------------------------------------------------------------------------

template <class MeshT>
void PairDecimaterT<MeshT>::require_initialized() const {
  if (is_ready_ && this->is_initialized()) return;
  throw std::logic_error("PairDecimaterT: not initialized; initialize() must have returned true since the last add()");
}

template <class MeshT>
DecimateTarget PairDecimaterT<MeshT>::checked(const DecimateTarget& target) const {
  const std::optional<double> asked = target.cost_limit();
  if (asked && !(*asked >= 0)) {
    throw std::invalid_argument("PairDecimaterT: max_cost is negative or not a number");
  }
  if (asked && !cost_) {
    throw std::invalid_argument("PairDecimaterT: max_cost needs a cost module of ours; limit " + foreign_cost_->name() +
                                " by its own settings");
  }
  const std::optional<double> limit = cost_ ? cost_->max_cost() : std::nullopt;
  return limit ? target.or_max_cost(std::min(*limit, asked.value_or(*limit))) : target;
}

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::decimate(const DecimateTarget& target, bool only_selected) {
  require_initialized();
  const DecimateTarget effective = checked(target);
  last_driver_ = choose_driver();
  module_rejections_.clear();
  if (last_driver_ == Driver::engine) {
    result_ = EngineRunT<MeshT>(*this, effective, only_selected).run();
    if (result_.n_contractions > 0) is_fresh_ = false;
  } else {
    result_ = MeshContractionLoopT<MeshT>(*this, effective, only_selected).run();
  }
  return result_;
}

template <class MeshT>
Driver PairDecimaterT<MeshT>::choose_driver() const {
  std::string obstacle = driver_ == Driver::mesh ? "the mesh driver was asked for" : engine_obstacle();
  if (obstacle.empty() && pairs_.threshold > 0 && !takes_threshold_pairs(*cost_->engine_options())) {
    obstacle = "such pairs go with the plain quadric cost alone";
  }
  if (obstacle.empty()) return Driver::engine;
  if (pairs_.threshold > 0) {
    throw std::logic_error("PairDecimaterT: only the engine driver contracts threshold pairs, and it can't be used: " +
                           obstacle);
  }
  if (driver_ == Driver::engine) {
    throw std::logic_error("PairDecimaterT: the engine driver can't be used: " + obstacle);
  }
  return Driver::mesh;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate(std::size_t n_contractions, bool only_selected) {
  require_initialized();
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  const std::uint64_t n_vertices = count_elements().vertices;
  if (n_contractions > 0 && n_contractions < n_vertices) target = DecimateTarget::vertices(n_vertices - n_contractions);
  return decimate(target, only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to(std::size_t n_vertices, bool only_selected) {
  return decimate(DecimateTarget::vertices(n_vertices), only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to_faces(std::size_t n_vertices, std::size_t n_faces, bool only_selected) {
  return decimate(DecimateTarget::vertices(n_vertices).or_faces(n_faces), only_selected).n_contractions;
}

template <class MeshT>
typename PairDecimaterT<MeshT>::Counts PairDecimaterT<MeshT>::count_elements() const {
  Counts counts;
  const std::vector<Index> firsts = first_copies(mesh_);
  std::vector<bool> has_face(firsts.size());
  for (const VertexHandle v : mesh_.vertices()) {
    if (mesh_.is_isolated(v)) continue;
    if (!firsts.empty()) {
      const Index first = firsts[static_cast<std::size_t>(v.idx())];
      if (has_face[first]) continue;
      has_face[first] = true;
    }
    ++counts.vertices;
  }
  for ([[maybe_unused]] const OpenMesh::FaceHandle f : mesh_.faces()) ++counts.faces;
  return counts;
}

/// The cost's default without a `ModFlipGuardT`; with a cost that the engine doesn't know, that of plain quadrics.
template <class MeshT>
double PairDecimaterT<MeshT>::max_normal_flip_deg() const {
  if (flip_guard_) return flip_guard_->max_normal_flip_deg();
  const std::optional<CostOptions> known = cost_ ? cost_->engine_options() : std::nullopt;
  return cost_traits(known ? known->cost : Cost::quadric).default_max_normal_flip_deg;
}

template <class MeshT>
bool PairDecimaterT<MeshT>::is_fixed(VertexHandle v, bool only_selected) const {
  const auto& status = mesh_.status(v);
  return status.locked() || (only_selected && !status.selected());
}

// Contractions --------------------------------------------------------------------------------------------------------

/// \param position in the frame of `cost_`; with a foreign cost v1 keeps its place. \return faces removed
template <class MeshT>
std::uint64_t PairDecimaterT<MeshT>::contract(HalfedgeHandle to_survivor, const PairEvaluation& evaluation,
                                              const Vec3& position) {
  CollapseInfo collapse(mesh_, to_survivor);
  is_fresh_ = false;
  if (cost_) cost_->place_next(evaluation, position);
  Base::preprocess_collapse(collapse);
  carry_feature_bits(mesh_, collapse);
  mesh_.collapse(to_survivor);
  if (mesh_.has_face_normals()) {
    for (const OpenMesh::FaceHandle f : mesh_.vf_range(collapse.v1)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
  Base::postprocess_collapse(collapse);
  return std::uint64_t{collapse.fl.is_valid()} + std::uint64_t{collapse.fr.is_valid()};
}

template <class MeshT>
void PairDecimaterT<MeshT>::count_rejection(const Module& module) {
  const auto has_name = [&module](const ModuleRejections& entry) { return entry.module == module.name(); };
  auto entry = std::find_if(module_rejections_.begin(), module_rejections_.end(), has_name);
  if (entry == module_rejections_.end()) entry = module_rejections_.insert(entry, {module.name(), 0});
  ++entry->count;
}

}  // namespace whittle
