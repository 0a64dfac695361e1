#include "original/origins.hh"

namespace whittle::polishing {

Origins::Origins(const OriginalSurface& original, std::span<const Index> vertex_map, std::size_t n_vertices,
                 std::size_t points_per_face, const detail::Workers& workers)
    : original_(original), vertex_map_(vertex_map), points_per_face_(points_per_face) {
  workers.update(0);
  vertices_ = {n_vertices, [&](const auto& add) {
                 for (Index v = 0; v < vertex_map.size(); ++v) {
                   if (vertex_map[v] != invalid_index) add(vertex_map[v], v);
                 }
               }};
  workers.update(0);
  corners_ = {n_vertices, [&](const auto& add) {
                const std::span<const Triangle> faces = original.faces();
                const Index n_slots = points_per_face > 1 ? 3 : 1;
                for (Index f = 0; f < faces.size(); ++f) {
                  for (Index slot = 0; slot < n_slots; ++slot) {
                    const Index to = vertex_map[faces[f][slot]];
                    if (to != invalid_index) add(to, Corner{f, slot});
                  }
                }
              }};
}

Index Origins::nearest(Index v, const Vec3& point) const {
  NearestVertex nearest{point};
  for (const Index origin : of(v)) nearest.look_at(origin, original_.positions()[origin]);
  return nearest.vertex;
}

}  // namespace whittle::polishing
