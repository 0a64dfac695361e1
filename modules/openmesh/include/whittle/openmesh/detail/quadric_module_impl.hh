#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "whittle/openmesh/detail/quadric_module.hh"

namespace whittle {

template <class MeshT>
void QuadricModuleT<MeshT>::set_options(const QuadricOptions& options) {
  const auto check = [this](double value, const std::string& name) {
    this->require(value >= 0 && std::isfinite(value), name + " is negative or not finite");
  };
  check(options.regularization, "regularization");
  check(options.boundary_weight, "boundary_weight");
  options_ = options;
  this->note_new_options();
}

template <class MeshT>
PairEvaluation QuadricModuleT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second,
                                                     PairConstraint constraint) const {
  return evaluate_pair(placed(first), placed(second), active_.placement, constraint);
}

template <class MeshT>
PlacedQuadric QuadricModuleT<MeshT>::merge(VertexHandle first, VertexHandle second, const PairEvaluation& evaluation,
                                           const Vec3& position) {
  return merged(placed(first), placed(second), position, evaluation.is_minimum);
}

// Quadrics of the mesh as it is. Every sum has the engine's order. First come the planes of a vertex's faces, by face
// number. Then come its border edges, for each face in that order: the edge that leaves the vertex, then the one that
// arrives.

template <class MeshT>
void QuadricModuleT<MeshT>::add_planes() const {
  add_face_planes();
  if (active_.boundary_weight > 0) add_border_planes();
}

template <class MeshT>
void QuadricModuleT<MeshT>::add_face_planes() const {
  for (const OpenMesh::FaceHandle f : surface().faces()) {
    const auto corners = face_corners(surface(), f);
    const auto at = [&](std::size_t corner) { return this->position(corners[corner % 3]); };
    for (std::size_t i = 0; i < 3; ++i) {
      placed(corners[i]).quadric.a += corner_quadric(at(i), at(i + 1), at(i + 2), active_);
    }
  }
}

template <class MeshT>
void QuadricModuleT<MeshT>::add_border_planes() const {
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

}  // namespace whittle
