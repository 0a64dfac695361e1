#include "bench/scaling.hh"

#include <algorithm>
#include <numeric>
#include <queue>

#include "bench/results/csv.hh"
#include "bench/results/statistics.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/cores.hh"
#include "whittle/core/detail/section_trace.hh"

namespace whittle::bench {
namespace {

using Sections = std::vector<detail::SectionTrace::Section>;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// When the last of some threads has done the last block, if each takes the next one when it has done one.
double seconds_on(const std::vector<double>& blocks, unsigned n_threads) {
  std::priority_queue<double, std::vector<double>, std::greater<>> ends{std::greater<>(),
                                                                        std::vector<double>(n_threads)};
  double last = 0;
  for (const double block : blocks) {
    const double end = ends.top() + block;
    ends.pop();
    ends.push(end);
    last = std::max(last, end);
  }
  return last;
}

/// \param ms wall-clock time of the run with these sections
double serial_seconds(double ms, const Sections& sections) {
  double seconds = ms / 1e3;
  for (const auto& section : sections) seconds -= section.seconds;
  return std::max(0.0, seconds);
}

/// One round.
struct Sample {
  double ms_on_one, ms_on_all, cpu_ms_on_all, serial_share;
  std::vector<double> simulated;
};

Sample measure_once(const Peer& on_one, const Peer& on_all, const IndexedMesh& input, std::size_t n_faces) {
  Sample sample{};
  Meter one;
  on_one.decimate(input, n_faces, one);
  sample.ms_on_one = one.wall_ms();
  Meter all;
  const detail::SectionTrace trace;
  on_all.decimate(input, n_faces, all);
  sample.ms_on_all = all.wall_ms();
  sample.cpu_ms_on_all = all.cpu_ms();
  const double serial = serial_seconds(sample.ms_on_all, trace.sections());
  const auto total = [&](auto seconds_of) {
    double seconds = serial;
    for (const auto& section : trace.sections()) seconds += seconds_of(section.blocks);
    return seconds;
  };
  sample.serial_share = serial / total(sum);
  for (const unsigned n : simulated_threads) {
    const double seconds = total([n](const std::vector<double>& blocks) { return seconds_on(blocks, n); });
    sample.simulated.push_back(sample.ms_on_one / 1e3 / seconds);
  }
  return sample;
}

}  // namespace

Scaling measure_scaling(const WhittleKind& kind, const IndexedMesh& input, std::size_t n_faces, int rounds) {
  const auto on_one = make_whittle(kind, 1);
  const auto on_all = make_whittle(kind, detail::n_cores());
  std::vector<Sample> samples;
  for (int round = 0; round <= rounds; ++round) {
    samples.push_back(measure_once(*on_one, *on_all, input, n_faces));
    if (round == 0) samples.clear();  // on cold memory
  }
  const auto median = [&](auto value_of) {
    std::vector<double> values;
    for (const Sample& sample : samples) values.push_back(value_of(sample));
    return spread_of(values).median;
  };
  Scaling scaling{.peer = std::string(kind.name),
                  .ms_on_one = median([](const Sample& s) { return s.ms_on_one; }),
                  .ms_on_all = median([](const Sample& s) { return s.ms_on_all; }),
                  .cpu_ms_on_all = median([](const Sample& s) { return s.cpu_ms_on_all; }),
                  .serial_share = median([](const Sample& s) { return s.serial_share; }),
                  .simulated = {}};
  for (std::size_t i = 0; i < std::size(simulated_threads); ++i) {
    scaling.simulated.push_back(median([i](const Sample& s) { return s.simulated[i]; }));
  }
  return scaling;
}

std::string to_text(const std::vector<Scaling>& scalings) {
  const std::string all = std::to_string(detail::n_cores());
  app::Table table;
  std::vector<std::string> head{"scaling", "ms on 1", "on " + all, "CPU on " + all, all + " over 1", "serial share"};
  for (const unsigned n : simulated_threads) head.push_back("simulated " + std::to_string(n));
  table.add(head);
  for (const Scaling& s : scalings) {
    std::vector<std::string> row{s.peer,
                                 formatted("%.1f", s.ms_on_one),
                                 formatted("%.1f", s.ms_on_all),
                                 formatted("%.1f", s.cpu_ms_on_all),
                                 formatted("%.2f", s.ms_on_all / s.ms_on_one),
                                 formatted("%.1f %%", 100 * s.serial_share)};
    for (const double times : s.simulated) row.push_back(formatted("%.1fx", times));
    table.add(row);
  }
  return table.text();
}

}  // namespace whittle::bench
