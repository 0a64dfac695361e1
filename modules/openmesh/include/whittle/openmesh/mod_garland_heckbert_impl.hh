#pragma once

#include "whittle/engine/edge_length_term.hh"
#include "whittle/openmesh/mod_garland_heckbert.hh"

namespace whittle {

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::set_options(const QuadricOptions& options) {
  const auto check = [this](double value, const std::string& name) {
    this->require(value >= 0 && std::isfinite(value), name + " is negative or not finite");
  };
  check(options.regularization, "regularization");
  check(options.boundary_weight, "boundary_weight");
  options_ = options;
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::set_isotropy(double isotropy) {
  this->require(isotropy >= 0 && isotropy <= 1, "isotropy is not in [0, 1]");
  isotropy_ = isotropy;
}

template <class MeshT>
double ModGarlandHeckbertT<MeshT>::cost_dimension() const {
  const double of_quadric = active_.weights == Weights::uniform ? 2 : 4;
  return active_isotropy_ > 0 ? isotropic_dimension(of_quadric, active_isotropy_) : of_quadric;
}

template <class MeshT>
std::optional<CostOptions> ModGarlandHeckbertT<MeshT>::engine_options() const {
  if (stock_) return std::nullopt;
  return Placing::engine_options();
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::initialize() {
  active_ = options_;
  active_isotropy_ = isotropy_;
  stock_.reset();
  if (arithmetic_ == Arithmetic::stock) {
    stock_.emplace(this->mesh());
  } else {
    Placing::initialize();
  }
}

// Quadrics of the mesh as it is. The order of every sum is that of the engine: a vertex's faces by their number, then
// for each of its faces in that order the border edge that leaves the vertex in it, and the one that arrives.

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_planes() const {
  add_face_planes();
  if (active_.boundary_weight > 0) add_border_planes();
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_face_planes() const {
  for (const OpenMesh::FaceHandle f : surface().faces()) {
    const auto corners = face_corners(surface(), f);
    const auto at = [&](std::size_t corner) { return this->position(corners[corner % 3]); };
    for (std::size_t i = 0; i < 3; ++i) {
      placed(corners[i]).quadric.a += corner_quadric(at(i), at(i + 1), at(i + 2), active_);
    }
  }
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_border_planes() const {
  const MeshT& mesh = surface();
  for (const OpenMesh::FaceHandle f : mesh.faces()) {
    const auto corners = face_corners(mesh, f);
    const OpenMesh::HalfedgeHandle into_first = mesh.halfedge_handle(f);
    std::array<std::optional<SymmetricMatrix>, 3> planes;  // of the edge from corner i to the next
    OpenMesh::HalfedgeHandle h = mesh.next_halfedge_handle(into_first);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next_halfedge_handle(h)) {
      if (!mesh.is_boundary(mesh.edge_handle(h))) continue;
      const auto at = [&](std::size_t corner) { return this->position(corners[corner % 3]); };
      planes[i] = border_quadric(at(i), at(i + 1), at(i + 2), active_);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (planes[i]) placed(corners[i]).quadric.a += *planes[i];
      if (planes[(i + 2) % 3]) placed(corners[i]).quadric.a += *planes[(i + 2) % 3];
    }
  }
}

template <class MeshT>
PairEvaluation ModGarlandHeckbertT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second,
                                                          Pinned pinned) const {
  if (active_isotropy_ == 0) return evaluate_pair(placed(first), placed(second), active_.placement, pinned);
  return evaluate_isotropic(placed(first), placed(second), active_isotropy_, active_.placement, pinned);
}

template <class MeshT>
PlacedQuadric ModGarlandHeckbertT<MeshT>::merge(VertexHandle first, VertexHandle second,
                                                const PairEvaluation& evaluation) const {
  return merged(placed(first), placed(second), evaluation.position, evaluation.is_minimum);
}

// With stock arithmetic -----------------------------------------------------------------------------------------------

template <class MeshT>
float ModGarlandHeckbertT<MeshT>::collapse_priority(const CollapseInfo& collapse) {
  if (!stock_) return Placing::collapse_priority(collapse);
  const double cost = stock_->cost(collapse);
  return static_cast<float>(cost < this->max_cost().value_or(DBL_MAX) ? cost : double{Base::ILLEGAL_COLLAPSE});
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::preprocess_collapse(const CollapseInfo& collapse) {
  if (!stock_) Placing::preprocess_collapse(collapse);
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  if (!stock_) return Placing::postprocess_collapse(collapse);
  stock_->merge(collapse);
}

}  // namespace whittle
