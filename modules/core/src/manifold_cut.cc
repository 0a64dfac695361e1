#include "whittle/core/manifold_cut.hh"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace whittle {
namespace {

/// Sides and corners of faces go by the same numbers: a side by the corner that it starts at.
Index next_in_face(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
Index previous_in_face(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

/// A side as its lower vertex sees it.
struct Side {
  Index higher;     ///< its other vertex
  bool leads_down;  ///< from there to the lower one
  Index number;
};

/// All sides, those of each lower vertex together.
class SidesByVertex {
 public:
  SidesByVertex(std::size_t n_vertices, std::span<const Triangle> faces) : starts_(n_vertices + 1) {
    for_each_side(faces, [this](Index lower, const Side&) { ++starts_[lower]; });
    Index n = 0;
    for (Index& start : starts_) start = n += start;  // of the next vertex, for now
    sides_.resize(n);
    for_each_side(faces, [this](Index lower, const Side& side) { sides_[--starts_[lower]] = side; });
  }

  std::size_t n_vertices() const { return starts_.size() - 1; }
  std::span<Side> of(std::size_t v) { return std::span(sides_).subspan(starts_[v], starts_[v + 1] - starts_[v]); }

 private:
  template <class Use>
  static void for_each_side(std::span<const Triangle> faces, const Use& use) {
    Index number = 0;
    for (const Triangle& face : faces) {
      const bool counts = has_three_corners(face);
      for (std::size_t i = 0; i < 3; ++i, ++number) {
        const Index from = face[i];
        const Index to = face[(i + 1) % 3];
        if (counts) use(std::min(from, to), Side{std::max(from, to), from > to, number});
      }
    }
  }

  std::vector<Index> starts_;
  std::vector<Side> sides_;
};

/// Two that follow each other are opposite where no third one runs between the same vertices.
void pair_up(std::span<Side> sides, std::vector<Index>& opposite) {
  const auto key = [](const Side& side) { return std::tuple(side.higher, side.number); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return key(a) < key(b); });
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t end = first + 1;
    while (end < sides.size() && sides[end].higher == sides[first].higher) ++end;
    if (end == first + 2 && sides[first].leads_down != sides[first + 1].leads_down) {
      opposite[sides[first].number] = sides[first + 1].number;
      opposite[sides[first + 1].number] = sides[first].number;
    }
    first = end;
  }
}

/// Calls `use(corner)` for every corner of the fan that `start` is in.
template <class Use>
void walk_fan(Index start, const std::vector<Index>& opposite, const Use& use) {
  Index corner = start;
  do {
    use(corner);
    const Index across = opposite[corner];
    if (across == invalid_index) break;
    corner = next_in_face(across);
  } while (corner != start);
  if (opposite[corner] != invalid_index) return;  // closed
  corner = opposite[previous_in_face(start)];
  while (corner != invalid_index) {
    use(corner);
    corner = opposite[previous_in_face(corner)];
  }
}

}  // namespace

std::vector<Index> opposite_sides(std::size_t n_vertices, std::span<const Triangle> faces) {
  if (faces.size() >= invalid_index / 3) throw std::length_error("opposite_sides: more than 2^32 / 3 faces");
  std::vector<Index> opposite(3 * faces.size(), invalid_index);
  SidesByVertex sides(n_vertices, faces);
  for (std::size_t v = 0; v < n_vertices; ++v) pair_up(sides.of(v), opposite);
  return opposite;
}

ManifoldCut cut_into_manifold(std::size_t n_vertices, std::span<const Triangle> faces) {
  const std::vector<Index> opposite = opposite_sides(n_vertices, faces);
  ManifoldCut cut{{faces.begin(), faces.end()}, {}};
  std::vector<bool> is_taken(n_vertices);
  std::vector<bool> is_done(opposite.size());
  const auto new_number = [&](Index original) {
    if (!is_taken[original]) {
      is_taken[original] = true;
      return original;
    }
    const std::size_t number = n_vertices + cut.originals.size();
    if (number >= invalid_index) throw std::length_error("cut_into_manifold: too many vertices");
    cut.originals.push_back(original);
    return static_cast<Index>(number);
  };
  for (Index corner = 0; corner < opposite.size(); ++corner) {
    const Triangle& face = faces[corner / 3];
    if (is_done[corner] || !has_three_corners(face)) continue;
    const Index number = new_number(face[corner % 3]);
    walk_fan(corner, opposite, [&](Index reached) {
      is_done[reached] = true;
      cut.faces[reached / 3][reached % 3] = number;
    });
  }
  return cut;
}

}  // namespace whittle
