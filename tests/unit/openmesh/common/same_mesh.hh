#pragma once

#include <gtest/gtest.h>

#include <string>

#include "meshes.hh"

namespace whittle::test {

/// Requests all status bits.
inline void request_status(DoubleMesh& mesh) {
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
}

/// With all status bits; every seventh edge is a feature.
inline DoubleMesh mesh_with_status(const IndexedMesh& shape) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  request_status(mesh);
  for (const OpenMesh::EdgeHandle e : mesh.edges()) mesh.status(e).set_feature(e.idx() % 7 == 0);
  return mesh;
}

/// Compares every handle and every status bit of elements that aren't deleted. The outgoing halfedge of an inner vertex
/// may differ.
inline void expect_same_mesh(const DoubleMesh& expected, const DoubleMesh& actual, const std::string& context) {
  for (int i = 0; i < static_cast<int>(expected.n_edges()); ++i) {
    const OpenMesh::EdgeHandle e(i);
    ASSERT_EQ(actual.status(e).deleted(), expected.status(e).deleted()) << context << ": edge " << i;
    for (const unsigned side : {0U, 1U}) {
      const OpenMesh::HalfedgeHandle h = expected.halfedge_handle(e, side);
      ASSERT_EQ(actual.status(h).bits(), expected.status(h).bits()) << context << ": halfedge " << h.idx();
      if (expected.status(e).deleted()) continue;
      ASSERT_EQ(actual.status(e).bits(), expected.status(e).bits()) << context << ": edge " << i;
      ASSERT_EQ(actual.to_vertex_handle(h), expected.to_vertex_handle(h)) << context << ": halfedge " << h.idx();
      ASSERT_EQ(actual.next_halfedge_handle(h), expected.next_halfedge_handle(h)) << context << ": " << h.idx();
      ASSERT_EQ(actual.prev_halfedge_handle(h), expected.prev_halfedge_handle(h)) << context << ": " << h.idx();
      ASSERT_EQ(actual.face_handle(h), expected.face_handle(h)) << context << ": halfedge " << h.idx();
    }
  }
  for (int i = 0; i < static_cast<int>(expected.n_faces()); ++i) {
    const OpenMesh::FaceHandle f(i);
    ASSERT_EQ(actual.status(f).bits(), expected.status(f).bits()) << context << ": face " << i;
    ASSERT_EQ(actual.halfedge_handle(f), expected.halfedge_handle(f)) << context << ": face " << i;
  }
  for (int i = 0; i < static_cast<int>(expected.n_vertices()); ++i) {
    const OpenMesh::VertexHandle v(i);
    ASSERT_EQ(actual.status(v).bits(), expected.status(v).bits()) << context << ": vertex " << i;
    ASSERT_EQ(actual.is_isolated(v), expected.is_isolated(v)) << context << ": vertex " << i;
    if (expected.is_isolated(v)) continue;
    ASSERT_EQ(actual.from_vertex_handle(actual.halfedge_handle(v)), v) << context;
    ASSERT_EQ(actual.is_boundary(v), expected.is_boundary(v)) << context << ": vertex " << i;
  }
}

}  // namespace whittle::test
