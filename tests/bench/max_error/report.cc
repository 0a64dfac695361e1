#include "bench/max_error/report.hh"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bench/results/csv.hh"
#include "terminal/table.hh"

namespace whittle::bench {
namespace {

using Value = std::optional<double>;

/// A number of a row, its name in tables and files, and how it is printed.
struct Quantity {
  std::string heading;
  std::string key;
  const char* format;
  std::function<Value(const Row&)> of;
};

Value number(std::optional<std::size_t> n) { return n ? Value(static_cast<double>(*n)) : std::nullopt; }

/// Of a member of an optional part of the row.
template <class Part, class Member>
std::function<Value(const Row&)> of_part(std::optional<Part> Row::*part, Member Part::*member) {
  return [part, member](const Row& row) -> Value {
    if (!(row.*part)) return std::nullopt;
    if constexpr (std::is_convertible_v<Member, double>) {
      return static_cast<double>((*(row.*part)).*member);
    } else {
      return (*(row.*part)).*member;
    }
  };
}

std::vector<Quantity> quantities(const std::vector<std::string>& contenders) {
  const char* const share = "%.4f";
  const char* const count = "%.0f";
  const char* const seconds = "%.3f";
  std::vector<Quantity> all = {
      {"faces", "result_faces", count, [](const Row& row) { return number(row.n_faces); }},
      {"proven distance / E", "certified", share, of_part(&Row::proof, &Proof::certified)},
      {"the farthest point's", "found", share, of_part(&Row::proof, &Proof::found)},
      {"the farthest sample's", "sampled", share, of_part(&Row::proof, &Proof::sampled)},
      {"by CGAL", "by_cgal", share, of_part(&Row::proof, &Proof::by_cgal)},
      {"proven of borders / E", "borders", share, of_part(&Row::proof, &Proof::borders)},
      {"the farthest sample's", "sampled_borders", share, of_part(&Row::proof, &Proof::sampled_borders)},
      {"certificate, bytes", "certificate_bytes", count, of_part(&Row::proof, &Proof::certificate_bytes)},
      {"s", "seconds", seconds, of_part(&Row::time, &TimeBeside::with_limit)},
      {"plain run, s", "plain_seconds", seconds, of_part(&Row::time, &TimeBeside::plain)},
      {"ratio", "time_ratio", "%.2f", of_part(&Row::time, &TimeBeside::ratio)},
      {"simplifying, s", "pair_simplify_seconds", seconds, of_part(&Row::pair, &PairTimes::simplify)},
      {"certifying, s", "pair_certify_seconds", seconds, of_part(&Row::pair, &PairTimes::certify)},
      {"certifying by the map, s", "pair_certify_by_map_seconds", seconds,
       of_part(&Row::pair, &PairTimes::certify_by_map)},
      {"certificate, s", "pair_certificate_seconds", seconds, of_part(&Row::pair, &PairTimes::certificate)},
      {"verifying, s", "pair_verify_seconds", seconds, of_part(&Row::pair, &PairTimes::verify)},
      {"faces: level", "level", count, [](const Row& row) { return number(row.level); }}};
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    all.push_back({"faces: " + contenders[i], contenders[i], count, [i](const Row& row) {
                     return i < row.contenders.size() ? number(row.contenders[i]) : std::nullopt;
                   }});
  }
  return all;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

}  // namespace

std::string to_text(const std::vector<Row>& rows, const std::vector<std::string>& contenders) {
  if (rows.empty()) return {};
  app::Table table;
  std::vector<std::string> heading{rows.front().mesh + ", " + std::to_string(rows.front().n_input) + " faces"};
  for (const Row& row : rows)
    heading.push_back(row.pair ? "a tenth" : "E = " + formatted("%.3g %%", 100 * row.error_rel));
  table.add(heading);
  for (const Quantity& quantity : quantities(contenders)) {
    const auto has_value = [&quantity](const Row& row) { return quantity.of(row).has_value(); };
    if (std::none_of(rows.begin(), rows.end(), has_value)) continue;
    std::vector<std::string> cells{quantity.heading};
    for (const Row& row : rows) cells.push_back(text_or_dash(quantity.of(row), quantity.format));
    table.add(std::move(cells));
  }
  std::string text = table.text();
  for (const Row& row : rows) {
    const std::string where = formatted("%.3g", 100 * row.error_rel) + " %: ";
    if (!row.violations.empty()) text += "VIOLATION at " + where + joined(row.violations) + '\n';
    if (!row.remarks.empty()) text += "at " + where + joined(row.remarks) + '\n';
  }
  return text;
}

RowsCsv::RowsCsv(std::filesystem::path path, std::vector<std::string> contenders, std::string commit)
    : path_(std::move(path)), contenders_(std::move(contenders)), commit_(std::move(commit)), file_(path_) {
  std::vector<std::string> cells = {"mesh", "faces", "error_rel"};
  for (const Quantity& quantity : quantities(contenders_)) cells.push_back(quantity.key);
  cells.insert(cells.end(), {"violations", "remarks", "compiler", "commit"});
  write(cells);
}

void RowsCsv::add(const Row& row) {
  std::vector<std::string> cells = {row.mesh, std::to_string(row.n_input), csv_number(row.error_rel)};
  for (const Quantity& quantity : quantities(contenders_)) cells.push_back(csv_number(quantity.of(row)));
  cells.insert(cells.end(), {joined(row.violations), joined(row.remarks), WHITTLE_BENCH_COMPILER, commit_});
  write(cells);
}

void RowsCsv::write(const std::vector<std::string>& cells) {
  file_ << csv_line(cells) << std::flush;
  if (!file_) throw std::runtime_error("can't write " + path_.string());
}

}  // namespace whittle::bench
