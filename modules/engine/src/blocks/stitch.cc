#include "blocks/stitch.hh"

#include <algorithm>
#include <atomic>
#include <utility>

#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

/// Numbers the elements for which `is_chosen(i)`, in their order; the others get `invalid_index`.
template <class IsChosen>
std::vector<Index> number_chosen(std::size_t n, unsigned threads, std::size_t& n_chosen, const IsChosen& is_chosen) {
  std::vector<Index> numbers(n);
  std::vector<Index> firsts((n + range_length - 1) / range_length);  // numbers, by range
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    Index& count = firsts[begin / range_length];
    for (std::size_t i = begin; i < end; ++i) count += is_chosen(i) ? 1 : 0;
  });
  Index sum = 0;
  for (Index& first : firsts) sum += std::exchange(first, sum);
  n_chosen = sum;
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    Index next = firsts[begin / range_length];
    for (std::size_t i = begin; i < end; ++i) numbers[i] = is_chosen(i) ? next++ : invalid_index;
  });
  return numbers;
}

class Stitching {
 public:
  Stitching(const WorkingSurface& surface, const Partition& partition, std::span<const Block* const> blocks,
            const BlockResults& results, unsigned threads);

  void write_vertices(WorkingSurface& left) const;
  void write_faces(WorkingSurface& left) const;
  void write_vertex_map(WorkingSurface& left) const;
  void write_quadrics(std::vector<VertexQuadric> CostState::*list, WorkingSurface& left) const;
  void write_attributes(WorkingSurface& left) const;
  void write_refusals(WorkingSurface& left) const;

 private:
  std::vector<std::uint8_t> find_vertices_left() const;
  SurfaceAttributes attributes_of_shared() const;

  const WorkingSurface& surface_;
  const Partition& partition_;
  std::span<const Block* const> blocks_;
  const BlockResults& results_;
  unsigned threads_;
  std::size_t n_vertices_ = 0;
  std::size_t n_faces_ = 0;
  std::vector<Index> vertex_number_;  ///< in what is left, of what is left
  std::vector<Index> face_number_;
};

Stitching::Stitching(const WorkingSurface& surface, const Partition& partition, std::span<const Block* const> blocks,
                     const BlockResults& results, unsigned threads)
    : surface_(surface), partition_(partition), blocks_(blocks), results_(results), threads_(threads) {
  const std::vector<std::uint8_t> is_left = find_vertices_left();
  vertex_number_ = number_chosen(is_left.size(), threads, n_vertices_, [&](std::size_t v) { return is_left[v] != 0; });
  const std::vector<std::uint8_t>& is_face_left = results.is_face_left;
  face_number_ =
      number_chosen(is_face_left.size(), threads, n_faces_, [&](std::size_t f) { return is_face_left[f] != 0; });
}

/// A vertex is left if a face is that has it.
std::vector<std::uint8_t> Stitching::find_vertices_left() const {
  std::vector<std::uint8_t> is_left(surface_.positions.size());
  for_each_range(surface_.faces.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (results_.is_face_left[f] == 0) continue;
      for (const Index v : surface_.faces[f]) {
        std::atomic_ref(is_left[results_.merged_into[v]]).store(1, std::memory_order_relaxed);
      }
    }
  });
  return is_left;
}

void Stitching::write_vertices(WorkingSurface& left) const {
  std::vector<Vec3>& positions = left.positions.own();
  positions.resize(n_vertices_);
  left.origins.resize(n_vertices_);
  for_each_range(vertex_number_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      if (vertex_number_[v] == invalid_index) continue;
      positions[vertex_number_[v]] = surface_.frame.to_frame(surface_.positions[v]);
      left.origins[vertex_number_[v]] = surface_.origin_of(v);
    }
  });
  for_each_block(blocks_.size(), threads_, [&](std::size_t b) {
    for (const auto& [v, position] : blocks_[b]->survivors()) {
      if (vertex_number_[v] != invalid_index) positions[vertex_number_[v]] = position;
    }
  });
}

void Stitching::write_faces(WorkingSurface& left) const {
  std::vector<Triangle>& faces = left.faces.own();
  faces.resize(n_faces_);
  left.face_origins.resize(n_faces_);
  for_each_range(face_number_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Index>(begin); f < end; ++f) {
      if (face_number_[f] == invalid_index) continue;
      const Triangle face = mapped(surface_.faces[f], results_.merged_into);
      faces[face_number_[f]] = mapped(face, vertex_number_);
      left.face_origins[face_number_[f]] = surface_.face_origin_of(f);
    }
  });
}

void Stitching::write_vertex_map(WorkingSurface& left) const {
  const std::size_t n = surface_.is_input() ? surface_.positions.size() : surface_.vertex_map.size();
  left.vertex_map.resize(n);
  for_each_range(n, threads_, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Index here = surface_.is_input() ? v : surface_.vertex_map[v];
      left.vertex_map[v] = here == invalid_index ? invalid_index : vertex_number_[results_.merged_into[here]];
    }
  });
}

/// Vertices that were frozen here have those from before.
void Stitching::write_quadrics(std::vector<VertexQuadric> CostState::*list, WorkingSurface& left) const {
  std::vector<const Quadric*> quadrics(n_vertices_);  // by vertex left, or null
  const auto keep = [&](const VertexQuadric& q) {
    if (vertex_number_[q.vertex] != invalid_index) quadrics[vertex_number_[q.vertex]] = &q.quadric;
  };
  for (const VertexQuadric& q : surface_.cost_state.*list) {
    if (partition_.is_shared[q.vertex] != 0) keep(q);
  }
  for_each_block(blocks_.size(), threads_, [&](std::size_t b) {
    for (const VertexQuadric& q : blocks_[b]->cost_state().*list) keep(q);
  });
  std::size_t n = 0;
  const std::vector<Index> places =
      number_chosen(n_vertices_, threads_, n, [&](std::size_t v) { return quadrics[v] != nullptr; });
  std::vector<VertexQuadric>& after = left.cost_state.*list;
  after.resize(n);
  for_each_range(n_vertices_, threads_, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      if (quadrics[v] != nullptr) after[places[v]] = {v, *quadrics[v]};
    }
  });
}

/// Those that vertices frozen here had before.
SurfaceAttributes Stitching::attributes_of_shared() const {
  std::vector<Index> shared;
  for (Index v = 0; v < partition_.is_shared.size(); ++v) {
    if (partition_.is_shared[v] != 0) shared.push_back(v);
  }
  SurfaceAttributes attributes = surface_.attributes_at(shared, threads_);
  for (Index& v : attributes.vertex_of) v = shared[v];
  return attributes;
}

void Stitching::write_attributes(WorkingSurface& left) const {
  const SurfaceAttributes of_shared = attributes_of_shared();
  std::vector<const SurfaceAttributes*> tables{&of_shared};
  for (const Block* block : blocks_) tables.push_back(&block->cost_state().attributes);
  const auto known = std::find_if(tables.begin(), tables.end(), [](const auto* table) { return table->wedges.any(); });
  if (known == tables.end()) return;
  struct Source {
    const SurfaceAttributes* table = nullptr;
    Index first = 0, n = 0;
  };
  std::vector<Source> sources(n_vertices_);  // by vertex left
  const auto note = [&](const SurfaceAttributes& table, Index w) {
    const Index v = vertex_number_[table.vertex_of[w]];
    if (v == invalid_index) return;
    if (sources[v].n == 0) sources[v] = {&table, w};
    ++sources[v].n;
  };
  for_each_block(tables.size(), threads_, [&](std::size_t i) {
    for (Index w = 0; w < tables[i]->vertex_of.size(); ++w) note(*tables[i], w);
  });
  std::vector<Index> firsts(n_vertices_);
  Index sum = 0;
  for (Index v = 0; v < n_vertices_; ++v) firsts[v] = std::exchange(sum, sum + sources[v].n);
  SurfaceAttributes& after = left.cost_state.attributes;
  after = {(*known)->wedges.of_same_kind(sum), std::vector<Index>(sum), (*known)->farthest};
  for_each_range(n_vertices_, threads_, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const auto& [table, first, n] = sources[v];
      for (Index i = 0; i < n; ++i) {
        after.wedges.copy(firsts[v] + i, table->wedges, first + i);
        after.vertex_of[firsts[v] + i] = v;
      }
    }
  });
}

/// No block knows pairs of two frozen vertices.
void Stitching::write_refusals(WorkingSurface& left) const {
  const auto carry = [&](const GuardedPair& r) {
    left.refusals.push_back({{vertex_number_[r.pair.a], vertex_number_[r.pair.b]}, r.reason});
  };
  for (const GuardedPair& r : surface_.refusals) {
    if ((partition_.is_shared[r.pair.a] & partition_.is_shared[r.pair.b]) != 0) carry(r);
  }
  for (const Block* block : blocks_) {
    for (const GuardedPair& r : block->refusals()) carry(r);
  }
}

}  // namespace

WorkingSurface stitch(const WorkingSurface& surface, const Partition& partition, std::span<const Block* const> blocks,
                      const BlockResults& results, unsigned threads) {
  const Stitching stitching(surface, partition, blocks, results, threads);
  WorkingSurface left;
  left.cost_state.face_area = surface.cost_state.face_area;
  stitching.write_vertices(left);
  stitching.write_faces(left);
  stitching.write_vertex_map(left);
  stitching.write_quadrics(&CostState::quadrics, left);
  stitching.write_quadrics(&CostState::seams, left);
  stitching.write_attributes(left);
  stitching.write_refusals(left);
  return left;
}

}  // namespace whittle
