#include "rounds/round_mesh.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "loop/contractor.hh"
#include "rounds/chunks.hh"

namespace whittle {

RoundMesh::RoundMesh(std::span<const Vec3> positions, std::span<const Triangle> faces,
                     std::span<const std::uint8_t> frozen, bool with_numbers, RoundScratch& scratch)
    : merged_into_(positions.size()),
      stars_(positions.size()),
      has_numbers_(with_numbers),
      corners_(&scratch.corners[0]),
      next_corners_(&scratch.corners[1]),
      corner_faces_(&scratch.corner_faces[0]),
      next_corner_faces_(&scratch.corner_faces[1]) {
  points_.reserve(positions.size());
  for (const Vec3& p : positions) points_.emplace_back(p);
  std::iota(merged_into_.begin(), merged_into_.end(), Index{0});
  for (const Triangle& face : faces) {
    const Index is_left = has_three_corners(face) ? 1 : 0;
    n_faces_ += is_left;
    for (const Index v : face) stars_[v].n += is_left;
  }
  list_vertices(frozen);
  list_stars(faces);
}

/// \pre `stars_` have the numbers of faces
void RoundMesh::list_vertices(std::span<const std::uint8_t> frozen) {
  vertices_.reserve(stars_.size());
  for (Index v = 0; v < stars_.size(); ++v) {
    const Index n = stars_[v].n;
    if (n == 0) continue;
    if (!frozen.empty() && frozen[v] != 0) {
      ++n_frozen_;
      stars_[v] = {};
      continue;
    }
    vertices_.push_back(v);
    stars_[v].begin = end_;
    end_ += n;
  }
}

void RoundMesh::list_stars(std::span<const Triangle> faces) {
  make_room(*corners_, end_);
  std::vector<std::size_t> places(stars_.size());
  constexpr std::size_t nowhere = ~std::size_t{0};
  for (Index v = 0; v < stars_.size(); ++v) places[v] = stars_[v].n > 0 ? stars_[v].begin : nowhere;
  if (has_numbers_) number_stars(faces, places);
  LinkEdge* const corners = corners_->data();
  const auto list = [&](Index v, const LinkEdge& face) {
    if (places[v] != nowhere) corners[places[v]++] = face;
  };
  for (const auto& [a, b, c] : faces) {
    if (a == b || b == c || c == a) continue;
    list(a, {b, c});
    list(b, {c, a});
    list(c, {a, b});
  }
}

/// \param places where the first face of each vertex stands, or a number beyond the end
void RoundMesh::number_stars(std::span<const Triangle> faces, std::vector<std::size_t> places) {
  make_room(*corner_faces_, end_);
  for (Index f = 0; f < faces.size(); ++f) {
    if (!has_three_corners(faces[f])) continue;
    for (const Index v : faces[f]) {
      if (places[v] < end_) (*corner_faces_)[places[v]++] = f;
    }
  }
}

void RoundMesh::merge(const VertexPair& pair, Index removed, const Vec3& position, std::span<const LinkEdge> star) {
  const Index survivor = removed == pair.a ? pair.b : pair.a;
  make_room(*corners_, end_ + star.size());
  if (has_numbers_) append_numbers(pair);
  std::copy(star.begin(), star.end(), corners_->begin() + static_cast<std::ptrdiff_t>(end_));
  stars_[survivor] = {end_, static_cast<Index>(star.size())};
  stars_[removed] = {};
  end_ += star.size();
  merged_into_[removed] = survivor;
  points_[survivor] = LanePoint(position);
}

/// The numbers of the faces of a pair that stay. \pre it isn't merged yet
void RoundMesh::append_numbers(const VertexPair& pair) {
  make_room(*corner_faces_, corners_->size());
  std::size_t place = end_;
  for (const auto& [v, other] : {std::pair{pair.a, pair.b}, std::pair{pair.b, pair.a}}) {
    for (std::size_t i = 0; i < stars_[v].n; ++i) {
      const Index x = now(star(v)[i].x);
      const Index y = now(star(v)[i].y);
      if (x != y && x != other && y != other) (*corner_faces_)[place++] = faces_in_star(v)[i];
    }
  }
}

void RoundMesh::begin_round(unsigned threads) {
  const std::size_t n_chunks = n_chunks_of(vertices_.size());
  std::vector<std::size_t> begins(n_chunks);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (i % chunk_length == 0) begins[i / chunk_length] = sum;
    sum += stars_[vertices_[i]].n;  // no star grows
  }
  make_room(*next_corners_, sum);
  if (has_numbers_) make_room(*next_corner_faces_, sum);
  std::vector<std::size_t> n_left(n_chunks);
  for_each_chunk(vertices_.size(), threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::size_t to = begins[chunk];
    std::size_t place = begin;
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = vertices_[i];
      if (stars_[v].n == 0) continue;
      move_star(v, to);
      to += stars_[v].n;
      vertices_[place] = v;
      place += stars_[v].n > 0 ? 1 : 0;
    }
    n_left[chunk] = place - begin;
  });
  std::swap(corners_, next_corners_);
  std::swap(corner_faces_, next_corner_faces_);
  end_ = sum;
  auto to = vertices_.begin();
  for (std::size_t chunk = 0; chunk < n_chunks; ++chunk) {
    const auto from = vertices_.begin() + static_cast<std::ptrdiff_t>(chunk * chunk_length);
    to = std::copy(from, from + static_cast<std::ptrdiff_t>(n_left[chunk]), to);
  }
  vertices_.erase(to, vertices_.end());
}

/// Copies what is left of a star to the list of the next round.
void RoundMesh::move_star(Index v, std::size_t to) {
  if (has_numbers_) move_numbers(v, to);
  const auto [begin, n_before] = stars_[v];
  const LinkEdge* const from = corners_->data() + begin;
  LinkEdge* const corners = next_corners_->data() + to;
  const Index* const now = merged_into_.data();
  Index n = 0;
  for (Index i = 0; i < n_before; ++i) {
    const LinkEdge face{now[from[i].x], now[from[i].y]};
    corners[n] = face;
    n += face.x != face.y ? 1 : 0;
  }
  stars_[v] = n > 0 ? Star{to, n} : Star{};
}

void RoundMesh::move_numbers(Index v, std::size_t to) {
  for (std::size_t i = 0; i < stars_[v].n; ++i) {
    const auto [x, y] = star(v)[i];
    if (now(x) != now(y)) (*next_corner_faces_)[to++] = faces_in_star(v)[i];
  }
}

std::vector<Triangle> RoundMesh::faces_now() const {
  std::vector<Triangle> faces;
  for (const Index v : vertices_) {
    if (merged_into_[v] != v) continue;
    for (const LinkEdge& edge : star(v)) {
      const Index x = now(edge.x);
      const Index y = now(edge.y);
      if (v < x && v < y && x != y) faces.push_back({v, x, y});
    }
  }
  return faces;
}

std::vector<Index> RoundMesh::merged_into() const {
  std::vector<Index> result = merged_into_;
  for (Index& v : result) {
    while (merged_into_[v] != v) v = merged_into_[v];
  }
  return result;
}

}  // namespace whittle
