#include "initial_quadrics.hh"

#include "whittle/engine/parallel.hh"

namespace whittle {
namespace {

/// The corner of `face` that v is: 0, 1 or 2.
std::size_t corner_of(const Triangle& face, Index v) { return face[0] == v ? 0 : face[1] == v ? 1 : 2; }

std::array<Vec3, 3> corners_of(const TriangleComplex& complex, Index f) {
  const Triangle& face = complex.face(f);
  return {complex.position(face[0]), complex.position(face[1]), complex.position(face[2])};
}

/// √w n of every face, computed once where it is the same at all its corners.
std::vector<Vec3> face_normals(const TriangleComplex& complex, const QuadricOptions& options, unsigned threads) {
  if (options.weights == Weights::area_angle) return {};
  std::vector<Vec3> normals(complex.n_face_slots());
  for_each_range(normals.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      normals[f] = weighted_normal(corners_of(complex, static_cast<Index>(f)), options.weights);
    }
  });
  return normals;
}

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

std::vector<Quadric> initial_quadrics(const TriangleComplex& complex, const QuadricOptions& options, unsigned threads) {
  const std::vector<Vec3> normals = face_normals(complex, options, threads);
  const auto share_of = [&](Index f, Index v) {
    if (!normals.empty()) return plane_quadric(normals[f], options);
    return face_quadrics(corners_of(complex, f), options)[corner_of(complex.face(f), v)];
  };
  const auto sum_at = [&](Index v) {
    SymmetricMatrix sum;
    for (const Index f : complex.faces_at(v)) sum += share_of(f, v);
    if (options.boundary_weight > 0 && complex.order(v) != VertexOrder::regular) {
      add_border_planes(complex, v, options, sum);
    }
    return sum;
  };
  std::vector<Quadric> quadrics(complex.n_vertex_slots());
  for_each_range(quadrics.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) quadrics[v].a = sum_at(static_cast<Index>(v));
  });
  return quadrics;
}

}  // namespace whittle
