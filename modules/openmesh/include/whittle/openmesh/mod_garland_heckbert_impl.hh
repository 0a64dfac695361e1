#pragma once

#include "whittle/openmesh/mod_garland_heckbert.hh"

namespace whittle {

template <class MeshT>
ModGarlandHeckbertT<MeshT>::ModGarlandHeckbertT(MeshT& mesh) : Base(mesh, false), mesh_(mesh), numbers_(mesh) {}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::set_options(const QuadricOptions& options) {
  const auto check = [](double value, const char* name) {
    if (value >= 0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string("ModGarlandHeckbertT: ") + name + " is negative or not finite");
  };
  check(options.regularization, "regularization");
  check(options.boundary_weight, "boundary_weight");
  options_ = options;
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::set_max_cost(double max_cost) {
  if (!(max_cost >= 0)) throw std::invalid_argument("ModGarlandHeckbertT: max_cost is negative or not a number");
  max_cost_ = max_cost;
}

template <class MeshT>
std::optional<double> ModGarlandHeckbertT<MeshT>::max_cost() const {
  if (!max_cost_) return std::nullopt;
  return *max_cost_ * this->error_tolerance_factor_;
}

template <class MeshT>
std::optional<QuadricOptions> ModGarlandHeckbertT<MeshT>::engine_options() const {
  if (stock_) return std::nullopt;
  return active_;
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    numbers_[VertexHandle(static_cast<int>(vertices[i]))] = static_cast<Index>(i);
  }
  quadrics_ = std::move(quadrics);
  has_quadrics_ = true;
  for (const VertexHandle v : mesh_.vertices()) {
    if (mesh_.is_isolated(v)) add_vertex(v);
  }
}

// Quadrics of the mesh as it is. The order of every sum is that of the engine: a vertex's faces by their number, then
// for each of its faces in that order the border edge that leaves the vertex in it, and the one that arrives.

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::initialize() {
  active_ = options_;
  pending_.reset();
  stock_.reset();
  if (arithmetic_ == Arithmetic::stock) {
    stock_.emplace(mesh_);
    return;
  }
  frame_ = frame_of_mesh();
  has_quadrics_ = false;
}

template <class MeshT>
Frame ModGarlandHeckbertT<MeshT>::frame_of_mesh() const {
  std::optional<std::pair<Vec3, Vec3>> box;
  for (const VertexHandle v : mesh_.vertices()) {
    const Vec3 p = to_vec3(mesh_.point(v));
    if (!p.allFinite()) {
      throw std::invalid_argument("ModGarlandHeckbertT: vertex " + std::to_string(v.idx()) +
                                  " has a coordinate that is not finite");
    }
    if (!box) box.emplace(p, p);
    box->first = box->first.cwiseMin(p);
    box->second = box->second.cwiseMax(p);
  }
  return box ? Frame::of_box(box->first, box->second) : Frame{};
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::make_quadrics() const {
  has_quadrics_ = true;
  quadrics_.clear();
  quadrics_.reserve(mesh_.n_vertices());
  for (const VertexHandle v : mesh_.vertices()) add_vertex(v);
  add_face_planes();
  if (active_.boundary_weight > 0) add_border_planes();
}

/// With no planes yet.
template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_vertex(VertexHandle v) const {
  numbers_[v] = static_cast<Index>(quadrics_.size());
  quadrics_.push_back({frame_.to_frame(to_vec3(mesh_.point(v))), {}});
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_face_planes() const {
  for (const OpenMesh::FaceHandle f : mesh_.faces()) {
    const auto corners = face_corners(mesh_, f);
    for (std::size_t i = 0; i < 3; ++i) {
      placed(corners[i]).quadric.a +=
          corner_quadric(position(corners[i]), position(corners[(i + 1) % 3]), position(corners[(i + 2) % 3]), active_);
    }
  }
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::add_border_planes() const {
  for (const OpenMesh::FaceHandle f : mesh_.faces()) {
    const auto corners = face_corners(mesh_, f);
    const OpenMesh::HalfedgeHandle into_first = mesh_.halfedge_handle(f);
    std::array<std::optional<SymmetricMatrix>, 3> planes;  // of the edge from corner i to the next
    OpenMesh::HalfedgeHandle h = mesh_.next_halfedge_handle(into_first);
    for (std::size_t i = 0; i < 3; ++i, h = mesh_.next_halfedge_handle(h)) {
      if (!mesh_.is_boundary(mesh_.edge_handle(h))) continue;
      const auto at = [&](std::size_t corner) { return position(corners[corner % 3]); };
      planes[i] = border_quadric(at(i), at(i + 1), at(i + 2), active_);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (planes[i]) placed(corners[i]).quadric.a += *planes[i];
      if (planes[(i + 2) % 3]) placed(corners[i]).quadric.a += *planes[(i + 2) % 3];
    }
  }
}

template <class MeshT>
PairEvaluation ModGarlandHeckbertT<MeshT>::evaluate(VertexHandle first, VertexHandle second, Pinned pinned) const {
  return evaluate_pair(placed(first), placed(second), active_.placement, pinned);
}

template <class MeshT>
PairEvaluation ModGarlandHeckbertT<MeshT>::evaluate(const CollapseInfo& collapse) const {
  // Whoever collapses a feature v0 does so along a feature edge: then v̄ must stay on that line.
  const auto& at_v1 = mesh_.status(collapse.v1);
  const bool v1_stays = at_v1.locked() || at_v1.feature() || mesh_.status(collapse.v0).feature();
  const bool v1_is_first = collapse.v1 < collapse.v0;
  const Pinned pinned = !v1_stays ? Pinned::none : v1_is_first ? Pinned::first : Pinned::second;
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  return evaluate(first, second, pinned);
}

template <class MeshT>
float ModGarlandHeckbertT<MeshT>::collapse_priority(const CollapseInfo& collapse) {
  constexpr auto illegal = static_cast<float>(Base::ILLEGAL_COLLAPSE);
  if (stock_) {
    const double cost = stock_->cost(collapse);
    return cost < max_cost_.value_or(DBL_MAX) ? static_cast<float>(cost) : illegal;
  }
  const PairEvaluation evaluation = evaluate(collapse);
  if (const auto limit = max_cost(); limit && evaluation.cost > frame_.cost_to_frame(*limit, cost_dimension())) {
    return illegal;
  }
  return static_cast<float>(std::min(evaluation.cost, 0.5 * double{FLT_MAX}));  // DecimaterT wants less than FLT_MAX
}

/// Moves v1 already here, after the other modules have seen the mesh as it was: what they and the decimater do between
/// the collapse and our `postprocess_collapse`, face normals above all, then rests on the merged vertex's place.
template <class MeshT>
void ModGarlandHeckbertT<MeshT>::preprocess_collapse(const CollapseInfo& collapse) {
  if (stock_) return;
  if (!pending_) pending_ = evaluate(collapse);
  if (pending_->position == position(collapse.v1)) return;  // not rounded for nothing
  mesh_.set_point(collapse.v1, to_point<typename MeshT::Point>(frame_.to_model(pending_->position)));
}

template <class MeshT>
void ModGarlandHeckbertT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  if (stock_) return stock_->merge(collapse);
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  const PairEvaluation& evaluation = pending_.value();
  placed(collapse.v1) = merged(placed(first), placed(second), evaluation.position, evaluation.is_minimum);
  pending_.reset();
}

}  // namespace whittle
