#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/corner_properties.hh"

// Keeps what halfedges carry through OpenMesh's own decimaters, as a binary module. `PairDecimaterT` does it by itself.
//
//   collapse v0 -> v1:   on each side of the edge, the corners at v0 and v1 become one: their blend
//   refuses              v0 on a seam, unless the edge runs along that seam, and the seam goes on beyond v0
//
// A seam is an edge at which texture coordinates or colours of the faces on both sides differ.

namespace whittle {

/// Without it, OpenMesh's decimaters leave the faces of a removed vertex with its texture coordinates, though the
/// vertex is elsewhere. What vertices carry is blended by the cost modules with placement; others leave v1, and what it
/// carries, as they are.
template <class MeshT>
class ModAttributesT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModAttributesT, MeshT, Attributes);

  explicit ModAttributesT(MeshT& mesh) : Base(mesh, true), mesh_(mesh), corners_(mesh) {}

  /// Halfedges have the properties then that are kept.
  void initialize() override { corners_ = CornerProperties(mesh_); }
  float collapse_priority(const CollapseInfo& collapse) override {
    const bool is_legal = corners_.empty() || keeps_seams(collapse);
    return static_cast<float>(is_legal ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
  }
  void preprocess_collapse(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

 private:
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using VertexHandle = OpenMesh::VertexHandle;
  using Values = std::vector<double>;
  struct Corner {
    OpenMesh::FaceHandle face;
    VertexHandle vertex;
    Values values;
  };
  /// The corners of the collapsing edge in one of its two faces.
  struct Side {
    Values removed, survivor;
  };

  Values values(HalfedgeHandle h) const {
    Values all(corners_.size());
    corners_.get(mesh_, h, all);
    return all;
  }
  bool differ(HalfedgeHandle a, HalfedgeHandle b) const;
  bool is_seam(HalfedgeHandle h) const;
  bool keeps_seams(const CollapseInfo& collapse) const;
  std::vector<Side> sides(const CollapseInfo& collapse) const;
  void note_faces(VertexHandle v, const CollapseInfo& collapse);
  Values merged(const Values& corner, Values Side::*end, double share) const;

  MeshT& mesh_;
  CornerProperties corners_;
  // The collapse under way: its sides, and the corners of the faces around that stay.
  std::vector<Side> sides_;
  std::vector<Corner> around_;
};

/// Whether the values of two corners differ in what makes a seam.
template <class MeshT>
bool ModAttributesT<MeshT>::differ(HalfedgeHandle a, HalfedgeHandle b) const {
  const Values of_a = values(a);
  const Values of_b = values(b);
  bool result = false;
  corners_.for_each([&](const auto& column, std::size_t first, std::size_t n) {
    if (column.attribute().kind == AttributeKind::normal) return;
    const auto begin = of_a.begin() + static_cast<std::ptrdiff_t>(first);
    result = result || !std::equal(begin, begin + static_cast<std::ptrdiff_t>(n),
                                   of_b.begin() + static_cast<std::ptrdiff_t>(first));
  });
  return result;
}

template <class MeshT>
bool ModAttributesT<MeshT>::is_seam(HalfedgeHandle h) const {
  const HalfedgeHandle o = mesh_.opposite_halfedge_handle(h);
  if (mesh_.is_boundary(h) || mesh_.is_boundary(o)) return false;
  return differ(h, mesh_.prev_halfedge_handle(o)) || differ(o, mesh_.prev_halfedge_handle(h));
}

/// A vertex within a chart may go anywhere. One on a seam goes along it: its two seam edges are that one and another,
/// which no face of the edge has, as seams would come to lie on each other.
template <class MeshT>
bool ModAttributesT<MeshT>::keeps_seams(const CollapseInfo& collapse) const {
  std::size_t n = 0;
  bool is_along = false;
  bool is_narrow = false;
  for (const HalfedgeHandle h : mesh_.voh_range(collapse.v0)) {
    if (!is_seam(h)) continue;
    ++n;
    const VertexHandle to = mesh_.to_vertex_handle(h);
    is_along = is_along || to == collapse.v1;
    is_narrow = is_narrow || to == collapse.vl || to == collapse.vr;
  }
  return n == 0 || (n == 2 && is_along && !is_narrow && !mesh_.is_boundary(collapse.v0));
}

template <class MeshT>
std::vector<typename ModAttributesT<MeshT>::Side> ModAttributesT<MeshT>::sides(const CollapseInfo& collapse) const {
  std::vector<Side> all;
  // Halfedges at corners point to their vertices.
  if (collapse.fl.is_valid()) {
    all.push_back({values(mesh_.prev_halfedge_handle(collapse.v0v1)), values(collapse.v0v1)});
  }
  if (collapse.fr.is_valid()) {
    all.push_back({values(collapse.v1v0), values(mesh_.prev_halfedge_handle(collapse.v1v0))});
  }
  return all;
}

template <class MeshT>
void ModAttributesT<MeshT>::note_faces(VertexHandle v, const CollapseInfo& collapse) {
  for (const OpenMesh::FaceHandle face : mesh_.vf_range(v)) {
    if (face == collapse.fl || face == collapse.fr) continue;
    for (const HalfedgeHandle h : corner_halfedges(mesh_, face)) {
      around_.push_back({face, mesh_.to_vertex_handle(h), values(h)});
    }
  }
}

template <class MeshT>
void ModAttributesT<MeshT>::preprocess_collapse(const CollapseInfo& collapse) {
  if (corners_.empty()) return;
  sides_ = sides(collapse);
  around_.clear();
  note_faces(collapse.v0, collapse);
  note_faces(collapse.v1, collapse);
}

/// What a corner at v0 or v1 becomes. Attribute by attribute: normals may differ where there is no seam.
/// \param share of v0 in the merged vertex
template <class MeshT>
typename ModAttributesT<MeshT>::Values ModAttributesT<MeshT>::merged(const Values& corner, Values Side::*end,
                                                                     double share) const {
  Values result = corner;
  corners_.for_each([&](const auto& column, std::size_t first, std::size_t n) {
    const auto own = std::span(result).subspan(first, n);
    const auto part = [&](const Values& values) { return std::span(values).subspan(first, n); };
    const auto side = std::find_if(sides_.begin(), sides_.end(), [&](const Side& s) {
      const auto of_side = part(s.*end);
      return std::equal(own.begin(), own.end(), of_side.begin());
    });
    if (side == sides_.end()) return;
    AttributeBlend mean(column.attribute().kind, n);
    if (share > 0) mean.add(part(side->removed), share);
    if (share < 1) mean.add(part(side->survivor), 1 - share);
    mean.result(own);
  });
  return result;
}

/// All corners around are written, as halfedges of vanished faces may have taken the place of others.
template <class MeshT>
void ModAttributesT<MeshT>::postprocess_collapse(const CollapseInfo& collapse) {
  if (corners_.empty()) return;
  const double share = nearest_share(to_vec3(mesh_.point(collapse.v1)), to_vec3(collapse.p1), to_vec3(collapse.p0));
  for (const Corner& corner : around_) {
    const bool was_removed = corner.vertex == collapse.v0;
    const bool is_merged = was_removed || corner.vertex == collapse.v1;
    const VertexHandle at = was_removed ? collapse.v1 : corner.vertex;
    for (const HalfedgeHandle h : corner_halfedges(mesh_, corner.face)) {
      if (mesh_.to_vertex_handle(h) != at) continue;
      corners_.set(
          mesh_, h,
          is_merged ? merged(corner.values, was_removed ? &Side::removed : &Side::survivor, share) : corner.values);
    }
  }
}

}  // namespace whittle
