// A cost and a guard of our own in Whittle's decimater for OpenMesh meshes.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <cstdio>
#include <whittle/engine/formula/edge_length_term.hh>
#include <whittle/openmesh/pair_decimater.hh>
#include <whittle/openmesh/placing_module.hh>

#include "torus.hh"

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// The cost: the length of the edge, times 2 on the right (x > 0), where the mesh should stay finer. Unit: length.
template <class MeshT>
class ModFinerRightT : public whittle::PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModFinerRightT, MeshT, FinerRight);
  explicit ModFinerRightT(MeshT& mesh) : whittle::PlacingModuleT<MeshT>(mesh) {}
  /// The power of a length that is the cost's unit.
  double cost_dimension() const override { return 1; }

 private:
  using typename whittle::PlacingModuleT<MeshT>::VertexHandle;

  /// Cost and position of the merged vertex. `constraint` names the vertex that must stay, if any.
  whittle::PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second,
                                         whittle::PairConstraint constraint) const override {
    auto evaluation = whittle::evaluate_midpoint(this->position(first), this->position(second), constraint);
    // Modules compute in a frame, centred and scaled. `to_model` gives the position in the units of the mesh.
    if (this->frame().to_model(evaluation.position).x() > 0) evaluation.cost *= 2;
    evaluation.bound = evaluation.cost;
    return evaluation;
  }
  /// A contraction may make only the edges of the merged vertex cheaper.
  whittle::Reach plain_reach() const override { return whittle::Reach::ends; }
};

/// The guard: vertices merge only with vertices of the same part. It is a binary module, in OpenMesh's sense.
template <class MeshT>
class ModSamePartT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModSamePartT, MeshT, SamePart);
  explicit ModSamePartT(MeshT& mesh) : OpenMesh::Decimater::ModBaseT<MeshT>(mesh, true), part_(mesh, "part") {}

  float collapse_priority(const CollapseInfo& collapse) override {
    const bool is_allowed = part_[collapse.v0] == part_[collapse.v1];
    return static_cast<float>(is_allowed ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
  }

 private:
  OpenMesh::VProp<int> part_;  ///< the mesh's property "part"
};

int main() {
  const Torus torus(48, 24);
  Mesh mesh;
  for (const auto& p : torus.points)
    mesh.add_vertex(Mesh::Point(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])));
  for (const auto& [a, b, c] : torus.faces)
    mesh.add_face(mesh.vertex_handle(a), mesh.vertex_handle(b), mesh.vertex_handle(c));
  OpenMesh::VProp<int> part(mesh, "part");
  for (const Mesh::VertexHandle v : mesh.vertices()) part[v] = mesh.point(v)[1] > 0 ? 1 : 0;

  whittle::PairDecimaterT<Mesh> decimater(mesh);
  ModFinerRightT<Mesh>::Handle cost;
  ModSamePartT<Mesh>::Handle guard;
  decimater.add(cost);
  decimater.add(guard);
  decimater.initialize();
  bool mixes_parts = false;
  decimater.set_listener([&](const whittle::Contraction& made) {
    mixes_parts = mixes_parts || part[mesh.vertex_handle(made.survivor)] != part[mesh.vertex_handle(made.removed)];
  });
  const whittle::DecimateResult result = decimater.decimate(whittle::DecimateTarget::faces(500));

  int n_left = 0;
  int n_right = 0;
  for (const Mesh::VertexHandle v : mesh.vertices()) ++(mesh.point(v)[0] > 0 ? n_right : n_left);
  std::printf("%d vertices on the left, %d on the right, %s\n", n_left, n_right,
              mixes_parts ? "parts are mixed" : "no part is mixed with the other");
  return result.n_faces == 500 && n_right > n_left && !mixes_parts ? 0 : 1;
}
