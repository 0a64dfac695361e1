#include "rounds/round_mesh.hh"

#include <numeric>

#include "loop/contractor.hh"

namespace whittle {

RoundMesh::RoundMesh(std::span<const Vec3> positions, std::span<const Triangle> faces, RoundScratch& scratch)
    : faces_(faces.begin(), faces.end()),
      face_origins_(faces.size()),
      merged_into_(positions.size()),
      corners_(scratch.corners) {
  points_.reserve(positions.size());
  for (const Vec3& p : positions) points_.emplace_back(p);
  std::iota(face_origins_.begin(), face_origins_.end(), Index{0});
  std::iota(merged_into_.begin(), merged_into_.end(), Index{0});
}

void RoundMesh::begin_round(bool with_numbers) {
  offsets_.assign(points_.size() + 2, 0);
  const Index* const now = merged_into_.data();
  Index* const degrees = offsets_.data() + 2;
  Triangle* next = faces_.data();
  Index* next_origin = face_origins_.data();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Triangle face{now[faces_[f][0]], now[faces_[f][1]], now[faces_[f][2]]};
    *next = face;
    *next_origin = face_origins_[f];
    const Index is_left = has_three_corners(face) ? 1 : 0;
    next += is_left;
    next_origin += is_left;
    for (const Index v : face) degrees[v] += is_left;
  }
  faces_.resize(static_cast<std::size_t>(next - faces_.data()));
  face_origins_.resize(faces_.size());
  list_stars(with_numbers);
}

/// \pre `offsets_` has the number of faces of each vertex, two places on
void RoundMesh::list_stars(bool with_numbers) {
  Index sum = 0;
  for (Index& offset : offsets_) offset = sum += offset;
  make_room(corners_, 3 * faces_.size());
  if (with_numbers) {
    corner_faces_.resize(3 * faces_.size());
    std::vector<Index> places(offsets_.begin() + 1, offsets_.end());
    for (Index f = 0; f < faces_.size(); ++f) {
      for (const Index v : faces_[f]) corner_faces_[places[v]++] = f;
    }
  }
  LinkEdge* const corners = corners_.data();
  Index* const places = offsets_.data() + 1;
  for (const auto& [a, b, c] : faces_) {
    corners[places[a]++] = {b, c};
    corners[places[b]++] = {c, a};
    corners[places[c]++] = {a, b};
  }
}

std::vector<Index> RoundMesh::merged_into() const {
  std::vector<Index> result = merged_into_;
  for (Index& v : result) {
    while (merged_into_[v] != v) v = merged_into_[v];
  }
  return result;
}

}  // namespace whittle
