#pragma once

#include <algorithm>
#include <iterator>
#include <utility>

#include "whittle/core/geometry/triangle.hh"
#include "whittle/openmesh/mod_memoryless.hh"

namespace whittle {

template <class MeshT>
void ModMemorylessT<MeshT>::set_options(const QuadricOptions& options) {
  this->require(options.weights == Weights::area, "weights aren't by area");
  QuadricModule::set_options(options);
}

template <class MeshT>
void ModMemorylessT<MeshT>::initialize() {
  QuadricModule::initialize();
  n_faces_ = count_faces();
  measure_area();
}

/// Without deleted ones.
template <class MeshT>
std::size_t ModMemorylessT<MeshT>::count_faces() const {
  const auto faces = surface().faces();
  return static_cast<std::size_t>(std::distance(faces.begin(), faces.end()));
}

/// Adds each face once per corner inside the surface, as the engine does.
template <class MeshT>
void ModMemorylessT<MeshT>::measure_area() {
  const MeshT& mesh = surface();
  const auto at = [&](VertexHandle v) -> Vec3 { return this->frame().to_frame(to_vec3(mesh.point(v))); };
  double area = 0;
  std::size_t n_corners = 0;
  for (const OpenMesh::FaceHandle f : mesh.faces()) {
    const auto corners = face_corners(mesh, f);
    const auto n_inside = static_cast<std::size_t>(
        std::count_if(corners.begin(), corners.end(), [this](VertexHandle v) { return !remembers(v); }));
    area += area_of({at(corners[0]), at(corners[1]), at(corners[2])}) * static_cast<double>(n_inside);
    n_corners += n_inside;
  }
  face_area_ = {area, n_corners, n_faces_};
}

template <class MeshT>
void ModMemorylessT<MeshT>::adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics,
                                  bool were_collapses) {
  if (were_collapses) {
    QuadricModule::adopt(vertices, std::move(quadrics), were_collapses);
  } else {
    this->forget_quadrics();
  }
  n_faces_ = count_faces();
}

template <class MeshT>
PairEvaluation ModMemorylessT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second,
                                                     PairConstraint constraint) const {
  PairEvaluation evaluation = QuadricModule::evaluate_plain(first, second, constraint);
  const double weight = placed(first).quadric.a.trace() + placed(second).quadric.a.trace();
  const double factor = memoryless_factor(weight, face_area_.first());
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

template <class MeshT>
Vec3 ModMemorylessT<MeshT>::place(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
                                  const PairEvaluation& evaluation) const {
  if (!evaluation.is_minimum || !forgets(first, second)) return evaluation.position;
  find_ring(first, second, evaluation.position);
  return evaluation.position + volume_step(placed(first).quadric.a + placed(second).quadric.a, ring_.volume());
}

template <class MeshT>
double ModMemorylessT<MeshT>::final_cost(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
                                         const PairEvaluation& evaluation, const Vec3& position) const {
  if (!forgets(first, second)) return evaluation.cost;
  find_ring(first, second, evaluation.position);
  if (!ring_.volume().is_thin()) return evaluation.cost;
  const double displacement_sq = ring_.displacement_sq(position);
  return std::max(evaluation.cost, thin_cost(displacement_sq, face_area_.now(n_faces_)));
}

/// Fills the ring in the engine's order.
template <class MeshT>
void ModMemorylessT<MeshT>::find_ring(VertexHandle first, VertexHandle second, const Vec3& origin) const {
  const MeshT& mesh = surface();
  std::vector<Index>& around = ring_.around();
  const auto index = [](VertexHandle v) { return static_cast<Index>(v.idx()); };
  const auto add_neighbours_after = [&](OpenMesh::HalfedgeHandle start) {
    OpenMesh::HalfedgeHandle h = mesh.ccw_rotated_halfedge_handle(start);
    for (; h != start; h = mesh.ccw_rotated_halfedge_handle(h)) around.push_back(index(mesh.to_vertex_handle(h)));
  };
  around.clear();
  const OpenMesh::HalfedgeHandle edge = mesh.find_halfedge(first, second);
  add_neighbours_after(edge);
  const std::size_t n_first = around.size() - 1;
  around.pop_back();  // the corner right of the edge: the second end's neighbours begin with it
  add_neighbours_after(mesh.opposite_halfedge_handle(edge));
  around.pop_back();  // the corner left of it
  ring_.look(placed(first).position, placed(second).position, n_first, origin,
             [this](Index v) -> const Vec3& { return placed(VertexHandle(static_cast<int>(v))).position; });
}

/// Two inner vertices get the planes of the faces after the collapse. Any other pair gets the sum of both quadrics.
template <class MeshT>
PlacedQuadric ModMemorylessT<MeshT>::merge(VertexHandle first, VertexHandle second, const PairEvaluation& evaluation,
                                           const Vec3& position) {
  changes_.clear();
  if (!forgets(first, second)) {
    find_changes_around(first, second, position);
    return QuadricModule::merge(first, second, evaluation, position);
  }
  find_ring(first, second, evaluation.position);
  Quadric quadric;
  ring_.move_to(position, active());
  quadric.a = ring_.planes();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const VertexHandle v(static_cast<int>(ring_.vertex(i)));
    if (!remembers(v)) changes_.push_back({ring_.vertex(i), ring_.change(i)});
  }
  return {position, quadric};
}

/// Finds the changes at the neighbours of a pair with a border vertex.
template <class MeshT>
void ModMemorylessT<MeshT>::find_changes_around(VertexHandle first, VertexHandle second, const Vec3& position) {
  const MeshT& mesh = surface();
  PlaneChanges found(active());
  add_changes_at(first, second, position, found);
  add_changes_at(second, first, position, found);
  const OpenMesh::HalfedgeHandle edge = mesh.find_halfedge(first, second);
  for (const OpenMesh::HalfedgeHandle side : {edge, mesh.opposite_halfedge_handle(edge)}) {
    if (mesh.is_boundary(side)) continue;
    found.remove_face(this->position(first), this->position(second),
                      corner(mesh.to_vertex_handle(mesh.next_halfedge_handle(side))));
  }
  for (const PlaneChanges::Change& change : found.sum()) {
    if (!remembers(VertexHandle(static_cast<int>(change.vertex)))) changes_.push_back(change);
  }
}

/// Adds the changes by faces at v that don't have `other`.
template <class MeshT>
void ModMemorylessT<MeshT>::add_changes_at(VertexHandle v, VertexHandle other, const Vec3& position,
                                           PlaneChanges& found) const {
  const MeshT& mesh = surface();
  for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
    if (mesh.is_boundary(h)) continue;
    const VertexHandle x = mesh.to_vertex_handle(h);
    const VertexHandle y = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    if (x != other && y != other) found.move_face(this->position(v), position, corner(x), corner(y));
  }
}

template <class MeshT>
void ModMemorylessT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  QuadricModule::postprocess_collapse(collapse);
  for (const auto& [v, planes] : changes_) placed(VertexHandle(static_cast<int>(v))).quadric.a += planes;
  n_faces_ -= std::size_t{collapse.fl.is_valid()} + std::size_t{collapse.fr.is_valid()};
}

}  // namespace whittle
