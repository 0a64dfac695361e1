#include "initial_quadrics.hh"

namespace whittle {
namespace {

/// The corner of `face` that v is: 0, 1 or 2.
std::size_t corner_of(const Triangle& face, Index v) { return face[0] == v ? 0 : face[1] == v ? 1 : 2; }

void add_border_planes(const TriangleComplex& complex, Index v, const QuadricOptions& options, SymmetricMatrix& sum) {
  const auto add_if_border = [&](Index f, std::size_t from, std::size_t to, std::size_t opposite) {
    if (complex.n_initial_edge_faces(complex.face_edge(f, from)) != 1) return;
    const Triangle& face = complex.face(f);
    sum += border_quadric(complex.position(face[from]), complex.position(face[to]), complex.position(face[opposite]),
                          options);
  };
  for (const Index f : complex.faces_at(v)) {
    const std::size_t corner = corner_of(complex.face(f), v);
    const std::size_t next = (corner + 1) % 3;
    const std::size_t previous = (corner + 2) % 3;
    add_if_border(f, corner, next, previous);
    add_if_border(f, previous, corner, next);
  }
}

}  // namespace

std::vector<Quadric> initial_quadrics(const TriangleComplex& complex, const QuadricOptions& options) {
  std::vector<FacePlane> planes(complex.n_face_slots());
  for (Index f = 0; f < planes.size(); ++f) {
    const Triangle& face = complex.face(f);
    planes[f] =
        face_plane({complex.position(face[0]), complex.position(face[1]), complex.position(face[2])}, options.weights);
  }
  std::vector<Quadric> quadrics(complex.n_vertex_slots());
  for (Index v = 0; v < quadrics.size(); ++v) {
    SymmetricMatrix& sum = quadrics[v].a;
    for (const Index f : complex.faces_at(v)) {
      sum += plane_quadric(planes[f].normal, planes[f].weights[corner_of(complex.face(f), v)], options);
    }
    if (options.boundary_weight > 0 && complex.order(v) != VertexOrder::regular) {
      add_border_planes(complex, v, options, sum);
    }
  }
  return quadrics;
}

}  // namespace whittle
