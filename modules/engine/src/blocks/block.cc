#include "blocks/block.hh"

#include <algorithm>

namespace whittle {

Block::Block(const Surface& surface, const Partition& partition, std::size_t number,
             std::span<const std::uint8_t> locked, const Memory& memory, const DecimateOptions& options)
    : own_(partition.vertices.of(number)), own_faces_(partition.faces.of(number)) {
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
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    if (complex.has_faces(v)) ++(complex.is_frozen(v) ? n_frozen_ : n_inner_);
  }
}

/// Its own vertices come first, so that they keep their order.
void Block::gather(const Surface& surface, const Partition& partition, std::size_t number) {
  struct ForeignCorner {
    Index vertex;
    Index place;  ///< three times the face, and the corner
  };
  std::vector<ForeignCorner> corners;
  faces_.reserve(own_faces_.size());
  for (const Index f : own_faces_) {
    const Triangle& face = surface.faces[f];
    Triangle& here = faces_.emplace_back();
    for (Index i = 0; i < 3; ++i) {
      here[i] = partition.ranks[face[i]];
      if (partition.block_of[face[i]] == number) continue;
      corners.push_back({face[i], 3 * static_cast<Index>(faces_.size() - 1) + i});
    }
  }
  std::sort(corners.begin(), corners.end(),
            [](const ForeignCorner& x, const ForeignCorner& y) { return x.vertex < y.vertex; });
  for (const auto& [v, place] : corners) {
    if (foreign_.empty() || foreign_.back() != v) foreign_.push_back(v);
    faces_[place / 3][place % 3] = static_cast<Index>(own_.size() + foreign_.size() - 1);
  }
  const std::size_t n = own_.size() + foreign_.size();
  positions_.reserve(n);
  frozen_.reserve(n);
  for (const Index v : own_) {
    positions_.push_back(surface.frame.to_frame(surface.positions[v]));
    frozen_.push_back(partition.is_shared[v]);
  }
  for (const Index v : foreign_) positions_.push_back(surface.frame.to_frame(surface.positions[v]));
  frozen_.resize(n, 1);
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
