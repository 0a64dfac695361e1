#include "blocks/block.hh"

#include <algorithm>
#include <iterator>

namespace whittle {

Block::Block(const Surface& surface, const Partition& partition, std::size_t number,
             std::span<const std::uint8_t> locked, const Memory& memory, const DecimateOptions& options)
    : own_(partition.vertices_of(number)), own_faces_(partition.faces_of(number)) {
  gather(surface, partition, number);
  if (!locked.empty()) {
    for (Index v = 0; v < positions_.size(); ++v) locked_.push_back(locked[number_of(v)]);
  }
  const Memory own_memory = memory_of_block(surface, memory);
  PassInput input;
  input.surface = {positions_, Frame{}, faces_};
  input.locked = locked_;
  input.frozen = frozen_;
  input.memory = &own_memory;
  pass_.emplace(input, options);
  positions_ = {};
  const TriangleComplex& complex = pass_->complex();
  for (Index v = 0; v < complex.n_vertex_slots(); ++v)
    n_inner_ += complex.has_faces(v) && !complex.is_frozen(v) ? 1 : 0;
}

/// Its own vertices come first, so that they keep their order.
void Block::gather(const Surface& surface, const Partition& partition, std::size_t number) {
  const auto is_own = [&](Index v) { return partition.block_of[v] == number; };
  for (const Index f : own_faces_) {
    const Triangle& face = surface.faces[f];
    std::copy_if(face.begin(), face.end(), std::back_inserter(foreign_), [&](Index v) { return !is_own(v); });
  }
  std::sort(foreign_.begin(), foreign_.end());
  foreign_.erase(std::unique(foreign_.begin(), foreign_.end()), foreign_.end());
  const auto number_here = [&](Index v) {
    if (is_own(v)) return partition.ranks[v];
    const auto place = std::lower_bound(foreign_.begin(), foreign_.end(), v);
    return static_cast<Index>(own_.size() + static_cast<std::size_t>(place - foreign_.begin()));
  };
  faces_.reserve(own_faces_.size());
  for (const Index f : own_faces_) {
    const auto& [a, b, c] = surface.faces[f];
    faces_.push_back({number_here(a), number_here(b), number_here(c)});
  }
  const std::size_t n = own_.size() + foreign_.size();
  positions_.reserve(n);
  frozen_.reserve(n);
  for (Index v = 0; v < n; ++v) {
    positions_.push_back(surface.frame.to_frame(surface.positions[number_of(v)]));
    frozen_.push_back(v < own_.size() ? partition.is_shared[own_[v]] : 1);
  }
}

/// The block's share of the faces, and what its own vertices remember.
Memory Block::memory_of_block(const Surface& surface, const Memory& memory) const {
  const double share = static_cast<double>(own_faces_.size()) / static_cast<double>(surface.faces.size());
  const double n_faces = share * static_cast<double>(memory.face_area.n_faces());
  Memory own{memory.face_area.of_part(static_cast<std::uint64_t>(std::max(1.0, n_faces))), {}};
  auto remembered = memory.quadrics.begin();
  for (Index v = 0; v < own_.size() && remembered != memory.quadrics.end(); ++v) {
    remembered = std::lower_bound(remembered, memory.quadrics.end(), own_[v],
                                  [](const Memory::Remembered& r, Index vertex) { return r.vertex < vertex; });
    if (remembered != memory.quadrics.end() && remembered->vertex == own_[v]) {
      own.quadrics.push_back({v, remembered->quadric});
    }
  }
  return own;
}

void Block::finish(BlockResults& results) {
  TriangleComplex& complex = pass_->complex();
  std::vector<Index> at(complex.n_vertex_slots());  // vertices of the complex, by vertex of the block
  for (Index v = 0; v < at.size(); ++v) at[complex.origin(v)] = v;
  std::vector<Index> merged_into(at.size());
  for (Index v = 0; v < at.size(); ++v) merged_into[v] = complex.origin(complex.representative(at[v]));
  for (Index v = 0; v < own_.size(); ++v) {
    results.merged_into[own_[v]] = own_[merged_into[v]];
    if (merged_into[v] != v || frozen_[v] != 0) continue;
    survivors_.push_back({own_[v], complex.position(at[v])});
    if (pass_->cost().remembers(at[v])) {
      remembered_.push_back({own_[v], pass_->cost().quadric(at[v]).quadric});
    }
  }
  std::vector<std::uint8_t> is_left(faces_.size());
  for (const Index f : surviving_faces(faces_, merged_into, complex)) is_left[f] = 1;
  for (std::size_t i = 0; i < faces_.size(); ++i) results.is_face_left[own_faces_[i]] = is_left[i];
  result_.n_degenerate_faces = complex.n_degenerate_faces();
  result_.n_coincident_faces = complex.n_coincident_faces();
  pass_.reset();
  faces_ = {};
}

}  // namespace whittle
