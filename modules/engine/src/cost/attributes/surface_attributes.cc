#include "cost/attributes/surface_attributes.hh"

#include <algorithm>
#include <array>
#include <cstdint>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

/// A face of the input in a wedge, and how many of its corners are there.
struct FaceOfWedge {
  Index face;
  std::uint32_t n_corners;
};
using FacesOfWedges = detail::IndexLists<FaceOfWedge, std::size_t>;

FacesOfWedges faces_of_wedges(const IndexedMesh& input, std::span<const Index> wedge_of, std::size_t n_wedges) {
  return FacesOfWedges(n_wedges, [&](const auto& emit) {
    for (Index f = 0; f < input.faces.size(); ++f) {
      const std::array wedges{wedge_of[input.wedge(f, 0)], wedge_of[input.wedge(f, 1)], wedge_of[input.wedge(f, 2)]};
      for (auto w = wedges.begin(); w != wedges.end(); ++w) {
        const bool is_new = std::find(wedges.begin(), w, *w) == w;
        const auto n = static_cast<std::uint32_t>(std::count(w, wedges.end(), *w));
        if (is_new && *w != invalid_index) emit(*w, {f, n});
      }
    }
  });
}

}  // namespace

SurfaceAttributes sum_attributes(const IndexedMesh& input, const Frame& frame, const ScaledAttributes& attributes,
                                 std::span<const Index> wedge_of, std::vector<Index> vertex_of,
                                 std::span<const Vec3> positions, unsigned threads) {
  const std::size_t n_wedges = vertex_of.size();
  const FacesOfWedges faces_of = faces_of_wedges(input, wedge_of, n_wedges);
  SurfaceAttributes sums{WedgeQuadrics(n_wedges, attributes.n_components), std::move(vertex_of), attributes.farthest};
  const auto add_face = [&](Index w, const FaceOfWedge& at) {
    const auto& [f, n_corners] = at;
    const auto corner = [&, f = f](std::size_t k) { return frame.to_frame(input.positions[input.faces[f][k]]); };
    const auto values = [&, f = f](std::size_t k) {
      return attributes.values.data() + input.wedge(f, k) * attributes.stride();
    };
    const FaceGradient gradient({corner(0), corner(1), corner(2)});
    if (!(gradient.area > 0)) return;
    const Vec3 from_center = positions[sums.vertex_of[w]] - gradient.center;
    sums.wedges.add_face(w, n_corners * gradient.area, gradient, from_center, {values(0), values(1), values(2)});
  };
  for_each_range(n_wedges, threads, [&](std::size_t begin, std::size_t end) {
    for (auto w = static_cast<Index>(begin); w < end; ++w) {
      for (const FaceOfWedge& at : faces_of.of(w)) add_face(w, at);
    }
  });
  return sums;
}

}  // namespace whittle
