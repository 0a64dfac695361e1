#include "cost/quadric/attribute_quadrics.hh"

#include <algorithm>

namespace whittle {
namespace {

/// The number of wedges at a vertex that can be told apart; those beyond join none.
constexpr std::size_t most_matched = 64;

/// How the numbers of a sum lie: the weight, then the second moments of all components together, then for each
/// component the weighted sum of its linear functions.
enum Place : std::size_t { weight = 0, matrix = 1, slope = 7, constant = 10, functions = 11 };

double second_moment(const double* sum, const Vec3& p) {
  const double* m = sum + matrix;
  const double x = p.x();
  const double y = p.y();
  const double z = p.z();
  const double square = m[0] * x * x + m[3] * y * y + m[5] * z * z + 2 * (m[1] * x * y + m[2] * x * z + m[4] * y * z);
  return square + 2 * (sum[slope] * x + sum[slope + 1] * y + sum[slope + 2] * z) + sum[constant];
}

double at(const double* function, const Vec3& p) {
  return function[0] * p.x() + function[1] * p.y() + function[2] * p.z() + function[3];
}

}  // namespace

AttributeQuadrics::AttributeQuadrics(const TriangleComplex& complex, AttributeSums sums)
    : sums_(std::move(sums)), first_(complex.n_vertex_slots(), invalid_index), next_(sums_.vertex_of.size()) {
  std::vector<Index> first_of(complex.n_vertex_slots(), invalid_index);  // by vertex of the surface
  for (auto w = static_cast<Index>(next_.size()); w-- > 0;) {
    Index& first = first_of[sums_.vertex_of[w]];
    next_[w] = first;
    first = w;
  }
  for (Index v = 0; v < first_.size(); ++v) first_[v] = first_of[complex.origin(v)];
}

double AttributeQuadrics::error_at(Index wedge, const Vec3& position) const {
  const double* const s = sum(wedge);
  if (!(s[weight] > 0)) return 0;
  double means = 0;
  for (const double* f = s + functions; f < s + sums_.stride(); f += 4) {
    const double total = at(f, position);
    means += total * total;
  }
  const double error = second_moment(s, position) - means / s[weight];
  return std::clamp(error, 0.0, s[weight] * sums_.farthest * sums_.farthest);
}

double AttributeQuadrics::error_of_both(Index first, Index second, const Vec3& position) const {
  const double* const s = sum(first);
  const double* const t = sum(second);
  const double both = s[weight] + t[weight];
  if (!(both > 0)) return 0;
  double means = 0;
  for (std::size_t i = functions; i < sums_.stride(); i += 4) {
    const double total = at(s + i, position) + at(t + i, position);
    means += total * total;
  }
  const double error = second_moment(s, position) + second_moment(t, position) - means / both;
  return std::clamp(error, 0.0, both * sums_.farthest * sums_.farthest);
}

/// The wedge at `vertex`, of those not used, that costs least together with `wedge`. \pre there is one
AttributeQuadrics::Match AttributeQuadrics::best_match(Index wedge, Index vertex, std::uint64_t used,
                                                       const Vec3& position) const {
  Match best{invalid_index, 0};
  std::size_t place = 0;
  for (Index w = first_[vertex]; w != invalid_index && place < most_matched; w = next_[w], ++place) {
    if ((used >> place & 1U) != 0) continue;
    const double error = error_of_both(wedge, w, position);
    if (best.wedge == invalid_index || error < best.error) best = {w, error};
  }
  return best;
}

std::size_t AttributeQuadrics::n_wedges_at(Index v) const {
  std::size_t n = 0;
  for (Index w = first_[v]; w != invalid_index; w = next_[w]) ++n;
  return n;
}

template <class Found>
void AttributeQuadrics::match(const Pair& pair, bool is_edge, const Vec3& position, const Found& found) const {
  Index few = pair.a;
  Index many = pair.b;
  if (n_wedges_at(few) > n_wedges_at(many)) std::swap(few, many);
  std::uint64_t used = 0;
  std::size_t n_left = is_edge ? std::min(most_matched, n_wedges_at(few)) : 0;
  for (Index w = first_[few]; w != invalid_index; w = next_[w]) {
    if (n_left == 0) {
      found(w, invalid_index, error_at(w, position));
      continue;
    }
    --n_left;
    const Match best = best_match(w, many, used, position);
    std::size_t place = 0;
    for (Index other = first_[many]; other != best.wedge; other = next_[other]) ++place;
    used |= std::uint64_t{1} << place;
    found(best.wedge, w, best.error);
  }
  std::size_t place = 0;
  for (Index w = first_[many]; w != invalid_index; w = next_[w], ++place) {
    const bool is_used = place < most_matched && (used >> place & 1U) != 0;
    if (!is_used) found(w, invalid_index, error_at(w, position));
  }
}

double AttributeQuadrics::error(const Pair& pair, bool is_edge, const Vec3& position) const {
  const Index a = first_[pair.a];
  const Index b = first_[pair.b];
  if (is_edge && a != invalid_index && b != invalid_index && next_[a] == invalid_index && next_[b] == invalid_index) {
    return error_of_both(a, b, position);
  }
  double total = 0;
  match(pair, is_edge, position, [&total](Index, Index, double error) { total += error; });
  return total;
}

void AttributeQuadrics::merge(const Change& change, bool is_edge) {
  std::vector<Index> kept;
  std::vector<std::pair<Index, Index>> joined;
  match(change.pair, is_edge, change.position, [&](Index wedge, Index other, double) {
    kept.push_back(wedge);
    if (other != invalid_index) joined.emplace_back(wedge, other);
  });
  for (const auto& [wedge, other] : joined) {
    double* const into = sums_.sums.data() + wedge * sums_.stride();
    const double* const from = sum(other);
    for (std::size_t i = 0; i < sums_.stride(); ++i) into[i] += from[i];
  }
  std::sort(kept.begin(), kept.end());
  first_[change.removed] = invalid_index;
  Index* last = &first_[change.survivor];
  for (const Index w : kept) {
    *last = w;
    last = &next_[w];
  }
  *last = invalid_index;
}

}  // namespace whittle
