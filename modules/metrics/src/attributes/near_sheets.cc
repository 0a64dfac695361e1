#include "attributes/near_sheets.hh"

#include <algorithm>
#include <tuple>

namespace whittle::metrics {

void NearSheets::find(const TriangleTree& tree, const Vec3& point, double most_sq) {
  const auto is_nearer = [](const ClosestPoint& a, const ClosestPoint& b) {
    return std::tie(a.distance_sq, a.face) < std::tie(b.distance_sq, b.face);
  };
  near_.clear();
  tree.visit_near(point, most_sq, [&](const ClosestPoint& closest) {
    near_.push_back(closest);
    std::push_heap(near_.begin(), near_.end(), is_nearer);
    if (near_.size() > most_faces) {
      std::pop_heap(near_.begin(), near_.end(), is_nearer);
      near_.pop_back();
    }
    return near_.size() < most_faces ? most_sq : near_.front().distance_sq;
  });
  std::sort_heap(near_.begin(), near_.end(), is_nearer);
}

std::size_t NearSheets::root(std::size_t i) {
  while (sheets_[i] != i) i = sheets_[i] = sheets_[sheets_[i]];
  return i;
}

void NearSheets::join(const SurfaceAttribute& attribute) {
  sheets_.resize(near_.size());
  corners_.clear();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    sheets_[i] = i;
    for (std::size_t k = 0; k < 3; ++k) corners_.emplace_back(attribute.continuity(near_[i].face, k), i);
  }
  std::sort(corners_.begin(), corners_.end());
  for (std::size_t c = 1; c < corners_.size(); ++c) {
    if (corners_[c].first != corners_[c - 1].first) continue;
    const auto [nearer, farther] = std::minmax({root(corners_[c - 1].second), root(corners_[c].second)});
    sheets_[farther] = nearer;
  }
}

}  // namespace whittle::metrics
