#pragma once

#include <gtest/gtest.h>

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>
#include <whittle/openmesh/conversions.hh>
#include <whittle/openmesh/pair_decimater.hh>

#include "instantiations.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"

namespace whittle::test {

/// The shape as an OpenMesh mesh. The half-edge mesh must be able to hold it.
template <class MeshT>
MeshT open_mesh(const IndexedMesh& shape) {
  MeshT mesh;
  EXPECT_EQ(to_open_mesh(shape, mesh, NonManifold::refuse).size(), 0U) << "faces refused";
  return mesh;
}

template <class MeshT>
MeshT read_open_mesh(const std::filesystem::path& file) {
  MeshT mesh;
  EXPECT_TRUE(OpenMesh::IO::read_mesh(mesh, file.string())) << file;
  return mesh;
}

/// The meshes of a list that a half-edge mesh can hold: manifold and oriented.
inline std::vector<NamedMesh> holdable(std::vector<NamedMesh> meshes) {
  std::erase_if(meshes, [](const NamedMesh& entry) {
    const Topology t = topology(entry.mesh);
    return !t.manifold() || t.misoriented_edges > 0;
  });
  return meshes;
}

/// All closed and open shapes that a half-edge mesh can hold, and one more.
inline std::vector<NamedMesh> holdable_meshes() {
  std::vector<NamedMesh> result = closed_meshes();
  for (NamedMesh& entry : open_meshes()) result.push_back(std::move(entry));
  result = holdable(std::move(result));
  // Non-manifold, but a half-edge mesh can hold it: a vertex with two open fans.
  const IndexedMesh first = noisy_grid(5, 5, 0.3, 1);
  IndexedMesh second = moved(noisy_grid(5, 4, 0.3, 2), first.positions.back());
  second.positions.front() = first.positions.back();
  result.push_back({"two grids with a common corner", glued(joined(first, second))});
  return result;
}

/// Checks every handle of elements that aren't deleted against its neighbours.
template <class MeshT>
void expect_sound(const MeshT& mesh, const std::string& context) {
  const auto is_gone = [&mesh](OpenMesh::HalfedgeHandle h) { return mesh.status(mesh.edge_handle(h)).deleted(); };
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    for (const unsigned side : {0U, 1U}) {
      const OpenMesh::HalfedgeHandle h = mesh.halfedge_handle(e, side);
      const OpenMesh::HalfedgeHandle next = mesh.next_halfedge_handle(h);
      ASSERT_FALSE(is_gone(next)) << context << ": halfedge " << h.idx() << " leads to a deleted one";
      ASSERT_EQ(mesh.prev_halfedge_handle(next), h) << context;
      ASSERT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(h)) << context;
      ASSERT_FALSE(mesh.status(mesh.to_vertex_handle(h)).deleted()) << context;
      ASSERT_EQ(mesh.face_handle(next), mesh.face_handle(h)) << context;
      if (!mesh.is_boundary(h)) {
        ASSERT_FALSE(mesh.status(mesh.face_handle(h)).deleted()) << context;
        ASSERT_EQ(mesh.next_halfedge_handle(mesh.next_halfedge_handle(next)), h) << context << ": not a triangle";
      }
    }
    ASSERT_FALSE(mesh.is_boundary(mesh.halfedge_handle(e, 0)) && mesh.is_boundary(mesh.halfedge_handle(e, 1)))
        << context << ": edge " << e.idx() << " has no face";
  }
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    bool has_boundary = false;
    for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
      ASSERT_FALSE(is_gone(h)) << context;
      ASSERT_EQ(mesh.from_vertex_handle(h), v) << context;
      has_boundary = has_boundary || mesh.is_boundary(h);
    }
    ASSERT_EQ(mesh.is_boundary(v), has_boundary) << context << ": vertex " << v.idx();
  }
}

/// Expects the same topology except for the counts: parts, border loops, Euler number, manifold.
inline void expect_same_topology(const IndexedMesh& before, const IndexedMesh& after, const std::string& context) {
  const Topology a = topology(before);
  const Topology b = topology(after);
  EXPECT_EQ(a.euler(), b.euler()) << context;
  EXPECT_EQ(a.components, b.components) << context;
  EXPECT_EQ(a.border_loops, b.border_loops) << context;
  EXPECT_EQ(a.manifold(), b.manifold()) << context;
  EXPECT_EQ(b.misoriented_edges, 0) << context;
}

/// Targets of one kind. (GCC 12 warns of designated initializers that leave a field out.)
inline DecimateTarget to_faces(std::uint64_t n) { return DecimateTarget::faces(n); }
inline DecimateTarget to_vertices(std::uint64_t n) { return DecimateTarget::vertices(n); }
inline DecimateTarget to_cost(double cost) { return DecimateTarget::max_cost(cost); }

/// A collapse as OpenMesh's modules see it: v0 into v1.
using Collapse = std::pair<int, int>;

/// A binary module that refuses nothing and records every collapse.
template <class MeshT>
class ModCollapsesT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModCollapsesT, MeshT, Collapses);
  explicit ModCollapsesT(MeshT& mesh) : Base(mesh, true) {}
  void initialize() override { collapses.clear(); }
  void postprocess_collapse(const CollapseInfo& collapse) override {
    collapses.emplace_back(collapse.v0.idx(), collapse.v1.idx());
  }

  std::vector<Collapse> collapses;
};

/// Stops a run after `limit` collapses.
class StoppingObserver : public OpenMesh::Decimater::Observer {
 public:
  explicit StoppingObserver(std::size_t limit, std::size_t interval = 1) : Observer(interval), limit_(limit) {}
  void notify(std::size_t step) override { steps.push_back(step); }
  bool abort() const override { return !steps.empty() && steps.back() >= limit_; }

  std::vector<std::size_t> steps;

 private:
  std::size_t limit_;
};

/// Whether two contractions are equal, with exactly equal positions and costs.
inline bool same_bits(const Contraction& a, const Contraction& b) {
  return a.survivor == b.survivor && a.removed == b.removed && a.position == b.position && a.cost == b.cost;
}

/// Expects two runs to have made the same contractions, to the bit.
inline void expect_same_contractions(const std::vector<Contraction>& expected, const std::vector<Contraction>& actual,
                                     const std::string& context) {
  const auto [e, a] = std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end(), same_bits);
  if (e == expected.end() && a == actual.end()) return;
  const auto text = [](auto it, auto end) {
    if (it == end) return std::string("the end");
    std::ostringstream out;
    out.precision(17);
    out << it->removed << " into " << it->survivor << " at (" << it->position.transpose() << "), cost " << it->cost;
    return out.str();
  };
  ADD_FAILURE() << context << ": contraction " << e - expected.begin() << " of " << expected.size() << ": expected "
                << text(e, expected.end()) << ", got " << text(a, actual.end());
}

}  // namespace whittle::test
