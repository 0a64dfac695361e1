#include "whittle/openmesh/detail/bulk_collapse.hh"

#include <utility>

namespace whittle {

BulkCollapse::BulkCollapse(OpenMesh::TriConnectivity& mesh, std::span<const VertexMerge> merges)
    : mesh_(mesh),
      vertex_bits_(mesh),
      halfedge_bits_(mesh),
      edge_bits_(mesh),
      face_bits_(mesh),
      fates_(mesh.n_vertices()),
      clusters_(mesh.n_vertices()),
      substitutes_(mesh.n_halfedges()) {
  find_clusters(merges);
}

void BulkCollapse::run() {
  delete_inner_edges();
  update_vertices();
  link_faces();
  link_border();
}

void BulkCollapse::find_clusters(std::span<const VertexMerge> merges) {
  for (std::size_t v = 0; v < clusters_.size(); ++v) clusters_[v] = VertexHandle(static_cast<int>(v));
  for (std::size_t time = merges.size(); time-- > 0;) {  // backwards: the cluster of the survivor is final then
    const auto& [removed, survivor] = merges[time];
    const auto place = static_cast<std::size_t>(removed.idx());
    fates_[place] = {survivor, static_cast<Index>(time)};
    clusters_[place] = cluster(survivor);
  }
}

/// Also deletes the faces at these edges.
void BulkCollapse::delete_inner_edges() {
  for (int i = 0; i < static_cast<int>(mesh_.n_edges()); ++i) {
    const EdgeHandle e(i);
    if (edge_bits_[e].deleted()) continue;
    const HalfedgeHandle h = mesh_.halfedge_handle(e, 0);
    const HalfedgeHandle o = mesh_.halfedge_handle(e, 1);
    if (cluster(mesh_.to_vertex_handle(h)) != cluster(mesh_.to_vertex_handle(o))) continue;
    delete_edge(e);
    delete_face(h);
    delete_face(o);
  }
}

void BulkCollapse::delete_edge(EdgeHandle e) {
  edge_bits_[e].set_deleted(true);
  if (!halfedge_bits_) return;
  for (const unsigned side : {0U, 1U}) halfedge_bits_[mesh_.halfedge_handle(e, side)].set_deleted(true);
}

/// Deletes the face of h, if there is one.
void BulkCollapse::delete_face(HalfedgeHandle h) {
  const FaceHandle face = mesh_.face_handle(h);
  if (!face.is_valid()) return;
  face_bits_[face].set_deleted(true);
  mesh_.set_halfedge_handle(face, HalfedgeHandle());
}

/// A vertex that lost its outgoing halfedge gets a new one in `link_faces`.
void BulkCollapse::update_vertices() {
  for (int i = 0; i < static_cast<int>(mesh_.n_vertices()); ++i) {
    const VertexHandle v(i);
    const HalfedgeHandle h = mesh_.halfedge_handle(v);
    if (cluster(v) != v) {
      vertex_bits_[v].set_deleted(true);
      mesh_.set_isolated(v);
    } else if (h.is_valid() && (edge_bits_[mesh_.edge_handle(h)].deleted() || !ends_strip(h))) {
      mesh_.set_isolated(v);
    }
  }
}

// Strips --------------------------------------------------------------------------------------------------------------

/// \param first the strip's first edge, seen from a face that stays
void BulkCollapse::merge_strip(HalfedgeHandle first) {
  HalfedgeHandle last = first;
  strip_.assign(1, {first, {}});
  while (!ends_strip(mesh_.opposite_halfedge_handle(last))) {
    const Rung next = across(last);
    while (strip_.size() > 1 && strip_.back().meeting.time < next.meeting.time) merge_last_rungs();
    strip_.push_back(next);
    last = next.halfedge;
  }
  while (strip_.size() > 1) merge_last_rungs();

  const auto take_place = [this](HalfedgeHandle end, HalfedgeHandle by) {
    substitute(end) = by;
    if (mesh_.is_boundary(end)) border_.push_back(end);
  };
  const HalfedgeHandle left = strip_.front().halfedge;
  take_place(first, left);
  take_place(mesh_.opposite_halfedge_handle(last), mesh_.opposite_halfedge_handle(left));
}

/// The next edge of the strip, beyond the vanished face on the other side of h. It has the same direction as h: from
/// the same cluster to the same cluster.
BulkCollapse::Rung BulkCollapse::across(HalfedgeHandle h) const {
  const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(h);
  const HalfedgeHandle next = mesh_.next_halfedge_handle(opposite);
  const HalfedgeHandle previous = mesh_.prev_halfedge_handle(opposite);
  const VertexHandle from = mesh_.to_vertex_handle(opposite);
  const VertexHandle to = mesh_.to_vertex_handle(h);
  const VertexHandle third = mesh_.to_vertex_handle(next);
  const bool is_next = cluster(third) == cluster(to);  // the side from `from` to `third`
  return {is_next ? next : previous, meeting(is_next ? to : from, third)};
}

/// \pre two vertices of one cluster
BulkCollapse::Meeting BulkCollapse::meeting(VertexHandle v, VertexHandle w) const {
  for (bool is_swapped = false;;) {
    if (fate(w).time < fate(v).time) {  // v is the next to merge
      std::swap(v, w);
      is_swapped = !is_swapped;
    }
    const Fate& next = fate(v);
    if (next.into == w) return {next.time, !is_swapped};
    v = next.into;
  }
}

/// Makes the last two edges of the strip one.
void BulkCollapse::merge_last_rungs() {
  const Rung last = strip_.back();
  strip_.pop_back();
  HalfedgeHandle& remaining = strip_.back().halfedge;
  EdgeHandle vanishing = mesh_.edge_handle(last.halfedge);
  if (last.meeting.second_survived) {
    vanishing = mesh_.edge_handle(remaining);
    remaining = last.halfedge;
  }
  delete_edge(vanishing);
  if (edge_bits_[vanishing].feature()) edge_bits_[mesh_.edge_handle(remaining)].set_feature(true);
}

// What is left --------------------------------------------------------------------------------------------------------

void BulkCollapse::link_faces() {
  for (int i = 0; i < static_cast<int>(mesh_.n_faces()); ++i) {
    const FaceHandle face(i);
    if (face_bits_[face].deleted()) continue;
    std::array<HalfedgeHandle, 3> sides;
    sides[0] = mesh_.halfedge_handle(face);
    sides[1] = mesh_.next_halfedge_handle(sides[0]);
    sides[2] = mesh_.next_halfedge_handle(sides[1]);
    for (const HalfedgeHandle side : sides) {
      if (!substitute(side).is_valid()) merge_strip(side);
    }
    mesh_.set_halfedge_handle(face, substitute(sides[0]));
    for (std::size_t side = 0; side < 3; ++side) {
      const HalfedgeHandle next = sides[(side + 1) % 3];
      const VertexHandle to = link(sides[side], next);
      mesh_.set_face_handle(substitute(sides[side]), face);
      if (mesh_.is_isolated(to)) mesh_.set_halfedge_handle(to, substitute(next));
    }
  }
}

/// Border halfedges keep their order; vanished ones are left out. The outgoing halfedge of a border vertex is made one
/// of them.
void BulkCollapse::link_border() {
  for (const HalfedgeHandle h : border_) {
    HalfedgeHandle next = mesh_.next_halfedge_handle(h);
    while (!substitute(next).is_valid()) next = mesh_.next_halfedge_handle(next);
    const VertexHandle to = link(h, next);
    mesh_.set_boundary(substitute(h));
    if (!mesh_.is_boundary(mesh_.halfedge_handle(to))) mesh_.set_halfedge_handle(to, substitute(next));
  }
}

/// Links the substitute of h to the substitute of `next`. \return the vertex between
OpenMesh::VertexHandle BulkCollapse::link(HalfedgeHandle h, HalfedgeHandle next) {
  const VertexHandle between = cluster(mesh_.to_vertex_handle(h));
  mesh_.set_vertex_handle(substitute(h), between);
  mesh_.set_next_halfedge_handle(substitute(h), substitute(next));
  if (mesh_.halfedge_handle(between) == next) mesh_.set_halfedge_handle(between, substitute(next));
  return between;
}

}  // namespace whittle
