#include "bench/results/report.hh"

#include <stdexcept>
#include <utility>

#include "bench/results/csv.hh"
#include "bench/results/statistics.hh"
#include "terminal/table.hh"

namespace whittle::bench {
namespace {

/// One decimal for small numbers, none for large ones.
std::string ms_text(double ms) { return formatted(ms < 100 ? "%.1f" : "%.0f", ms); }

/// Adds min, median and max, or `none` three times.
template <class ToText>
void add_spread(std::vector<std::string>& cells, const std::vector<double>& ms, const char* none, ToText to_text) {
  if (ms.empty()) {
    cells.insert(cells.end(), {none, none, none});
    return;
  }
  const Spread spread = spread_of(ms);
  for (const double value : {spread.min, spread.median, spread.max}) cells.push_back(to_text(value));
}

/// The text of the column `answer`.
std::string remark(const Row& row) {
  if (!row.problem.empty()) return row.problem;
  return row.answer && !row.answer->defect.empty() ? row.answer->defect : "ok";
}

std::vector<std::string> table_cells(const Row& row) {
  std::vector<std::string> cells = {row.peer};
  cells.push_back(row.answer ? std::to_string(row.answer->n_faces) : "-");
  add_spread(cells, row.ms, "-", ms_text);
  cells.push_back(text_or_dash(row.ratio_to_meshoptimizer, "%.3f"));
  cells.push_back(text_or_dash(row.ratio_to_whittle, "%.3f"));
  cells.push_back(text_or_dash(row.peak_bytes_per_face, "%.0f"));
  cells.push_back(text_or_dash(row.answer ? row.answer->mean_error_rel : std::nullopt, "%.3e"));
  cells.push_back(text_or_dash(row.answer ? row.answer->max_error_rel : std::nullopt, "%.3e"));
  cells.push_back(remark(row));
  return cells;
}

}  // namespace

std::string to_text(const std::vector<Row>& rows) {
  if (rows.empty()) return {};
  app::Table table;
  table.add(
      {"", "faces", "min ms", "median", "max", "/meshopt.", "/whittle", "B/face", "mean err.", "max err.", "answer"});
  for (const Row& row : rows) table.add(table_cells(row));
  return rows.front().mesh + ": " + std::to_string(rows.front().n_faces) + " faces to " +
         std::to_string(rows.front().n_wanted) + '\n' + table.text();
}

CsvFile::CsvFile(const std::filesystem::path& path, Setting setting)
    : path_(path), setting_(std::move(setting)), file_(path) {
  file_ << csv_line({"peer", "mesh", "faces", "wanted", "result_faces", "ms_min", "ms_median", "ms_max", "rounds",
                     "clock", "ratio_to_meshoptimizer", "ratio_to_whittle", "peak_bytes_per_face", "mean_error_rel",
                     "max_error_rel", "manifold", "answer", "compiler", "commit"})
        << std::flush;
  if (!file_) throw std::runtime_error("can't write " + path_.string());
}

void CsvFile::add(const Row& row) {
  const Answer answer = row.answer.value_or(Answer{});
  std::vector<std::string> cells = {row.peer, row.mesh, std::to_string(row.n_faces), std::to_string(row.n_wanted)};
  cells.push_back(row.answer ? std::to_string(answer.n_faces) : "");
  add_spread(cells, row.ms, "", [](double ms) { return csv_number(ms); });
  cells.push_back(std::to_string(row.ms.size()));
  cells.push_back(to_string(setting_.clock));
  for (const auto& value : {row.ratio_to_meshoptimizer, row.ratio_to_whittle, row.peak_bytes_per_face,
                            answer.mean_error_rel, answer.max_error_rel})
    cells.push_back(csv_number(value));
  cells.push_back(!row.answer ? "" : answer.is_manifold ? "yes" : "no");
  cells.insert(cells.end(), {remark(row), setting_.compiler, setting_.commit});
  file_ << csv_line(cells) << std::flush;
  if (!file_) throw std::runtime_error("can't write " + path_.string());
}

}  // namespace whittle::bench
