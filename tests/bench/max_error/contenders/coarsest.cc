#include "bench/max_error/contenders/coarsest.hh"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "whittle/metrics/certify.hh"

namespace whittle::bench {
namespace {

constexpr int most_doublings = 10;

class Bisection {
 public:
  Bisection(const IndexedMesh& input, const Contender& contender, const Search& search)
      : input_(input), contender_(contender), search_(search) {}

  std::optional<Coarsest> run() {
    const bool begins_near = is_near_enough(0);
    double near = 0;  // logarithms of how much coarser than the first amount
    double far = 0;
    for (int i = 1; i <= most_doublings && !is_late() && (near == far || differ(near, far)); ++i) {
      const double next = (begins_near ? i : -i) * std::log(2.0);
      const bool is_near = is_near_enough(next);
      (begins_near ? near : far) = begins_near ? far : near;
      (begins_near ? far : near) = next;
      if (is_near != begins_near) break;
    }
    while (best_ && !is_late() && far - near > search_.accuracy && differ(near, far)) {
      const double middle = 0.5 * (near + far);
      (is_near_enough(middle) ? near : far) = middle;
    }
    if (!best_) return std::nullopt;
    best_->n_runs = n_runs_;
    best_->is_complete = !is_late();
    return best_;
  }

 private:
  bool is_late() const {
    return std::chrono::steady_clock::now() - start_ > std::chrono::duration<double>(search_.limit_s);
  }
  double amount_at(double coarseness) const {
    if (contender_.takes == Contender::Amount::length) return search_.first_amount * std::exp(coarseness);
    const auto all = static_cast<double>(input_.faces.size());
    return std::clamp(std::round(search_.first_amount * std::exp(-coarseness)), 1.0, all);
  }
  /// Numbers of faces don't, if they are rounded to the same one or to neighbours.
  bool differ(double near, double far) const {
    return contender_.takes == Contender::Amount::length || amount_at(near) > amount_at(far) + 1;
  }

  /// Keeps the result with the fewest faces.
  bool is_near_enough(double coarseness) {
    const double amount = amount_at(coarseness);
    ++n_runs_;
    const IndexedMesh result = contender_.decimate(input_, amount);
    if (result.faces.empty()) return false;
    if (metrics::certify(input_, result, search_.max_error).verdict != metrics::Verdict::proven) return false;
    if (!best_ || result.faces.size() < best_->n_faces) best_ = {result.faces.size(), amount};
    return true;
  }

  const IndexedMesh& input_;
  const Contender& contender_;
  const Search& search_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<Coarsest> best_;
  int n_runs_ = 0;
};

}  // namespace

std::optional<Coarsest> coarsest_within(const IndexedMesh& input, const Contender& contender, const Search& search) {
  return Bisection(input, contender, search).run();
}

}  // namespace whittle::bench
