#include "guard/areas/area_guard.hh"

#include <algorithm>

namespace whittle {

AreaGuard::AreaGuard(TriangleComplex& complex, const AreasOfFaces& areas)
    : complex_(complex),
      faces_(areas.faces),
      slots_(complex.vertices_by_origin()),
      may_give_up_(areas.may_be_given_up) {
  for (Index f = 0; f < faces_.size(); ++f) {
    if (areas.of[f] != invalid_index && has_three_corners(faces_[f])) members_.push_back(f);
  }
  std::stable_sort(members_.begin(), members_.end(), [&](Index f, Index g) { return areas.of[f] < areas.of[g]; });
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i > 0 && areas.of[members_[i]] == areas.of[members_[i - 1]]) continue;
    if (i > 0) ends_.push_back(i);
    first_.push_back(i);
  }
  if (!first_.empty()) ends_.push_back(members_.size());
  for (Index area = 0; area < first_.size(); ++area) watch(area);
}

Triangle AreaGuard::corners(Index face) {
  const auto& [a, b, c] = faces_[face];
  return {complex_.representative(slots_[a]), complex_.representative(slots_[b]), complex_.representative(slots_[c])};
}

/// Lists the area at the corners of its first face that is left.
void AreaGuard::watch(Index area) {
  std::size_t& first = first_[area];
  while (first < ends_[area] && !has_three_corners(corners(members_[first]))) ++first;
  if (first == ends_[area]) return;
  for (const Index v : corners(members_[first])) {
    std::vector<Index>& areas = watched_[v];
    if (std::find(areas.begin(), areas.end(), area) == areas.end()) areas.push_back(area);
  }
}

/// Whether all faces of an area that are left have both vertices of the pair.
bool AreaGuard::ends_with(Index area, const Pair& pair) {
  for (std::size_t i = first_[area]; i < ends_[area]; ++i) {
    const Triangle face = corners(members_[i]);
    const auto has = [&face](Index v) { return std::find(face.begin(), face.end(), v) != face.end(); };
    if (has_three_corners(face) && !(has(pair.a) && has(pair.b))) return false;
  }
  return first_[area] != ends_[area];
}

bool AreaGuard::refuses(ContractionProfile& profile) {
  if (is_given_up_) return false;
  const Pair& pair = profile.pair;
  const auto at_a = watched_.find(pair.a);
  const auto at_b = watched_.find(pair.b);
  if (at_a == watched_.end() || at_b == watched_.end()) return false;
  return std::any_of(at_a->second.begin(), at_a->second.end(), [&](Index area) {
    const std::vector<Index>& others = at_b->second;
    return std::find(others.begin(), others.end(), area) != others.end() && ends_with(area, pair);
  });
}

void AreaGuard::note(const Change& change) {
  const auto removed = watched_.find(change.removed);
  if (removed == watched_.end()) return;
  const std::vector<Index> areas = std::move(removed->second);
  watched_.erase(removed);
  std::vector<Index>& at_survivor = watched_[change.survivor];
  std::vector<Index> without_witness;
  for (const Index area : areas) {
    if (std::find(at_survivor.begin(), at_survivor.end(), area) == at_survivor.end()) {
      at_survivor.push_back(area);
    } else {
      without_witness.push_back(area);
    }
  }
  for (const Index area : without_witness) watch(area);
}

}  // namespace whittle
