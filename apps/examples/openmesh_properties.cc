// Decimates an OpenMesh mesh whose vertices carry texture coordinates and a property of our own.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <algorithm>
#include <cstdio>
#include <set>
#include <whittle/openmesh/garbage_collection.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/pair_decimater.hh>

#include "torus.hh"

namespace {

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::TexCoord2D);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// A texture seen from above: the texture coordinates of a point are its x and y.
Mesh textured_torus() {
  const Torus torus(48, 24);
  Mesh mesh;
  for (const auto& p : torus.points) {
    const Mesh::Point point(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
    mesh.set_texcoord2D(mesh.add_vertex(point), {point[0], point[1]});
  }
  for (const auto& [a, b, c] : torus.faces)
    mesh.add_face(mesh.vertex_handle(a), mesh.vertex_handle(b), mesh.vertex_handle(c));
  return mesh;
}

}  // namespace

int main() {
  Mesh mesh = textured_torus();
  // A property of our own: the number that each vertex had in the input.
  OpenMesh::VProp<int> input_vertex(mesh, "input_vertex");
  for (const Mesh::VertexHandle v : mesh.vertices()) input_vertex[v] = v.idx();

  whittle::PairDecimaterT<Mesh> decimater(mesh);
  whittle::ModGarlandHeckbertT<Mesh>::Handle cost;
  decimater.add(cost);
  decimater.initialize();
  decimater.decimate(whittle::DecimateTarget::faces(500));
  whittle::collect_garbage(mesh);  // removes elements that are marked as deleted

  // A surviving vertex keeps properties of whole numbers. Texture coordinates, colours, normals and properties of real
  // numbers have the value at its new position: linear functions of the position stay linear.
  std::set<int> survivors;
  float worst = 0;
  for (const Mesh::VertexHandle v : mesh.vertices()) {
    survivors.insert(input_vertex[v]);
    const Mesh::Point here = mesh.point(v);
    worst = std::max(worst, (mesh.texcoord2D(v) - Mesh::TexCoord2D(here[0], here[1])).norm());
  }
  std::printf("%zu faces, %zu vertices of the input survive, texture coordinates are off by %.3f at most\n",
              mesh.n_faces(), survivors.size(), static_cast<double>(worst));
  return mesh.n_faces() == 500 && survivors.size() == mesh.n_vertices() && worst < 0.1F ? 0 : 1;
}
