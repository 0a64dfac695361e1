#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "bench/command_line.hh"
#include "bench/efficiency.hh"
#include "bench/meshes.hh"
#include "bench/peers/peer.hh"
#include "bench/results/csv.hh"
#include "bench/results/plots.hh"
#include "bench/results/report.hh"
#include "bench/results/statistics.hh"
#include "bench/run_case.hh"
#include "bench/scaling.hh"
#include "support/meshes.hh"
#include "terminal/table.hh"

// Whittle's engine beside other decimaters, on the same arrays, in one process. run.sh builds and calls it.

namespace whittle::bench {
namespace {

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> cases;
  std::vector<std::string> peers;
  std::vector<double> ratios = {0.1};
  std::string base;
  bool permuted = false;
  bool scaling = false;
  std::vector<std::size_t> efficiency;  ///< numbers of faces
  std::uint64_t seed = 1;
  RunOptions run;
  RowsFile rows{.csv = "bench.csv"};
  std::string plots;  ///< folder; empty = none
};

constexpr char all_cases[] = "all";

std::vector<std::string> default_peers() {
  std::vector<std::string> names;
  for (const std::string& name : peer_names()) {
    names.push_back(name);
    if (name == "whittle") names.insert(names.end(), {"whittle:2", "whittle:3", "whittle:8"});
  }
  return names;
}

std::string case_names() {
  std::string names = all_cases;
  for (const Case& made : made_cases({})) names += ", " + made.name;
  return names;
}

std::vector<Case> chosen_made_cases(const Options& options) {
  std::optional<std::filesystem::path> base = test::real_mesh("armadillo_86k.obj");
  if (!options.base.empty()) base = options.base;
  const std::vector<Case> made = made_cases(base);
  std::vector<Case> chosen;
  for (const std::string& name : options.cases) {
    const std::size_t n_before = chosen.size();
    for (const Case& candidate : made)
      if (name == candidate.name || name == all_cases) chosen.push_back(candidate);
    if (chosen.size() == n_before) throw CLI::ValidationError("--case", "'" + name + "' is none of " + case_names());
  }
  return chosen;
}

std::vector<Case> chosen_cases(const Options& options) {
  std::vector<Case> cases;
  for (const std::string& file : options.files) cases.push_back(file_case(file));
  for (Case& made : chosen_made_cases(options)) cases.push_back(std::move(made));
  if (!options.permuted) return cases;
  std::vector<Case> both;
  for (const Case& original : cases) {
    both.push_back(original);
    both.push_back(permuted(original, options.seed));
  }
  return both;
}

std::vector<NamedPeer> chosen_peers(const Options& options) {
  std::vector<NamedPeer> peers;
  for (const std::string& name : options.peers.empty() ? default_peers() : options.peers)
    peers.push_back({name, make_peer(name)});
  return peers;
}

/// Whether both rows are of one peer, on the smaller and the larger of the spheres, at the same share of faces.
bool shows_growth(const Row& small, const Row& large) {
  if (small.peer != large.peer || small.mesh != "sphere-70k" || large.mesh != "sphere-1394k") return false;
  const auto share = [](const Row& row) {
    return static_cast<double>(row.n_wanted) / static_cast<double>(row.n_faces);
  };
  return !small.ms.empty() && !large.ms.empty() && std::abs(share(small) / share(large) - 1) < 0.01;
}

/// How the time of each peer grows between the two spheres: the exponent of the number of faces.
std::string growth_text(const std::vector<Row>& rows) {
  app::Table table;
  table.add({"growth from sphere-70k to sphere-1394k", "exponent"});
  bool is_known = false;
  for (const Row& small : rows) {
    for (const Row& large : rows) {
      if (!shows_growth(small, large)) continue;
      const double times = spread_of(large.ms).median / spread_of(small.ms).median;
      const double faces = static_cast<double>(large.n_faces) / static_cast<double>(small.n_faces);
      table.add({small.peer, formatted("%.3f", std::log(times) / std::log(faces))});
      is_known = true;
    }
  }
  return is_known ? table.text() : "";
}

/// Of those of our peers that take part.
std::string scaling_text(const IndexedMesh& input, double ratio, const std::vector<NamedPeer>& peers, int rounds) {
  const auto n_wanted = static_cast<std::size_t>(ratio * static_cast<double>(input.faces.size()));
  std::vector<Scaling> scalings;
  for (const WhittleKind& kind : whittle_kinds) {
    const auto has_kind = [&kind](const NamedPeer& peer) { return peer.name == kind.name; };
    if (std::none_of(peers.begin(), peers.end(), has_kind)) continue;
    scalings.push_back(measure_scaling(kind, input, n_wanted, rounds));
  }
  return scalings.empty() ? "" : to_text(scalings);
}

/// Whether a peer of ours gave an answer that doesn't count.
bool has_fault_of_ours(const std::vector<Row>& rows, const std::vector<NamedPeer>& peers) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (peers[i].peer->is_ours() && !rows[i].problem.empty()) return true;
  return false;
}

int run(const Options& options) {
  const std::vector<Case> cases = chosen_cases(options);
  const std::vector<NamedPeer> peers = chosen_peers(options);
  CsvFile csv(options.rows.csv, {options.run.rounds.clock, WHITTLE_BENCH_COMPILER, options.rows.commit});
  std::vector<Row> all_rows;
  bool is_right = true;
  for (const Case& chosen : cases) {
    std::cerr << "== " << chosen.name << std::endl;
    const IndexedMesh input = chosen.make();
    for (const double ratio : options.ratios) {
      const std::vector<Row> rows = run_case(chosen.name, input, ratio, peers, options.run);
      std::cout << to_text(rows) << std::endl;
      if (options.scaling) std::cout << scaling_text(input, ratio, peers, options.run.rounds.n) << std::endl;
      for (const Row& row : rows) csv.add(row);
      is_right = is_right && !has_fault_of_ours(rows, peers);
      all_rows.insert(all_rows.end(), rows.begin(), rows.end());
    }
  }
  std::cout << growth_text(all_rows);
  for (const std::size_t n_faces : options.efficiency) {
    std::cout << efficiency_text(n_faces, peers, options.run.samples, options.run.rounds) << std::endl;
  }
  if (!options.plots.empty())
    for (const auto& file : write_plots(options.plots, all_rows, options.run.rounds.clock))
      std::cout << "drawn: " << file.string() << '\n';
  if (!is_right) std::cerr << "error: an answer of Whittle's is wrong, see above\n";
  return is_right ? 0 : 1;
}

void set_up(CLI::App& app, Options& options) {
  app.add_option("--mesh", options.files, "a mesh file to decimate; can be given again")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--case", options.cases, "meshes made on the spot: " + case_names())
      ->type_name("NAME,...")
      ->delimiter(',');
  app.add_option("--subdivide", options.base,
                 "mesh file the loop-... cases are made from (default: the armadillo of the test meshes, else a knot)")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_flag("--permuted", options.permuted, "each mesh a second time, vertices and faces in random order");
  app.add_flag("--scaling", options.scaling,
               "our peers on one thread and on all, what only one can do, and a simulation of more threads");
  app.add_option("--efficiency", options.efficiency,
                 "errors over the least that N triangles can have, mean / rms / largest, on smooth surfaces with 100 "
                 "times as many faces")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(CLI::Range(10, 1'000'000));
  app.add_option("--seed", options.seed, "of that order")->type_name("N")->capture_default_str();
  app.add_option("--peers", options.peers,
                 "who takes part (default: all that are built in; whittle on 1, 2, 3, 8 threads)")
      ->type_name("NAME,...")
      ->delimiter(',');
  app.add_option("--ratio", options.ratios, "share of the faces to keep; several with commas")
      ->type_name("R,...")
      ->delimiter(',')
      ->check(CLI::Range(1e-6, 0.999))
      ->capture_default_str();
  add_options(app, options.run.rounds, "peers");
  app.add_option("--samples", options.run.samples, "points for the error, beside all vertices; 0: don't measure it")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--plot", options.plots, "draws time and error against faces, as SVG files in FOLDER")
      ->type_name("FOLDER");
  add_options(app, options.rows);
}

}  // namespace
}  // namespace whittle::bench

int main(int argc, char** argv) {
  using namespace whittle::bench;
  CLI::App app("Times Whittle's engine beside other decimaters.", "whittle_bench");
  Options options;
  set_up(app, options);
  return run_program(app, argc, argv, [&options] {
    if (options.files.empty() && options.cases.empty() && options.efficiency.empty()) options.cases = {all_cases};
    return run(options);
  });
}
