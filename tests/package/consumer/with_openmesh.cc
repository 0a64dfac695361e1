// A program of another project that has an OpenMesh mesh: Whittle's module in OpenMesh's own decimater, the same module
// in Whittle's decimater, and the engine on plain arrays.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <cstdio>
#include <whittle/core/indexed_mesh.hh>
#include <whittle/engine/decimate.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/pair_decimater.hh>

#include "../../../apps/examples/torus.hh"
#include "digest.hh"

namespace {

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Mesh openmesh_of(const Torus& torus) {
  Mesh mesh;
  for (const auto& p : torus.points)
    mesh.add_vertex(Mesh::Point(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])));
  for (const auto& face : torus.faces)
    mesh.add_face(mesh.vertex_handle(face[0]), mesh.vertex_handle(face[1]), mesh.vertex_handle(face[2]));
  return mesh;
}

whittle::IndexedMesh arrays_of(const Torus& torus) {
  whittle::IndexedMesh mesh;
  for (const auto& p : torus.points) mesh.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& face : torus.faces) mesh.faces.push_back({face[0], face[1], face[2]});
  return mesh;
}

template <class Decimater>
std::size_t faces_after(Decimater&& decimater, Mesh& mesh, std::size_t target) {
  typename whittle::ModGarlandHeckbertT<Mesh>::Handle module;
  decimater.add(module);
  decimater.initialize();
  decimater.decimate_to_faces(0, target);
  mesh.garbage_collection();
  return mesh.n_faces();
}

unsigned long long digest_of(const Mesh& mesh) {
  Digest digest;
  for (const Mesh::VertexHandle v : mesh.vertices())
    for (const float x : mesh.point(v)) digest.add(static_cast<double>(x));
  for (const Mesh::FaceHandle f : mesh.faces())
    for (const Mesh::VertexHandle v : mesh.fv_range(f)) digest.add(static_cast<std::uint64_t>(v.idx()));
  return digest.value();
}

}  // namespace

int main() {
  const Torus torus(48, 24);
  constexpr std::size_t target = 300;

  Mesh first = openmesh_of(torus);
  const std::size_t stock = faces_after(OpenMesh::Decimater::DecimaterT<Mesh>(first), first, target);
  Mesh second = openmesh_of(torus);
  const std::size_t pairs = faces_after(whittle::PairDecimaterT<Mesh>(second), second, target);
  const std::size_t engine =
      whittle::decimate(arrays_of(torus), whittle::DecimateTarget::faces(target)).mesh.faces.size();

  // OpenMesh's decimater is compiled with this program, so its rounding depends on the flags: no digest of its result.
  std::printf("%zu faces became %zu in OpenMesh's decimater, %zu in Whittle's, %zu in the engine, digest %llx\n",
              torus.faces.size(), stock, pairs, engine, digest_of(second));
  return stock == target && pairs == target && engine == target ? 0 : 1;
}
