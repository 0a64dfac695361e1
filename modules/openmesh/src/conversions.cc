#include "whittle/openmesh/conversions.hh"

#include "whittle/openmesh/detail/status_bits.hh"

namespace whittle::detail {

VertexNumbers number_vertices(const OpenMesh::ArrayKernel& mesh, const std::vector<Index>& firsts) {
  VertexNumbers result;
  result.number_of.resize(mesh.n_vertices());
  result.handles.reserve(mesh.n_vertices());
  const ConstStatusBits<OpenMesh::VertexHandle> bits(mesh);
  for (Index v = 0; v < mesh.n_vertices(); ++v) {
    if (bits.is_deleted(OpenMesh::VertexHandle(static_cast<int>(v)))) continue;
    if (!firsts.empty() && firsts[v] != v) {
      result.number_of[v] = result.number_of[firsts[v]];
    } else {
      result.number_of[v] = static_cast<Index>(result.handles.size());
      result.handles.push_back(v);
    }
  }
  return result;
}

std::vector<Triangle> faces_of(const OpenMesh::ArrayKernel& mesh, const VertexNumbers& numbers) {
  std::vector<Triangle> faces;
  faces.reserve(mesh.n_faces());
  const ConstStatusBits<OpenMesh::FaceHandle> bits(mesh);
  for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) {
    const OpenMesh::FaceHandle f(i);
    if (bits.is_deleted(f)) continue;
    const auto corners = face_corners(mesh, f);
    const auto number = [&](std::size_t corner) {
      return numbers.number_of[static_cast<std::size_t>(corners[corner].idx())];
    };
    faces.push_back({number(0), number(1), number(2)});
  }
  return faces;
}

}  // namespace whittle::detail
