#include "surface/mesh_lines.hh"

namespace whittle::polishing {

MeshLines::MeshLines(std::span<const VertexPair> borders, std::span<const VertexPair> features,
                     std::span<const VertexPair> seams, std::size_t n_vertices) {
  for (const auto& [from, to] : borders) edges_.push_back({from, to, LineKind::border});
  for (const auto& [from, to] : features) edges_.push_back({from, to, LineKind::feature});
  for (const auto& [from, to] : seams) edges_.push_back({from, to, LineKind::seam});
  edges_at_ = {n_vertices, [this](const auto& add) {
                 for (Index e = 0; e < edges_.size(); ++e) {
                   add(edges_[e].from, e);
                   add(edges_[e].to, e);
                 }
               }};
}

}  // namespace whittle::polishing
