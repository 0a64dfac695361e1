// What a contraction has the loop look at anew.
#include <algorithm>

#include "loop/contraction_loop.hh"

namespace whittle {

/// Makes the lists of the vertices around the merged one compact, as far as the cost looks.
void ContractionLoop::list_touched() {
  std::vector<Index>& touched = change_.touched;
  touched.clear();
  if (touched_ == Reach::none) return;
  const auto add = [&](Index v) {
    v = complex_.representative(v);
    if (std::find(touched.begin(), touched.end(), v) == touched.end()) touched.push_back(v);
  };
  const auto add_neighbours = [&](Index v) {
    for (const Neighbour& neighbour : complex_.neighbours(v)) add(neighbour.vertex);
  };
  add(change_.survivor);
  if (touched_ >= Reach::ring) {
    add_neighbours(change_.survivor);
    for (const ContractionProfile::Common& opposite : profile_.opposites) add(opposite.vertex);
    for (const ContractionProfile::Common& neighbour : profile_.merged_neighbours()) add(neighbour.vertex);
  }
  for (const Index v : touched) complex_.compact(v);
  if (touched_ < Reach::opposite_rings) return;
  for (const ContractionProfile::Common& opposite : profile_.opposites) add_neighbours(opposite.vertex);
  if (!profile_.is_nonmanifold) return;
  for (const ContractionProfile::Common& neighbour : profile_.nonmanifold.common) add_neighbours(neighbour.vertex);
}

/// Queues anew the refused pairs at vertices that guards see the change from.
void ContractionLoop::wake_around() {
  const auto wake_neighbours = [&](Index v) {
    for (const Neighbour& neighbour : complex_.neighbours(v)) wake(neighbour.vertex);
  };
  if (n_rings_ > 1) {
    for (const Neighbour& neighbour : complex_.neighbours(change_.survivor)) {
      for (const Neighbour& beyond : complex_.neighbours(neighbour.vertex)) {
        wake(complex_.representative(beyond.vertex));
      }
    }
  }
  wake(change_.survivor);
  wake(change_.removed);
  wake_neighbours(change_.survivor);
  for (const ContractionProfile::Common& opposite : profile_.opposites) wake(opposite.vertex);
  if (!profile_.is_nonmanifold) return;
  for (const ContractionProfile::Common& neighbour : profile_.nonmanifold.common) {  // their links have changed
    wake(neighbour.vertex);
    wake_neighbours(neighbour.vertex);
  }
}

void ContractionLoop::wake_pairs_at(Index v) {
  refused_.take(v, woken_);
  for (const Index id : woken_) {
    if (complex_.is_pair_alive(id)) queue_->add(pair_now(complex_, id));
  }
}

/// Queues anew those pairs hidden at v that have lost their common faces.
void ContractionLoop::reveal_at(Index v) {
  woken_.clear();
  filter_.reveal(v, woken_);
  for (const Index id : woken_) {
    if (!complex_.is_pair_alive(id)) continue;
    const Pair pair = pair_now(complex_, id);
    if (complex_.is_contractible(pair) && !filter_.hides(pair)) queue_->add(pair);
  }
}

}  // namespace whittle
