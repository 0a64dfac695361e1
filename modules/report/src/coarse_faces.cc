#include <algorithm>
#include <compare>
#include <span>
#include <utility>
#include <vector>

#include "whittle/core/wedges.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/report/page.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::report {
namespace {

/// The mesh with only the attributes that must stay in place: texture charts, and areas of one material.
IndexedMesh with_charts_alone(IndexedMesh mesh) {
  mesh.normals.clear();
  mesh.colors.clear();
  mesh.face_attributes.clear();
  mesh.origins.clear();
  std::erase_if(mesh.attributes, [](const Attribute& one) { return one.kind != AttributeKind::texcoord; });
  return mesh;
}

double texcoord_distance_sq(const IndexedMesh& mesh, Index a, Index b) {
  double sum = 0;
  for (const Attribute& attribute : mesh.attributes) {
    for (std::size_t i = 0; i < attribute.n_components; ++i) {
      const double difference = attribute.value(a)[i] - attribute.value(b)[i];
      sum += difference * difference;
    }
  }
  return sum;
}

/// A wedge of a vertex that stays, and which one of the merged wedges it became.
struct KeptWedge {
  Index vertex, merged, wedge;
  auto operator<=>(const KeptWedge&) const = default;
};

std::vector<KeptWedge> kept_wedges(const IndexedMesh& mesh, std::span<const Index> vertex_map,
                                   std::span<const Index> merged) {
  std::vector<KeptWedge> kept;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      if (vertex_map[v] == v) kept.push_back({v, merged[mesh.wedge(f, k)], mesh.wedge(f, k)});
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

/// The wedges at the corners of fewer faces: of each corner, one that merged with the one that it had, so is of the
/// same chart. Where the vertex that took the corner over has none there, the one with the nearest texture coordinates.
std::vector<Index> wedges_of(const IndexedMesh& charts, const IndexOnlyDecimation& fewer) {
  const std::vector<Index> merged = wedge_map(charts, fewer.vertex_map, fewer.face_origins);
  const std::vector<KeptWedge> kept = kept_wedges(charts, fewer.vertex_map, merged);
  std::vector<Index> wedges;
  wedges.reserve(3 * fewer.faces.size());
  for (std::size_t f = 0; f < fewer.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = fewer.faces[f][k];
      const Index before = charts.wedge(fewer.face_origins[f], k);
      auto best = std::lower_bound(kept.begin(), kept.end(), KeptWedge{v, merged[before], 0});
      if (best == kept.end() || best->vertex != v || best->merged != merged[before]) {
        const auto first = std::lower_bound(kept.begin(), kept.end(), KeptWedge{v, 0, 0});
        const auto last = std::find_if(first, kept.end(), [v](const KeptWedge& one) { return one.vertex != v; });
        best = std::min_element(first, last, [&](const KeptWedge& a, const KeptWedge& b) {
          return texcoord_distance_sq(charts, a.wedge, before) < texcoord_distance_sq(charts, b.wedge, before);
        });
      }
      wedges.push_back(best->wedge);
    }
  }
  return wedges;
}

}  // namespace

CoarseFaces coarse_faces(const IndexedMesh& mesh, unsigned threads) {
  constexpr std::size_t n_coarse = 10'000;
  if (mesh.faces.size() < 2 * n_coarse) return {};
  const DecimateTarget target = DecimateTarget::faces(n_coarse);
  SimplifyOptions options;
  options.decimate.threads = threads;
  const IndexedMesh charts = with_charts_alone(mesh);
  IndexOnlyDecimation fewer =
      decimate_index_only(charts, target, with_effort(Effort::fast, options, charts, target).decimate);
  if (fewer.faces.size() > mesh.faces.size() / 2) return {};
  CoarseFaces coarse;
  if (!mesh.wedges.empty()) coarse.wedges = wedges_of(charts, fewer);
  if (!mesh.face_groups.empty()) {
    for (const Index f : fewer.face_origins) coarse.face_groups.push_back(mesh.face_groups[f]);
  }
  coarse.faces = std::move(fewer.faces);
  return coarse;
}

}  // namespace whittle::report
