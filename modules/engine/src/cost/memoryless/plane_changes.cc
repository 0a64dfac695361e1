#include "whittle/engine/formula/plane_changes.hh"

#include <algorithm>

namespace whittle {

void PlaneChanges::move_face(const Vec3& from, const Vec3& to, const Corner& x, const Corner& y) {
  SymmetricMatrix change = corner_quadric(to, x.position, y.position, options_);
  change -= corner_quadric(from, x.position, y.position, options_);
  changes_.push_back({x.vertex, change});
  changes_.push_back({y.vertex, change});
}

void PlaneChanges::remove_face(const Vec3& first, const Vec3& second, const Corner& opposite) {
  SymmetricMatrix change;
  change -= corner_quadric(first, second, opposite.position, options_);
  changes_.push_back({opposite.vertex, change});
}

const std::vector<PlaneChanges::Change>& PlaneChanges::sum() {
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change& x, const Change& y) { return x.vertex < y.vertex; });
  auto end = changes_.begin();  // of the sums
  for (auto next = changes_.begin(); next != changes_.end();) {
    Change sum{next->vertex, {}};
    for (; next != changes_.end() && next->vertex == sum.vertex; ++next) sum.planes += next->planes;
    *end++ = sum;
  }
  changes_.erase(end, changes_.end());
  return changes_;
}

}  // namespace whittle
