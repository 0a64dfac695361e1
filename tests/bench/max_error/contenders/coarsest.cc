#include "bench/max_error/contenders/coarsest.hh"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "whittle/metrics/certify.hh"

namespace whittle::bench {
namespace {

constexpr int most_steps = 16;              ///< to find a result on either side
constexpr double distance_accuracy = 0.01;  ///< relative; the limit itself is exact

class Bisection {
 public:
  Bisection(const IndexedMesh& input, const Contender& contender, const Search& search)
      : input_(input), contender_(contender), search_(search) {}

  std::optional<Coarsest> run() {
    double near = 0;  // logarithms of how much coarser than the first amount
    double far = 0;
    double missing = measure(0);
    const bool begins_near = missing >= 0;
    double& moving = begins_near ? near : far;
    for (int i = 0; i < most_steps && !is_late(); ++i) {
      const double step = std::clamp(std::abs(missing), 2 * search_.accuracy, std::log(2.0));
      const double next = begins_near ? moving + step : moving - step;
      if (amount_at(next) == amount_at(moving)) break;
      missing = measure(next);
      (begins_near ? far : near) = next;
      if ((missing >= 0) != begins_near) break;
      moving = next;
    }
    while (best_ && !is_late() && far - near > search_.accuracy && differ(near, far)) {
      const double middle = 0.5 * (near + far);
      (measure(middle) >= 0 ? near : far) = middle;
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

  /// Makes a result, and keeps it if it is near enough and has the fewest faces.
  /// \return the logarithm of how much farther it may be; not negative if it is near enough
  double measure(double coarseness) {
    const double amount = amount_at(coarseness);
    ++n_runs_;
    const IndexedMesh result = contender_.decimate(input_, amount);
    if (result.faces.empty()) return -std::log(2.0);
    const metrics::LargestDistances largest =
        metrics::largest_distances(input_, result, distance_accuracy, {.limit = search_.max_error});
    const double distance = std::max(largest.forward.at_most, largest.backward.at_most);
    if (distance > search_.max_error) return std::log(search_.max_error / distance);
    if (!best_ || result.faces.size() < best_->n_faces) best_ = {result.faces.size(), amount};
    return distance > 0 ? std::log(search_.max_error / distance) : std::log(2.0);
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
