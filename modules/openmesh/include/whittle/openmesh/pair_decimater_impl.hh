#pragma once

#include <stdexcept>
#include <utility>

#include "whittle/openmesh/bulk_collapse.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/mesh_contraction_loop.hh"
#include "whittle/openmesh/pair_decimater.hh"

namespace whittle {

// Modules -------------------------------------------------------------------------------------------------------------

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  if (!Base::add(handle)) return false;
  ModuleT& module = Base::module(handle);
  Attached attached{&module, nullptr, nullptr};
  if constexpr (std::is_base_of_v<PairCostModuleT<MeshT>, ModuleT>) attached.cost = &module;
  if constexpr (std::is_base_of_v<ModFlipGuardT<MeshT>, ModuleT>) attached.flip_guard = &module;
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
  const auto is_feature = [this](VertexHandle v) { return mesh_.status(v).feature(); };
  const auto vertices = mesh_.vertices();
  if (std::any_of(vertices.begin(), vertices.end(), is_feature)) return "some vertices are features";
  return {};
}

// Runs ----------------------------------------------------------------------------------------------------------------

template <class MeshT>
void PairDecimaterT<MeshT>::require_initialized() const {
  if (is_ready_ && this->is_initialized()) return;
  throw std::logic_error("PairDecimaterT: not initialized; initialize() must have returned true since the last add()");
}

template <class MeshT>
DecimateTarget PairDecimaterT<MeshT>::checked(const DecimateTarget& target) const {
  DecimateTarget result = target;
  if (target.max_cost && !(*target.max_cost >= 0)) {
    throw std::invalid_argument("PairDecimaterT: max_cost is negative or not a number");
  }
  if (target.max_cost && !cost_) {
    throw std::invalid_argument("PairDecimaterT: max_cost needs ModGarlandHeckbertT; limit " + foreign_cost_->name() +
                                " by its own settings");
  }
  const std::optional<double> limit = cost_ ? cost_->max_cost() : std::nullopt;
  if (limit) result.max_cost = std::min(*limit, target.max_cost.value_or(*limit));
  return result;
}

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::decimate(const DecimateTarget& target, bool only_selected) {
  require_initialized();
  const DecimateTarget effective = checked(target);
  const std::string obstacle = driver_ == Driver::mesh ? "not asked for" : engine_obstacle();
  if (driver_ == Driver::engine && !obstacle.empty()) {
    throw std::logic_error("PairDecimaterT: the engine driver can't be used: " + obstacle);
  }
  module_rejections_.clear();
  last_driver_ = obstacle.empty() ? Driver::engine : Driver::mesh;
  result_ = last_driver_ == Driver::engine ? run_engine(effective, only_selected)
                                           : MeshContractionLoopT<MeshT>(*this, effective, only_selected).run();
  return result_;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate(std::size_t n_contractions, bool only_selected) {
  require_initialized();
  DecimateTarget target;
  const std::uint64_t n_vertices = count_elements().vertices;
  if (n_contractions > 0 && n_contractions < n_vertices) target.vertices = n_vertices - n_contractions;
  return decimate(target, only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to(std::size_t n_vertices, bool only_selected) {
  DecimateTarget target;
  target.vertices = n_vertices;
  return decimate(target, only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to_faces(std::size_t n_vertices, std::size_t n_faces, bool only_selected) {
  DecimateTarget target;
  target.vertices = n_vertices;
  target.faces = n_faces;
  return decimate(target, only_selected).n_contractions;
}

template <class MeshT>
typename PairDecimaterT<MeshT>::Counts PairDecimaterT<MeshT>::count_elements() const {
  Counts counts;
  for (const VertexHandle v : mesh_.vertices()) counts.vertices += !mesh_.is_isolated(v);
  for ([[maybe_unused]] const OpenMesh::FaceHandle f : mesh_.faces()) ++counts.faces;
  return counts;
}

template <class MeshT>
bool PairDecimaterT<MeshT>::is_fixed(VertexHandle v, bool only_selected) const {
  const auto& status = mesh_.status(v);
  return status.locked() || (only_selected && !status.selected());
}

// The engine driver ---------------------------------------------------------------------------------------------------

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::run_engine(const DecimateTarget& target, bool only_selected) {
  const IndexedMesh input = geometry_of(mesh_);
  const auto handle_index = [&input](Index v) { return input.origins.empty() ? v : input.origins[v]; };
  const auto handle = [&](Index v) { return VertexHandle(static_cast<int>(handle_index(v))); };
  const std::vector<std::uint8_t> locked = fixed_vertices(input, only_selected);

  std::vector<VertexMerge> merges;
  bool is_aborted = false;
  DecimateOptions options;
  options.quadric = *cost_->engine_options();
  options.max_normal_flip_deg = max_normal_flip_deg();
  options.locked = locked;
  options.threads = threads_;
  options.keep_quadrics = true;
  options.progress = [&is_aborted](const Progress&) { return !is_aborted; };
  options.listener = [&](const Contraction& made) {
    if (is_aborted) return;
    merges.push_back({handle(made.removed), handle(made.survivor)});
    if (listener_) listener_({handle_index(made.survivor), handle_index(made.removed), made.position, made.cost});
    is_aborted = !this->notify_observer(merges.size());
  };
  Decimation small = whittle::decimate(input, target, options);
  if (is_aborted) {
    if (merges.size() < small.result.n_contractions) {  // the engine asks now and then only: again, up to the abort
      options.progress = nullptr;
      options.listener = nullptr;
      DecimateTarget up_to_abort;
      up_to_abort.vertices = small.result.n_vertices + small.result.n_contractions - merges.size();
      small = whittle::decimate(input, up_to_abort, options);
    }
    small.result.stop = StopReason::cancelled;
  }
  write_back(merges, small);
  return small.result;
}

/// As the engine wants to have it: empty if there are none.
template <class MeshT>
std::vector<std::uint8_t> PairDecimaterT<MeshT>::fixed_vertices(const IndexedMesh& input, bool only_selected) const {
  std::vector<std::uint8_t> result(input.positions.size());
  bool any = false;
  for (Index v = 0; v < result.size(); ++v) {
    const Index handle_index = input.origins.empty() ? v : input.origins[v];
    result[v] = is_fixed(VertexHandle(static_cast<int>(handle_index)), only_selected);
    any = any || result[v] != 0;
  }
  if (!any) result.clear();
  return result;
}

/// \param merges what the engine contracted \param small what it made of the mesh
template <class MeshT>
void PairDecimaterT<MeshT>::write_back(const std::vector<VertexMerge>& merges, Decimation& small) {
  if (!merges.empty()) is_fresh_ = false;
  BulkCollapseT<MeshT>(mesh_, merges).run();
  for (std::size_t v = 0; v < small.mesh.positions.size(); ++v) {
    const VertexHandle handle(static_cast<int>(small.mesh.origins[v]));
    const Vec3& position = small.mesh.positions[v];
    if (position == to_vec3(mesh_.point(handle))) continue;  // not rounded for nothing
    mesh_.set_point(handle, to_point<typename MeshT::Point>(position));
  }
  if (mesh_.has_face_normals()) update_face_normals(merges);
  cost_->adopt(small.mesh.origins, std::move(small.quadrics));
}

/// Those of faces at merged vertices.
template <class MeshT>
void PairDecimaterT<MeshT>::update_face_normals(const std::vector<VertexMerge>& merges) {
  std::vector<bool> is_merged(mesh_.n_vertices());
  for (const VertexMerge& merge : merges) is_merged[static_cast<std::size_t>(merge.survivor.idx())] = true;
  for (const OpenMesh::FaceHandle f : mesh_.faces()) {
    const auto corners = face_corners(mesh_, f);
    const auto at_merged = [&](VertexHandle v) { return is_merged[static_cast<std::size_t>(v.idx())]; };
    if (std::any_of(corners.begin(), corners.end(), at_merged)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
}

// Contractions --------------------------------------------------------------------------------------------------------

/// \param evaluation its position is that of `cost_`; with a foreign cost v1 keeps its place. \return faces removed
template <class MeshT>
std::uint64_t PairDecimaterT<MeshT>::contract(HalfedgeHandle to_survivor, const PairEvaluation& evaluation) {
  CollapseInfo collapse(mesh_, to_survivor);
  is_fresh_ = false;
  if (cost_) cost_->place_next(evaluation);
  Base::preprocess_collapse(collapse);
  carry_features(collapse);
  mesh_.collapse(to_survivor);
  if (mesh_.has_face_normals()) {
    for (const OpenMesh::FaceHandle f : mesh_.vf_range(collapse.v1)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
  Base::postprocess_collapse(collapse);
  return std::uint64_t{collapse.fl.is_valid()} + std::uint64_t{collapse.fr.is_valid()};
}

/// Of the two edges that a collapse makes one, OpenMesh keeps v1's: it becomes a feature if either was.
template <class MeshT>
void PairDecimaterT<MeshT>::carry_features(const CollapseInfo& collapse) {
  const auto carry = [this](HalfedgeHandle from, HalfedgeHandle to) {
    if (!from.is_valid() || !mesh_.status(mesh_.edge_handle(from)).feature()) return;
    mesh_.status(mesh_.edge_handle(to)).set_feature(true);
  };
  carry(collapse.v0vl, collapse.vlv1);
  carry(collapse.vrv0, collapse.v1vr);
}

template <class MeshT>
void PairDecimaterT<MeshT>::count_rejection(const Module& module) {
  const auto has_name = [&module](const ModuleRejections& entry) { return entry.module == module.name(); };
  auto entry = std::find_if(module_rejections_.begin(), module_rejections_.end(), has_name);
  if (entry == module_rejections_.end()) entry = module_rejections_.insert(entry, {module.name(), 0});
  ++entry->count;
}

}  // namespace whittle
