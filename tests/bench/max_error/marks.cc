#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "bench/max_error/report.hh"
#include "bench/results/csv.hh"
#include "terminal/table.hh"

namespace whittle::bench {
namespace {

/// A ratio of each row that has it.
class Ratios {
 public:
  Ratios(const std::vector<Row>& rows, const std::function<std::optional<double>(const Row&)>& ratio) {
    for (const Row& row : rows) {
      const std::optional<double> value = ratio(row);
      if (!value) continue;
      ++n_;
      logarithms_ += std::log(*value);
      if (!worst_ || *value > largest_) worst_ = &row, largest_ = *value;
    }
  }
  bool empty() const { return n_ == 0; }
  double largest() const { return largest_; }
  double geometric_mean() const { return std::exp(logarithms_ / n_); }
  /// "0.712 (bunny, 0.1 %)"
  std::string largest_text() const {
    return formatted("%.3f", largest_) + " (" + worst_->mesh + formatted(", %.3g %%)", 100 * worst_->error_rel);
  }
  std::string number_text() const { return " of " + std::to_string(n_) + " results"; }

 private:
  int n_ = 0;
  double logarithms_ = 0;
  double largest_ = 0;
  const Row* worst_ = nullptr;
};

std::function<std::optional<double>(const Row&)> of_proof(
    const std::function<std::optional<double>(const Proof&)>& of) {
  return [of](const Row& row) { return row.proof ? of(*row.proof) : std::nullopt; };
}

Mark most(const std::string& what, const Ratios& ratios, double wanted) {
  return {what + ", largest" + ratios.number_text(), ratios.largest_text(), formatted("<= %.3g", wanted),
          ratios.largest() <= wanted};
}

bool is_near(double a, double b) { return std::abs(a / b - 1) < 1e-6; }

/// Faces over those of the contender that has the fewest.
std::optional<double> beside_contenders(const Row& row) {
  std::optional<double> largest;
  for (const std::optional<std::size_t>& n : row.contenders) {
    if (n) largest = std::max(largest.value_or(0), static_cast<double>(row.n_faces) / static_cast<double>(*n));
  }
  return largest;
}

void add_proof_marks(const std::vector<Row>& rows, std::vector<Mark>& marks) {
  const auto n_violations =
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.violations.empty(); });
  marks.push_back({"results with a violation, of " + std::to_string(rows.size()), std::to_string(n_violations), "0",
                   n_violations == 0});
  const Ratios tight(rows, of_proof([](const Proof& proof) -> std::optional<double> {
                       if (proof.found < 1e-3) return std::nullopt;  // exact but for rounding
                       return proof.certified / proof.found;
                     }));
  if (!tight.empty()) marks.push_back(most("proven over true distance", tight, 1.02));
  const Ratios borders(rows, of_proof([](const Proof& proof) { return proof.borders; }));
  if (!borders.empty()) marks.push_back(most("proven distance of borders over E", borders, 1));
  const Ratios bytes(rows,
                     of_proof([](const Proof& proof) { return std::optional(proof.has_same_bytes ? 0.0 : 1.0); }));
  if (!bytes.empty()) {
    marks.push_back({"bytes that depend on threads" + bytes.number_text(),
                     bytes.largest() > 0 ? bytes.largest_text() : "none", "none", bytes.largest() == 0});
  }
}

void add_face_marks(const std::vector<Row>& rows, const std::vector<std::string>& contenders,
                    std::vector<Mark>& marks) {
  const Ratios level(rows, [](const Row& row) -> std::optional<double> {
    if (!row.level) return std::nullopt;
    return static_cast<double>(row.n_faces) / static_cast<double>(*row.level);
  });
  if (!level.empty()) {
    const double mean = level.geometric_mean();
    marks.push_back({"faces over best level, geometric mean" + level.number_text(), formatted("%.3f", mean), "<= 0.33",
                     mean <= 0.33});
    marks.push_back(most("faces over best level", level, 1));
  }
  const Ratios fewest(rows, beside_contenders);
  if (!fewest.empty()) marks.push_back(most("faces over the fewest of others", fewest, 1));
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Ratios one(rows, [i](const Row& row) -> std::optional<double> {
      if (i >= row.contenders.size() || !row.contenders[i]) return std::nullopt;
      return static_cast<double>(row.n_faces) / static_cast<double>(*row.contenders[i]);
    });
    if (!one.empty()) marks.push_back(most("faces over those of " + contenders[i], one, 1));
  }
}

void add_time_marks(const std::vector<Row>& rows, std::vector<Mark>& marks) {
  for (const auto& [share, wanted] : {std::pair(0.003, 4.0), {0.001, 10.0}}) {
    const Ratios times(rows, [share = share](const Row& row) -> std::optional<double> {
      return row.time && is_near(row.error_rel, share) ? std::optional(row.time->ratio) : std::nullopt;
    });
    if (!times.empty())
      marks.push_back(most(formatted("time over a plain run's at %.3g %%", 100 * share), times, wanted));
  }
  const auto over_simplify = [&rows](double PairTimes::*time) {
    return Ratios(rows, [time](const Row& row) {
      return row.pair ? std::optional((*row.pair).*time / row.pair->simplify) : std::nullopt;
    });
  };
  const Ratios certify = over_simplify(&PairTimes::certify);
  if (certify.empty()) return;
  marks.push_back(most("certifying over simplifying to 10 %", certify, 0.5));
  marks.push_back(
      most("certifying by the map over simplifying to 10 %", over_simplify(&PairTimes::certify_by_map), 0.5));
  marks.push_back(most("verifying over simplifying to 10 %", over_simplify(&PairTimes::verify), 0.5));
}

}  // namespace

std::vector<Mark> marks_of(const std::vector<Row>& rows, const std::vector<std::string>& contenders) {
  std::vector<Mark> marks;
  add_proof_marks(rows, marks);
  add_face_marks(rows, contenders, marks);
  add_time_marks(rows, marks);
  return marks;
}

std::string to_text(const std::vector<Mark>& marks) {
  app::Table table;
  table.add({"what", "measured", "mark", ""});
  for (const Mark& mark : marks) table.add({mark.what, mark.measured, mark.wanted, mark.is_met ? "met" : "MISSED"});
  return table.text();
}

}  // namespace whittle::bench
