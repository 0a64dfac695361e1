#include "loop/pairs_at_once.hh"

#include <algorithm>
#include <utility>

namespace whittle {
namespace {

/// A pair in so many vertices: few enough that the order of cost hardly suffers.
constexpr std::size_t vertices_per_pair = 64;
constexpr std::size_t most_pairs = 64;

}  // namespace

PairsAtOnce::PairsAtOnce(TriangleComplex& complex, const StageLimits& limits, unsigned threads)
    : complex_(complex), thread_pool_(limits.error_bound ? threads : 1) {
  if (limits.border_bound) guards_.push_back(std::make_unique<BorderErrorGuard>(complex, *limits.border_bound));
  if (limits.error_bound) guards_.push_back(std::make_unique<ErrorGuard>(complex, *limits.error_bound));
  if (any()) taken_by_.resize(complex.n_vertex_slots());
}

void PairsAtOnce::clear() {
  n_ = 0;
  ++round_;
  most_ = std::clamp<std::size_t>(complex_.n_vertices() / vertices_per_pair, 1, most_pairs);
}

bool PairsAtOnce::is_apart(const ContractionProfile& profile) {
  closed_.assign({profile.pair.a, profile.pair.b});
  profile.for_each_neighbour([this](Index v) { closed_.push_back(v); });
  return std::none_of(closed_.begin(), closed_.end(), [this](Index v) { return taken_by_[v] == round_; });
}

void PairsAtOnce::add(const RankedPair& ranked, const ContractionProfile& profile,
                      std::span<const MergedPlace> places) {
  for (const Index v : closed_) taken_by_[v] = round_;
  if (n_ == entries_.size()) {
    entries_.emplace_back();
    for (const auto& guard : guards_) entries_.back().looks_.push_back(guard->new_look());
  }
  Entry& entry = entries_[n_++];
  entry.ranked = ranked;
  entry.places.assign(places.begin(), places.end());
  entry.next = 0;
  entry.is_accepted = entry.has_begun_ = false;
  for (std::size_t i = 0; i < guards_.size(); ++i) guards_[i]->begin(profile, entry.looks_[i]);
}

/// On all threads.
template <class Work>
void PairsAtOnce::for_each_open(const Work& work) {
  thread_pool_.for_each_range(open_.size(), 1, [&](std::size_t begin, std::size_t) { work(*open_[begin]); });
}

void PairsAtOnce::look() {
  open_.clear();
  for (Entry& entry : entries()) {
    if (entry.is_open()) open_.push_back(&entry);
  }
  for_each_open([this](Entry& entry) {
    if (std::exchange(entry.has_begun_, true)) return;
    for (std::size_t i = 0; i < guards_.size(); ++i) guards_[i]->list_affected(entry.looks_[i]);
  });
  for_each_open([this](Entry& entry) { look_at(entry); });
}

void PairsAtOnce::look_at(Entry& entry) {
  for (; entry.is_open(); ++entry.next) {
    std::size_t i = 0;
    while (i < guards_.size() && guards_[i]->accepts(entry.place().position, entry.looks_[i])) ++i;
    entry.is_accepted = i == guards_.size();
    if (entry.is_accepted) return;
    entry.refuser_ = i;
  }
}

std::vector<Vec3> PairsAtOnce::nearer_positions(const Entry& entry) const {
  return guards_[entry.refuser_]->nearer_positions(entry.looks_[entry.refuser_]);
}

bool PairsAtOnce::still_accepts(Entry& entry) {
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    if (!guards_[i]->still_accepts(entry.looks_[i], entries_.front().looks_[i])) return false;
  }
  return true;
}

void PairsAtOnce::note(const Change& change, const Entry& entry) {
  for (std::size_t i = 0; i < guards_.size(); ++i) guards_[i]->note(change, entry.looks_[i]);
}

}  // namespace whittle
