#include "whittle/openmesh/detail/face_relinker.hh"

#include <algorithm>

namespace whittle {

FaceRelinker::FaceRelinker(OpenMesh::TriConnectivity& mesh, const JoinedFaces& joined)
    : mesh_(mesh),
      joined_(joined),
      cut_(cut_into_manifold(joined.vertex_handles.size(), joined.faces)),
      opposite_(opposite_sides(joined.vertex_handles.size() + cut_.originals.size(), cut_.faces)) {}

std::vector<FaceRelinker::Copy> FaceRelinker::run() {
  find_old_sides();
  find_features();
  assign_vertices();
  assign_edges();
  carry_features();
  delete_vertices();
  delete_edges();
  delete_faces();
  link_sides();
  link_border();
  link_vertices();

  std::vector<Copy> copies;
  copies.reserve(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) copies.push_back({original(v), vertices_[v]});
  return copies;
}

// The mesh before
// ------------------------------------------------------------------------------------------------------

void FaceRelinker::find_old_sides() {
  old_sides_.reserve(opposite_.size());
  for (const Index f : joined_.face_handles) {
    const HalfedgeHandle last = mesh_.halfedge_handle(FaceHandle(static_cast<int>(f)));  // leads to the first corner
    const HalfedgeHandle first = mesh_.next_halfedge_handle(last);
    old_sides_.insert(old_sides_.end(), {first, mesh_.next_halfedge_handle(first), last});
  }
}

void FaceRelinker::find_features() {
  const StatusBits<EdgeHandle> bits(mesh_);
  for (int i = 0; i < static_cast<int>(mesh_.n_edges()); ++i) {
    const EdgeHandle e(i);
    if (bits[e].deleted() || !bits[e].feature()) continue;
    const auto end = [&](unsigned side) {
      return joined_.vertex_of[static_cast<std::size_t>(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, side)).idx())];
    };
    features_.push_back(std::minmax(end(0), end(1)));
  }
  std::sort(features_.begin(), features_.end());
}

// Vertices ------------------------------------------------------------------------------------------------------------

void FaceRelinker::assign_vertices() {
  vertices_.reserve(joined_.vertex_handles.size() + cut_.originals.size());
  for (const Index v : joined_.vertex_handles) vertices_.emplace_back(static_cast<int>(v));
  if (!cut_.originals.empty()) {
    const std::vector<VertexHandle> own = vertices_;
    for (const Index v : cut_.originals) vertices_[v].invalidate();
    vertices_.resize(vertices_.size() + cut_.originals.size());

    std::vector<bool> is_taken(mesh_.n_vertices());
    keep_handles([&](VertexHandle h, Index v) { return h == own[v]; }, is_taken);
    for (Index v = 0; v < own.size(); ++v) {  // no remaining face had the handle
      if (!vertices_[v].is_valid() && !is_taken[static_cast<std::size_t>(own[v].idx())]) vertices_[v] = own[v];
    }
    const auto is_copy = [&](VertexHandle h, Index v) {
      return joined_.first_copies[static_cast<std::size_t>(h.idx())] == joined_.vertex_handles[v];
    };
    if (!joined_.first_copies.empty()) keep_handles(is_copy, is_taken);
    add_copies();
  }
  mark_copies();
}

/// Gives vertices of the cut that have no handle yet the handle that a corner of their faces had, if it is free and
/// `accepts(handle, original)`.
template <class Accepts>
void FaceRelinker::keep_handles(const Accepts& accepts, std::vector<bool>& is_taken) {
  for (Side corner = 0; corner < old_sides_.size(); ++corner) {
    VertexHandle& handle = vertices_[start(corner)];
    if (handle.is_valid()) continue;
    const VertexHandle old = mesh_.from_vertex_handle(old_sides_[corner]);
    const auto place = static_cast<std::size_t>(old.idx());
    if (is_taken[place] || !accepts(old, original(start(corner)))) continue;
    handle = old;
    is_taken[place] = true;
  }
}

void FaceRelinker::add_copies() {
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (vertices_[v].is_valid()) continue;
    vertices_[v] = mesh_.new_vertex();
    const VertexHandle first(static_cast<int>(joined_.vertex_handles[original(v)]));
    mesh_.copy_all_properties(first, vertices_[v], true);
  }
}

/// Writes which vertices belong together, as numbers from 1 on.
void FaceRelinker::mark_copies() {
  if (cut_.originals.empty() && !find_copies_property(mesh_).is_valid()) return;
  auto& numbers = mesh_.property(require_copies_property(mesh_)).data_vector();
  std::fill(numbers.begin(), numbers.end(), 0);
  const auto number = [&](Index v) -> int& { return numbers[static_cast<std::size_t>(vertices_[v].idx())]; };
  int n_cut = 0;
  for (auto v = static_cast<Index>(joined_.vertex_handles.size()); v < vertices_.size(); ++v) {
    if (number(original(v)) == 0) number(original(v)) = ++n_cut;
    number(v) = number(original(v));
  }
}

// Edges ---------------------------------------------------------------------------------------------------------------

void FaceRelinker::assign_edges() {
  is_edge_taken_.resize(mesh_.n_edges());
  sides_.resize(opposite_.size());
  for (Side side = 0; side < opposite_.size(); ++side) {
    if (sides_[side].is_valid()) continue;
    Side first = side;
    Side second = has_opposite(side) ? opposite_[side] : side;
    if (old_edge(second) < old_edge(first)) std::swap(first, second);
    if (!take_edge(first) && !take_edge(second)) add_edge(first);
  }
}

/// Gives the side its old edge, if that is free. \return whether it was
bool FaceRelinker::take_edge(Side side) {
  if (is_taken(old_edge(side))) return false;
  is_edge_taken_[static_cast<std::size_t>(old_edge(side).idx())] = true;
  set_edge(side, old_sides_[side]);
  return true;
}

void FaceRelinker::add_edge(Side side) {
  const HalfedgeHandle old = old_sides_[side];
  const HalfedgeHandle h = mesh_.new_edge(start_handle(side), start_handle(next(side)));
  is_edge_taken_.push_back(true);
  mesh_.copy_all_properties(mesh_.edge_handle(old), mesh_.edge_handle(h), true);
  mesh_.copy_all_properties(old, h, true);
  const HalfedgeHandle old_opposite =
      has_opposite(side) ? old_sides_[opposite_[side]] : mesh_.opposite_halfedge_handle(old);
  mesh_.copy_all_properties(old_opposite, mesh_.opposite_halfedge_handle(h), true);
  set_edge(side, h);
}

void FaceRelinker::set_edge(Side side, HalfedgeHandle halfedge) {
  sides_[side] = halfedge;
  if (has_opposite(side)) sides_[opposite_[side]] = mesh_.opposite_halfedge_handle(halfedge);
}

void FaceRelinker::carry_features() {
  if (features_.empty()) return;
  const StatusBits<EdgeHandle> bits(mesh_);
  for (Side side = 0; side < sides_.size(); ++side) {
    const Ends ends = std::minmax(original(start(side)), original(start(next(side))));
    if (!std::binary_search(features_.begin(), features_.end(), ends)) continue;
    bits[mesh_.edge_handle(sides_[side])].set_feature(true);
  }
}

// What vanishes -------------------------------------------------------------------------------------------------------

/// Deletes vertices that had faces and are not left. Isolated vertices stay.
void FaceRelinker::delete_vertices() {
  std::vector<bool> is_left(mesh_.n_vertices());
  for (const VertexHandle v : vertices_) is_left[static_cast<std::size_t>(v.idx())] = true;
  const StatusBits<VertexHandle> bits(mesh_);
  for (int i = 0; i < static_cast<int>(is_left.size()); ++i) {
    const VertexHandle v(i);
    if (is_left[static_cast<std::size_t>(i)] || mesh_.is_isolated(v)) continue;
    bits[v].set_deleted(true);
    mesh_.set_isolated(v);
  }
}

void FaceRelinker::delete_edges() {
  const StatusBits<EdgeHandle> bits(mesh_);
  const StatusBits<HalfedgeHandle> halfedge_bits(mesh_);
  for (int i = 0; i < static_cast<int>(mesh_.n_edges()); ++i) {
    const EdgeHandle e(i);
    if (is_taken(e)) continue;
    bits[e].set_deleted(true);
    if (!halfedge_bits) continue;
    for (const unsigned side : {0U, 1U}) halfedge_bits[mesh_.halfedge_handle(e, side)].set_deleted(true);
  }
}

void FaceRelinker::delete_faces() {
  const StatusBits<FaceHandle> bits(mesh_);
  auto left = joined_.face_handles.begin();
  for (Index i = 0; i < mesh_.n_faces(); ++i) {
    if (left != joined_.face_handles.end() && *left == i) {
      ++left;
    } else {
      const FaceHandle face(static_cast<int>(i));
      bits[face].set_deleted(true);
      mesh_.set_halfedge_handle(face, HalfedgeHandle());
    }
  }
}

// What is left --------------------------------------------------------------------------------------------------------

void FaceRelinker::link_sides() {
  outgoing_.resize(vertices_.size());
  for (Side side = 0; side < sides_.size(); ++side) {
    const HalfedgeHandle h = sides_[side];
    const FaceHandle face(static_cast<int>(joined_.face_handles[side / 3]));
    mesh_.set_vertex_handle(h, start_handle(next(side)));
    mesh_.set_next_halfedge_handle(h, sides_[next(side)]);
    mesh_.set_face_handle(h, face);
    if (side % 3 == 2) mesh_.set_halfedge_handle(face, h);
    outgoing_[start(side)] = h;
  }
}

/// Every vertex is on one border at most. Its outgoing halfedge is then a border halfedge.
void FaceRelinker::link_border() {
  const auto is_border = [this](Side side) { return !has_opposite(side); };
  const auto beyond = [this](Side side) { return mesh_.opposite_halfedge_handle(sides_[side]); };
  for (Side side = 0; side < sides_.size(); ++side) {
    if (is_border(side)) outgoing_[start(next(side))] = beyond(side);
  }
  for (Side side = 0; side < sides_.size(); ++side) {
    if (!is_border(side)) continue;
    mesh_.set_vertex_handle(beyond(side), start_handle(side));
    mesh_.set_next_halfedge_handle(beyond(side), outgoing_[start(side)]);
    mesh_.set_boundary(beyond(side));
  }
}

/// Inner vertices keep their outgoing halfedge if it still starts at them.
void FaceRelinker::link_vertices() {
  for (Index v = 0; v < vertices_.size(); ++v) {
    const VertexHandle vertex = vertices_[v];
    const HalfedgeHandle h = mesh_.halfedge_handle(vertex);
    const bool is_theirs = h.is_valid() && is_taken(mesh_.edge_handle(h)) && mesh_.from_vertex_handle(h) == vertex;
    const bool is_inner = outgoing_[v].is_valid() && !mesh_.is_boundary(outgoing_[v]);
    if (!is_inner || !is_theirs) mesh_.set_halfedge_handle(vertex, outgoing_[v]);
  }
}

}  // namespace whittle
