#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "bench/command_line.hh"
#include "bench/max_error/contenders/coarsest.hh"
#include "bench/max_error/contenders/contender.hh"
#include "bench/max_error/judge.hh"
#include "bench/max_error/report.hh"
#include "bench/max_error/times.hh"
#include "bench/processes/forked.hh"
#include "bench/results/csv.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/format.hh"
#include "whittle/io/read.hh"
#include "whittle/simplify/simplify.hh"

// Results of `simplify` with a length as target: are they proven rightly, how many faces and how much time do they
// take? run.sh --max-error builds and calls it.

namespace whittle::bench {
namespace {

const std::set<std::string> all_parts = {"proofs", "level", "peers", "times", "pair"};

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> folders;
  std::vector<double> percents = {0.1, 0.2, 0.3};
  std::vector<std::string> parts;
  std::vector<std::string> contenders;
  std::size_t samples = JudgeOptions{}.samples;
  TimeOptions times;
  double limit_s = 120;  ///< for CGAL's distance, and for each search of faces
  RowsFile rows{.csv = "max_error.csv"};

  bool has(const std::string& part) const {
    return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
  }
};

/// A mesh, and whether others take part.
struct Input {
  std::string name;
  IndexedMesh mesh;
  bool is_judged_alone = false;  ///< of a folder: no times, and no others
};

SimplifyOptions on_threads(unsigned threads) {
  SimplifyOptions options;
  options.decimate.threads = threads;
  return options;
}

/// `simplify` to a number of faces.
Contender levels(unsigned threads) {
  return {"level", Contender::Amount::faces, [threads](const IndexedMesh& input, double n_faces) {
            const auto n = static_cast<std::uint64_t>(n_faces);
            return simplify(input, DecimateTarget::faces(n), Effort::normal, on_threads(threads)).mesh;
          }};
}

/// In a process of its own.
std::optional<std::size_t> faces_of_contender(const std::string& name, const IndexedMesh& input, Search search,
                                              std::vector<std::string>& remarks) {
  const Contender contender = make_contender(name);
  if (contender.takes == Contender::Amount::length) search.first_amount = search.max_error;
  const auto work = [&] {
    const std::optional<Coarsest> coarsest = coarsest_within(input, contender, search);
    return coarsest ? std::to_string(coarsest->n_faces) + (coarsest->is_complete ? "" : "?") : std::string();
  };
  std::cerr << "      " << name << std::flush;
  std::string found;
  try {
    found = run_forked(work, 4 * search.limit_s);
    if (found.empty()) remarks.push_back(name + ": no result is near enough");
  } catch (const std::exception& error) {
    remarks.push_back(name + ": " + error.what());
  }
  std::cerr << ' ' << found << std::endl;
  if (found.empty()) return std::nullopt;
  if (found.back() == '?') remarks.push_back(name + ": the best that was found in time");
  return std::stoul(found);
}

void add_others(const Input& input, double max_error, const Options& options, Row& row) {
  Search search;
  search.max_error = max_error;
  search.first_amount = static_cast<double>(std::max<std::size_t>(row.n_faces, 4));
  search.limit_s = options.limit_s;
  if (options.has("level")) {
    if (const auto level = coarsest_within(input.mesh, levels(options.times.threads), search)) {
      row.level = level->n_faces;
      if (!level->is_complete) row.remarks.emplace_back("level: the best that was found in time");
    }
  }
  if (!options.has("peers") || input.is_judged_alone) return;
  for (const std::string& name : options.contenders)
    row.contenders.push_back(faces_of_contender(name, input.mesh, search, row.remarks));
}

/// What `work` throws is a violation.
template <class Work>
void guarded(Row& row, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    row.violations.emplace_back(error.what());
  }
}

Row row_at(const Input& input, double percent, const Options& options) {
  Row row;
  row.mesh = input.name;
  row.n_input = input.mesh.faces.size();
  row.error_rel = percent / 100;
  const double max_error = row.error_rel * diagonal_of(input.mesh.positions);
  std::cerr << "   " << percent << " %" << std::endl;
  guarded(row, [&] {
    const DecimateTarget target = DecimateTarget::max_error(max_error);
    const IndexedMesh result = simplify(input.mesh, target, Effort::normal, on_threads(options.times.threads)).mesh;
    row.n_faces = result.faces.size();
    if (options.has("proofs")) {
      row.proof = judged(input.mesh, result, max_error, {options.samples, options.limit_s}, row.remarks);
      row.violations = violations(*row.proof);
    }
    if (options.has("times") && !input.is_judged_alone)
      row.time = time_beside(input.mesh, max_error, row.n_faces, options.times);
    add_others(input, max_error, options, row);
  });
  return row;
}

std::vector<Row> rows_of(const Input& input, const Options& options) {
  std::vector<Row> rows;
  for (const double percent : options.percents) rows.push_back(row_at(input, percent, options));
  if (!options.has("pair") || input.is_judged_alone) return rows;
  Row pair;
  guarded(pair, [&] { pair = time_pair(input.mesh, options.times); });
  pair.mesh = input.name;
  rows.push_back(std::move(pair));
  return rows;
}

bool is_named_as_mesh(const std::filesystem::path& path) {
  try {
    io::format_of(path);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::vector<std::pair<std::filesystem::path, bool>> chosen_files(const Options& options) {
  std::vector<std::pair<std::filesystem::path, bool>> files;
  for (const std::string& file : options.files) files.emplace_back(file, false);
  for (const std::string& folder : options.folders) {
    std::set<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && is_named_as_mesh(entry.path())) found.insert(entry.path());
    for (const auto& file : found) {
      const auto is_same = [&file](const auto& other) { return std::filesystem::equivalent(file, other.first); };
      if (std::none_of(files.begin(), files.end(), is_same)) files.emplace_back(file, true);
    }
  }
  return files;
}

/// Nothing if it has no faces or can't be read; says why.
std::optional<Input> read_input(const std::filesystem::path& file, bool is_judged_alone) {
  std::cerr << "== " << file.filename().string() << std::endl;
  try {
    Input input{file.stem().string(), io::read_mesh(file).mesh, is_judged_alone};
    if (!input.mesh.faces.empty()) return input;
    std::cerr << "   has no faces" << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "   " << error.what() << std::endl;
  }
  return std::nullopt;
}

int run(const Options& options) {
  RowsCsv csv(options.rows.csv, options.contenders, options.rows.commit);
  std::vector<Row> all;
  for (const auto& [file, is_judged_alone] : chosen_files(options)) {
    const std::optional<Input> input = read_input(file, is_judged_alone);
    if (!input) continue;
    const std::vector<Row> rows = rows_of(*input, options);
    std::cout << to_text(rows, options.contenders) << std::endl;
    for (const Row& row : rows) csv.add(row);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  std::cout << to_text(marks_of(all, options.contenders));
  const bool is_right = std::all_of(all.begin(), all.end(), [](const Row& row) { return row.violations.empty(); });
  if (!is_right) std::cerr << "error: something that is claimed is not so, see above\n";
  return is_right ? 0 : 1;
}

std::string listed(const auto& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// "0.1%" as "0.1".
std::string without_percent_sign(std::string& text) {
  if (text.ends_with('%')) text.pop_back();
  return {};
}

void set_up(CLI::App& app, Options& options) {
  app.add_option("--mesh", options.files, "a mesh file; can be given again")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--folder", options.folders, "all meshes in it, for proofs and level alone; can be given again")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.add_option("--errors", options.percents, "largest distances E, in % of the diagonal")
      ->type_name("P,...")
      ->delimiter(',')
      ->transform(CLI::Validator(without_percent_sign, ""))
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--only", options.parts, "of " + listed(all_parts) + " (default: all)")
      ->type_name("PART,...")
      ->delimiter(',')
      ->check(CLI::IsMember(all_parts));
  app.add_option("--peers", options.contenders, "whose faces are compared: " + listed(contender_names()))
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember(contender_names()));
  app.add_option("--limit", options.limit_s,
                 "CGAL's distance is left out after this; a search of faces begins no run then, seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--samples", options.samples, "points on each surface, besides all corners")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--repetitions", options.times.rounds, "rounds that count")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", options.times.threads, "of all runs")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_options(app, options.rows);
}

}  // namespace
}  // namespace whittle::bench

int main(int argc, char** argv) {
  using namespace whittle::bench;
  CLI::App app("Measures results of simplify with a length as target.", "whittle_bench_max_error");
  Options options;
  set_up(app, options);
  return run_program(app, argc, argv, [&options] { return run(options); });
}
