#include "attributes/attribute_feet.hh"

#include "surface/vertex_blocks.hh"

namespace whittle::polishing {

AttributeFeet find_attribute_feet(const Origins& origins, const Surface& mesh, const detail::Workers& workers) {
  const OriginalSurface& original = origins.original();
  AttributeFeet feet;
  feet.of_vertices.resize(original.positions().size());
  feet.of_faces.resize(original.faces().size());
  feet.of_wedges.resize(origins.n_vertices());
  const VertexBlocks blocks(origins.n_vertices());
  for_each_block(blocks.size(), workers, [&](std::size_t block) {
    MergedPoints points(origins, mesh, blocks.end(block));
    for (Index v = blocks.begin(block); v < blocks.end(block); ++v) {
      points.find(v);
      std::size_t i = 0;
      for (const Index origin : origins.of(v)) {
        feet.of_vertices[origin] = {points.feet()[i], points.weights()[i], v};
        ++i;
      }
      for (const Corner& corner : origins.corners_of(v)) {
        feet.of_faces[corner.face] = {points.feet()[i], points.weights()[i], v};
        ++i;
      }
      const Index nearest = origins.nearest(v, mesh.positions[v]);
      if (nearest != invalid_index) feet.of_wedges[v] = original.nearest(mesh.positions[v], nearest);
    }
  });
  return feet;
}

}  // namespace whittle::polishing
