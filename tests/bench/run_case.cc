#include "bench/run_case.hh"

#include <iostream>
#include <map>
#include <utility>

#include "bench/answer.hh"
#include "bench/results/statistics.hh"

namespace whittle::bench {
namespace {

/// Results of the peers' first runs, for those peers whose answer must equal another's.
using Answers = std::map<std::string, std::pair<IndexedMesh, Answer>>;

bool same_bytes(const IndexedMesh& a, const IndexedMesh& b) { return a.positions == b.positions && a.faces == b.faces; }

Answer judged_beside(const Answers& answers, const std::string& twin, const Question& question,
                     const IndexedMesh& mesh) {
  const auto it = answers.find(twin);
  if (it == answers.end()) return judged(question, mesh);
  if (same_bytes(it->second.first, mesh)) return it->second.second;
  Answer answer = judged(question, mesh);
  answer.problem = "not what " + twin + " gives";
  return answer;
}

void say_progress(const std::string& what) { std::cerr << "   " << what << std::endl; }

/// Everything except the rounds. `row.ms` holds the time of this run if the answer counts.
Row first_row(const NamedPeer& contender, const Question& question, const RunOptions& options, Answers& answers) {
  const auto& [name, peer] = contender;
  say_progress(name);
  Row row;
  row.peer = name;
  row.n_faces = question.input.faces.size();
  row.n_wanted = question.n_faces;
  FirstRun run = first_run(*peer, question.input, question.n_faces, options.rounds.clock, options.rounds.limit_s);
  row.problem = run.failure;
  if (run.peak_bytes) row.peak_bytes_per_face = static_cast<double>(*run.peak_bytes) / static_cast<double>(row.n_faces);
  if (!run.answer) return row;
  row.answer = judged_beside(answers, peer->twin(), question, *run.answer);
  row.problem = row.answer->problem;
  if (row.problem.empty() && peer->is_ours()) row.problem = row.answer->defect;
  if (row.problem.empty()) row.ms = {run.ms};
  if (peer->twin().empty() && peer->is_ours()) answers[name] = {std::move(*run.answer), *row.answer};
  return row;
}

void time_in_rounds(std::vector<Row>& rows, const std::vector<NamedPeer>& peers, const IndexedMesh& input,
                    const RunOptions& options) {
  std::vector<const Peer*> timed;
  std::vector<Row*> timed_rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].ms.empty() || rows[i].ms.front() > 1e3 * options.rounds.slow_s) continue;
    timed.push_back(peers[i].peer.get());
    timed_rows.push_back(&rows[i]);
  }
  if (timed.empty()) return;
  say_progress(std::to_string(options.rounds.n) + " rounds");
  auto times = time_interleaved(timed, input, rows.front().n_wanted, options.rounds.clock, options.rounds.n);
  for (std::size_t i = 0; i < timed.size(); ++i) timed_rows[i]->ms = std::move(times[i]);
}

std::optional<double> ratio_to(const std::string& name, const Row& row, const std::vector<Row>& rows) {
  for (const Row& other : rows)
    if (other.peer == name && !other.ms.empty() && !row.ms.empty()) return median_ratio(row.ms, other.ms);
  return std::nullopt;
}

}  // namespace

std::vector<Row> run_case(const std::string& mesh_name, const IndexedMesh& input, double ratio,
                          const std::vector<NamedPeer>& peers, const RunOptions& options) {
  const auto n_wanted = static_cast<std::size_t>(ratio * static_cast<double>(input.faces.size()));
  const Question question = make_question(input, n_wanted, options.samples);
  std::vector<Row> rows;
  Answers answers;
  for (const NamedPeer& contender : peers) {
    rows.push_back(first_row(contender, question, options, answers));
    rows.back().mesh = mesh_name;
  }
  answers.clear();
  time_in_rounds(rows, peers, input, options);
  for (Row& row : rows) {
    row.ratio_to_meshoptimizer = ratio_to("meshoptimizer", row, rows);
    row.ratio_to_whittle = ratio_to("whittle", row, rows);
  }
  return rows;
}

}  // namespace whittle::bench
