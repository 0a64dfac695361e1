#include "initial_quadrics.hh"

#include "whittle/engine/parallel.hh"

namespace whittle {
namespace {

void add_border_planes(TriangleComplex& complex, Index v, const QuadricOptions& options, SymmetricMatrix& sum) {
  const auto add_if_border = [&](Index from, Index to, Index opposite) {
    if (complex.n_initial_faces_between(from, to) != 1) return;
    sum += border_quadric(complex.position(from), complex.position(to), complex.position(opposite), options);
  };
  for (const Corner& corner : complex.corners(v)) {
    add_if_border(v, corner.next, corner.previous);
    add_if_border(corner.previous, v, corner.next);
  }
}

}  // namespace

void set_initial_quadrics(TriangleComplex& complex, const QuadricOptions& options, unsigned threads) {
  const auto sum_at = [&](Index v) {
    SymmetricMatrix sum;
    for (const Corner& corner : complex.corners(v)) {
      sum += corner_quadric(complex.position(v), complex.position(corner.next), complex.position(corner.previous),
                            options);
    }
    if (options.boundary_weight > 0 && complex.order(v) != VertexOrder::regular) {
      add_border_planes(complex, v, options, sum);
    }
    return sum;
  };
  for_each_range(complex.n_vertex_slots(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      complex.set_quadric(v, sum_at(v));
    }
  });
}

}  // namespace whittle
