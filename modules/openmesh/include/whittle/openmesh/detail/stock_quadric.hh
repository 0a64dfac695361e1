#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>  // before QuadricT.hh, which uses it without including it

#include <OpenMesh/Core/Geometry/QuadricT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Core/Utils/vector_cast.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <array>
#include <cfloat>

#include "whittle/openmesh/conversions.hh"

namespace whittle {

/// The quadrics of OpenMesh's ModQuadricT to the last bit: uncentred, weighted by area; v1 keeps its position.
///
/// Used for comparisons, and to repeat old results. Rounding makes such costs negative on flat ground, and the stock
/// decimater then refuses the collapse. Far from the origin the rounding errors exceed the costs.
template <class MeshT>
class StockQuadricT {
 public:
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;

  /// The quadrics of the mesh as it is.
  explicit StockQuadricT(MeshT& mesh) : quadrics_(mesh) {
    for (const OpenMesh::VertexHandle v : mesh.vertices()) quadrics_[v].clear();
    for (const OpenMesh::FaceHandle f : mesh.faces()) add_face(mesh, f);
  }

  double cost(const CollapseInfo& collapse) const {
    Quadric q = quadrics_[collapse.v0];
    q += quadrics_[collapse.v1];
    return q(collapse.p1);
  }

  void merge(const CollapseInfo& collapse) { quadrics_[collapse.v1] += quadrics_[collapse.v0]; }

 private:
  using Quadric = OpenMesh::Geometry::Quadricd;

  void add_face(const MeshT& mesh, OpenMesh::FaceHandle f) {
    const auto corners = face_corners(mesh, f);
    std::array<OpenMesh::Vec3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = OpenMesh::vector_cast<OpenMesh::Vec3d>(mesh.point(corners[i]));
    OpenMesh::Vec3d n = (p[1] - p[0]) % (p[2] - p[0]);
    double area = n.norm();
    if (area > FLT_MIN) {
      n /= area;
      area *= 0.5;
    }
    Quadric q(n[0], n[1], n[2], -(p[0] | n));
    q *= area;
    for (const OpenMesh::VertexHandle v : corners) quadrics_[v] += q;
  }

  OpenMesh::VProp<Quadric> quadrics_;
};

}  // namespace whittle
