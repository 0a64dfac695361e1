#include "blocks/block.hh"

#include <algorithm>

namespace whittle {
namespace {

/// Memoryless quadrics do.
bool goes_in_rounds(const StageContext& context) {
  return context.options.effective_cost() == Cost::memoryless && context.role == Role::alone;
}

}  // namespace

Block::Block(const WorkingSurface& surface, const Partition& partition, std::size_t number, StageContext context,
             RoundScratchPool& scratch)
    : own_(partition.vertices.of(number)),
      own_faces_(partition.faces.of(number)),
      keeps_order_(context.role == Role::in_exact_order) {
  gather(surface, partition, number);
  if (!context.locked.empty()) {
    for (const Index v : vertices_) locked_.push_back(context.locked[v]);
  }
  context.locked = locked_;
  if (!context.limits.displacements.empty()) {
    for (const Index v : vertices_) displacements_.push_back(context.limits.displacements[v]);
  }
  context.limits.displacements = displacements_;
  context.frozen = frozen_;
  gather_refusals(surface.refusals);
  if (!context.areas.of.empty()) {
    for (const Index f : own_faces_) areas_.push_back(context.areas.of[f]);
    context.areas = {part_.faces, areas_};
  }
  part_.cost_state = state_here(surface);
  if (!goes_in_rounds(context)) {
    start_contractor(context);
    return;
  }
  rounds_.emplace(part_, context, scratch);
  n_inner_ = rounds_->n_inner_vertices();
  n_frozen_ = rounds_->n_frozen_vertices();
}

void Block::start_contractor(const StageContext& context) {
  contractor_.emplace(part_, context);
  const TriangleComplex& complex = contractor_->complex();
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    if (complex.has_faces(v)) ++(complex.is_frozen(v) ? n_frozen_ : n_inner_);
  }
}

void Block::run(double cost) {
  if (rounds_) return rounds_->run(cost);
  contractor_->set_cost_limit(cost);
  result_ = contractor_->run();
}

/// Vertices keep their order, by which ties between pairs go.
void Block::gather(const WorkingSurface& surface, const Partition& partition, std::size_t number) {
  std::vector<Index> foreign;
  for (const Index f : own_faces_) {
    for (const Index v : surface.faces[f]) {
      if (partition.block_of[v] != number) foreign.push_back(v);
    }
  }
  std::sort(foreign.begin(), foreign.end());
  foreign.erase(std::unique(foreign.begin(), foreign.end()), foreign.end());
  std::vector<Index> own_numbers(own_.size());  // in the block, by rank
  std::vector<Index> foreign_numbers(foreign.size());
  vertices_.resize(own_.size() + foreign.size());
  for (Index n = 0, i = 0, j = 0; n < vertices_.size(); ++n) {
    const bool is_own = j == foreign.size() || (i < own_.size() && own_[i] < foreign[j]);
    vertices_[n] = is_own ? own_[i] : foreign[j];
    (is_own ? own_numbers[i++] : foreign_numbers[j++]) = n;
  }
  std::vector<Vec3>& positions = part_.positions.own();
  positions.reserve(vertices_.size());
  frozen_.reserve(vertices_.size());
  for (const Index v : vertices_) {
    positions.push_back(surface.frame.to_frame(surface.positions[v]));
    frozen_.push_back(partition.is_shared[v]);
  }
  const auto number_here = [&](Index v) {
    if (partition.block_of[v] == number) return own_numbers[partition.ranks[v]];
    const auto at = std::lower_bound(foreign.begin(), foreign.end(), v);
    return foreign_numbers[static_cast<std::size_t>(at - foreign.begin())];
  };
  std::vector<Triangle>& faces = part_.faces.own();
  faces.reserve(own_faces_.size());
  for (const Index f : own_faces_) {
    const auto& [a, b, c] = surface.faces[f];
    faces.push_back({number_here(a), number_here(b), number_here(c)});
  }
}

/// Those of pairs with an end that isn't frozen here.
void Block::gather_refusals(std::span<const GuardedPair> all) {
  const auto number_here = [this](Index v) {
    const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), v);
    return at != vertices_.end() && *at == v ? static_cast<Index>(at - vertices_.begin()) : invalid_index;
  };
  for (const auto& [pair, reason] : all) {
    const Index a = number_here(pair.a);
    const Index b = number_here(pair.b);
    if (a == invalid_index || b == invalid_index || (frozen_[a] & frozen_[b]) != 0) continue;
    part_.refusals.push_back({{a, b}, reason});
  }
}

std::vector<VertexQuadric> Block::quadrics_here(std::span<const VertexQuadric> of_surface) const {
  std::vector<VertexQuadric> here;
  auto next = of_surface.begin();
  for (Index v = 0; v < vertices_.size() && next != of_surface.end(); ++v) {
    next = std::lower_bound(next, of_surface.end(), vertices_[v],
                            [](const VertexQuadric& q, Index vertex) { return q.vertex < vertex; });
    if (next != of_surface.end() && next->vertex == vertices_[v]) here.push_back({v, next->quadric});
  }
  return here;
}

/// The block's share of the faces, and what is known of its vertices. \pre the mean area is known
CostState Block::state_here(const WorkingSurface& surface) const {
  const CostState& of_surface = surface.cost_state;
  const double share = static_cast<double>(own_faces_.size()) / static_cast<double>(surface.faces.size());
  const double n_faces = share * static_cast<double>(of_surface.face_area->n_faces());
  CostState here;
  here.face_area = of_surface.face_area->of_part(static_cast<std::uint64_t>(std::max(1.0, n_faces)));
  here.quadrics = quadrics_here(of_surface.quadrics);
  here.seams = quadrics_here(of_surface.seams);
  here.attributes = attributes_here(surface);
  return here;
}

/// Of vertices that aren't frozen.
SurfaceAttributes Block::attributes_here(const WorkingSurface& surface) const {
  std::vector<Index> places;
  std::vector<Index> vertices;
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (frozen_[v] != 0) continue;
    places.push_back(v);
    vertices.push_back(vertices_[v]);
  }
  SurfaceAttributes here = surface.attributes_at(vertices, 1);
  for (Index& v : here.vertex_of) v = places[v];
  return here;
}

void Block::finish(BlockResults& results) {
  const std::vector<Index> merged_into = rounds_ ? finish_rounds(results) : finish_contractor(results);
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (frozen_[v] == 0) results.merged_into[vertices_[v]] = vertices_[merged_into[v]];
  }
  for (std::vector<VertexQuadric>* const all : {&part_.cost_state.quadrics, &part_.cost_state.seams}) {
    for (VertexQuadric& q : *all) q.vertex = survivors_[q.vertex].vertex;
  }
  for (Index& v : part_.cost_state.attributes.vertex_of) v = survivors_[v].vertex;
  for (auto& [pair, reason] : part_.refusals) pair = {vertices_[pair.a], vertices_[pair.b]};
  part_.faces = {};
}

/// Lists the survivors, and writes down which faces are left. \return what each vertex has become
std::vector<Index> Block::finish_rounds(BlockResults& results) {
  std::vector<Index> merged_into = rounds_->merged_into();
  std::vector<Index> left;
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (frozen_[v] != 0 || merged_into[v] != v) continue;
    survivors_.push_back({vertices_[v], rounds_->position(v)});
    left.push_back(v);
  }
  part_.cost_state = rounds_->state(left);
  for (std::size_t i = 0; i < own_faces_.size(); ++i) {
    results.is_face_left[own_faces_[i]] = has_three_corners(mapped(part_.faces[i], merged_into));
  }
  result_ = rounds_->result();
  rounds_.reset();
  return merged_into;
}

/// As `finish_rounds`.
std::vector<Index> Block::finish_contractor(BlockResults& results) {
  TriangleComplex& complex = contractor_->complex();
  const std::vector<Index> at = complex.vertices_by_origin();
  std::vector<Index> merged_into(at.size());
  for (Index v = 0; v < at.size(); ++v) merged_into[v] = complex.origin(complex.representative(at[v]));
  std::vector<Index> left;
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (frozen_[v] != 0 || merged_into[v] != v) continue;
    survivors_.push_back({vertices_[v], complex.position(at[v])});
    left.push_back(at[v]);
  }
  part_.cost_state = contractor_->cost().state(left);
  if (keeps_order_) part_.refusals = contractor_->refusals();
  std::vector<std::uint8_t> is_left(part_.faces.size());
  for (const Index f : surviving_faces(part_.faces, merged_into, complex)) is_left[f] = 1;
  for (std::size_t i = 0; i < is_left.size(); ++i) results.is_face_left[own_faces_[i]] = is_left[i];
  result_.n_degenerate_faces = complex.n_degenerate_faces();
  result_.n_coincident_faces = complex.n_coincident_faces();
  contractor_.reset();
  return merged_into;
}

}  // namespace whittle
