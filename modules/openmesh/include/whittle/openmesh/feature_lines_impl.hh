#pragma once

#include <algorithm>
#include <utility>

#include "whittle/openmesh/feature_lines.hh"

namespace whittle {

template <class MeshT>
bool FeatureLinesT<MeshT>::has_feature_bits(const MeshT& mesh) {
  const auto edges = mesh.edges();
  const auto vertices = mesh.vertices();
  const auto is_feature = [&mesh](auto handle) { return mesh.status(handle).feature(); };
  return std::any_of(edges.begin(), edges.end(), is_feature) ||
         std::any_of(vertices.begin(), vertices.end(), is_feature);
}

template <class MeshT>
bool FeatureLinesT<MeshT>::may_move(VertexHandle v, EdgeHandle along) const {
  if (!any_) return true;
  const int n = count_feature_edges(mesh_, v);
  return n == 2 ? is_feature(along) : n == 0 && !mesh_.status(v).feature();
}

template <class MeshT>
OpenMesh::HalfedgeHandle FeatureLinesT<MeshT>::next_on_line(VertexHandle v, EdgeHandle edge) const {
  if (count_feature_edges(mesh_, v) != 2) return HalfedgeHandle();
  for (const HalfedgeHandle h : mesh_.voh_range(v)) {
    if (mesh_.edge_handle(h) != edge && is_feature(mesh_.edge_handle(h))) return h;
  }
  return HalfedgeHandle();
}

template <class MeshT>
template <class PositionOf>
bool FeatureLinesT<MeshT>::bends_a_line(const CollapseInfo& collapse, VertexHandle moved, const Vec3& to,
                                        const PositionOf& position_of) const {
  if (!any_) return false;
  const auto are_features = [this](HalfedgeHandle g, HalfedgeHandle h) {
    return g.is_valid() && is_feature(mesh_.edge_handle(g)) && is_feature(mesh_.edge_handle(h));
  };
  if (are_features(collapse.v0vl, collapse.vlv1) || are_features(collapse.vrv0, collapse.v1vr)) return true;
  const EdgeHandle edge = mesh_.edge_handle(collapse.v0v1);
  if (!is_feature(edge)) return false;
  // The vertex that moves takes its line's next edge along.
  const HalfedgeHandle next = next_on_line(moved, edge);
  if (!next.is_valid()) return false;
  const Vec3 way = position_of(mesh_.to_vertex_handle(next)) - to;
  const auto is_far = [&](const Vec3& point) {
    const Vec3 offset = point - to;
    const double share = way.squaredNorm() > 0 ? std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    return (offset - share * way).squaredNorm() > tolerance_sq_;
  };
  if (is_far(position_of(moved))) return true;
  for (const EdgeHandle part : {edge, mesh_.edge_handle(next)}) {
    const auto course = courses_.find(part.idx());
    if (course != courses_.end() && std::any_of(course->second.begin(), course->second.end(), is_far)) return true;
  }
  return false;
}

template <class MeshT>
template <class PositionOf>
void FeatureLinesT<MeshT>::note_collapse(const CollapseInfo& collapse, VertexHandle moved,
                                         const PositionOf& position_of) {
  if (!any_) return;
  const EdgeHandle edge = mesh_.edge_handle(collapse.v0v1);
  if (is_feature(edge)) {
    const Course course = std::move(courses_[edge.idx()]);
    courses_.erase(edge.idx());
    if (const HalfedgeHandle next = next_on_line(moved, edge); next.is_valid()) {
      Course& whole = courses_[mesh_.edge_handle(next).idx()];
      whole.push_back(position_of(moved));
      whole.insert(whole.end(), course.begin(), course.end());
    }
  }
  const auto carry = [this](HalfedgeHandle from, HalfedgeHandle into) {  // of the two edges v1's is left
    if (!from.is_valid()) return;
    const auto course = courses_.find(mesh_.edge_handle(from).idx());
    if (course == courses_.end()) return;
    Course vertices = std::move(course->second);
    courses_.erase(course);
    courses_[mesh_.edge_handle(into).idx()] = std::move(vertices);
  };
  carry(collapse.v0vl, collapse.vlv1);
  carry(collapse.vrv0, collapse.v1vr);
}

}  // namespace whittle
