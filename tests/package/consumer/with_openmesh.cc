// A program of another project that has an OpenMesh mesh: Whittle's module in OpenMesh's own decimater, beside the
// engine on the same mesh.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <cstdio>
#include <vector>
#include <whittle/engine/decimate.hh>
#include <whittle/engine/indexed_mesh.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "torus.hh"

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

int main() {
  const Torus torus(48, 24);
  constexpr std::size_t target = 300;

  Mesh mesh;
  for (const auto& p : torus.points)
    mesh.add_vertex(Mesh::Point(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])));
  for (const auto& face : torus.faces)
    mesh.add_face(mesh.vertex_handle(face[0]), mesh.vertex_handle(face[1]), mesh.vertex_handle(face[2]));

  whittle::IndexedMesh copy;
  for (const auto vertex : mesh.vertices()) {
    const Mesh::Point& p = mesh.point(vertex);
    copy.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto& face : torus.faces) copy.faces.push_back({face[0], face[1], face[2]});

  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  whittle::ModGarlandHeckbertT<Mesh>::Handle module;
  if (!decimater.add(module) || !decimater.initialize()) return 1;
  decimater.decimate_to_faces(0, target);
  mesh.garbage_collection();

  const whittle::Decimation decimation = whittle::decimate(copy, {.faces = target});

  std::printf("%zu faces became %zu in OpenMesh's decimater and %zu in the engine\n", torus.faces.size(),
              mesh.n_faces(), decimation.mesh.faces.size());
  return mesh.n_faces() == target && decimation.mesh.faces.size() == target ? 0 : 1;
}
