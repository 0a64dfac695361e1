#pragma once

#include <algorithm>
#include <string>
#include <vector>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/mod_lindstrom_turk.hh>
#include <whittle/openmesh/mod_memoryless.hh>
#include <whittle/openmesh/mod_midpoint.hh>

#include "meshes.hh"

namespace whittle::test {

/// Adds a module to any decimater.
template <class ModuleT, class DecimaterT>
ModuleT& add_module(DecimaterT& decimater) {
  typename ModuleT::Handle handle;
  EXPECT_TRUE(decimater.add(handle));
  return decimater.module(handle);
}

/// Adds the cost module that has these options.
template <class DecimaterT>
PlacingModuleT<typename DecimaterT::Mesh>& add_cost(DecimaterT& decimater, const CostOptions& options) {
  using MeshT = typename DecimaterT::Mesh;
  const auto with_valences = [&options](PlacingModuleT<MeshT>& module) -> PlacingModuleT<MeshT>& {
    module.set_valence_weight(options.valence_weight);
    return module;
  };
  if (options.cost == Cost::midpoint) return with_valences(add_module<ModMidpointT<MeshT>>(decimater));
  if (options.cost == Cost::lindstrom_turk) return with_valences(add_module<ModLindstromTurkT<MeshT>>(decimater));
  if (options.cost == Cost::memoryless) {
    auto& module = add_module<ModMemorylessT<MeshT>>(decimater);
    module.set_options(options.quadric);
    return with_valences(module);
  }
  auto& module = add_module<ModGarlandHeckbertT<MeshT>>(decimater);
  module.set_options(options.quadric);
  module.set_isotropy(options.isotropy);
  return with_valences(module);
}

struct NamedCost {
  std::string name;
  CostOptions options;
};

/// Every cost module, and every term.
inline std::vector<NamedCost> named_costs() {
  return {{"quadric", {}},
          {"quadric_valence", {Cost::quadric, {}, 0, 1}},
          {"quadric_isotropy", {Cost::quadric, {}, 0.4, 0}},
          {"isotropy_only", {Cost::quadric, {}, 1, 0.5}},
          {"memoryless", {Cost::memoryless, {}, 0, 0}},
          {"memoryless_valence", {Cost::memoryless, {}, 0, 1}},
          {"midpoint", {Cost::midpoint, {}, 0, 0}},
          {"lindstrom_turk", {Cost::lindstrom_turk, {}, 0, 0}},
          {"lindstrom_turk_valence", {Cost::lindstrom_turk, {}, 0, 1}}};
}

/// The ends of an edge, the lower index first.
VertexPair ends(const auto& mesh, OpenMesh::EdgeHandle e) {
  const auto index = [&](unsigned side) {
    return static_cast<Index>(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)).idx());
  };
  return {std::min(index(0), index(1)), std::max(index(0), index(1))};
}

/// The edges with the feature bit, ascending.
template <class MeshT>
std::vector<VertexPair> marked_edges(const MeshT& mesh) {
  std::vector<VertexPair> edges;
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    if (mesh.status(e).feature()) edges.push_back(ends(mesh, e));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Sets the feature bit on those of these edges that exist.
template <class MeshT>
void mark_edges(MeshT& mesh, const std::vector<VertexPair>& edges) {
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    mesh.status(e).set_feature(std::binary_search(edges.begin(), edges.end(), ends(mesh, e)));
  }
}

}  // namespace whittle::test
