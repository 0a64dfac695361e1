#include "attributes/attribute_samples.hh"

#include "surface/vertex_blocks.hh"

namespace whittle::polishing {

AttributeSamples find_attribute_samples(const Origins& origins, const Surface& mesh, const detail::Workers& workers) {
  const OriginalSurface& original = origins.original();
  AttributeSamples samples;
  samples.of_vertices.resize(original.positions().size());
  samples.of_faces.resize(original.faces().size());
  samples.of_wedges.resize(origins.n_vertices());
  const VertexBlocks blocks(origins.n_vertices());
  for_each_block(blocks.size(), workers, [&](std::size_t block) {
    MergedPoints points(origins, mesh, blocks.end(block));
    for (Index v = blocks.begin(block); v < blocks.end(block); ++v) {
      points.find(v);
      std::size_t i = 0;
      for (const Index origin : origins.of(v)) {
        samples.of_vertices[origin] = {points.closest_points()[i], points.weights()[i], v};
        ++i;
      }
      for (const Corner& corner : origins.corners_of(v)) {
        samples.of_faces[corner.face] = {points.closest_points()[i], points.weights()[i], v};
        ++i;
      }
      const Index nearest = origins.nearest(v, mesh.positions[v]);
      if (nearest != invalid_index) samples.of_wedges[v] = original.nearest(mesh.positions[v], nearest);
    }
  });
  return samples;
}

}  // namespace whittle::polishing
