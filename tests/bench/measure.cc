#include "bench/measure.hh"

#include <cstring>
#include <exception>
#include <span>
#include <string_view>

#include "bench/processes/forked.hh"

namespace whittle::bench {
namespace {

double ms_of(const Meter& meter, Clock clock) { return clock == Clock::wall ? meter.wall_ms() : meter.cpu_ms(); }

template <class T>
void append(std::string& bytes, std::span<const T> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

/// Fills `values` from the front of `bytes` and removes that part.
template <class T>
void take(std::string_view& bytes, std::span<T> values) {
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size_bytes());
  bytes.remove_prefix(values.size_bytes());
}

/// The header that the forked process sends. The positions and the faces follow.
struct Header {
  double ms;
  std::uint64_t has_peak;
  std::uint64_t peak_bytes;
  std::uint64_t n_positions;
  std::uint64_t n_faces;
};

std::string run_once(const Peer& peer, const IndexedMesh& input, std::size_t n_faces, Clock clock) {
  Meter meter(Meter::Memory::watched);
  const IndexedMesh answer = peer.decimate(input, n_faces, meter);
  const Header header{ms_of(meter, clock), meter.peak_bytes().has_value(), meter.peak_bytes().value_or(0),
                      answer.positions.size(), answer.faces.size()};
  std::string bytes;
  append(bytes, std::span(&header, 1));
  append(bytes, std::span(answer.positions));
  append(bytes, std::span(answer.faces));
  return bytes;
}

std::string run_rounds(const std::vector<const Peer*>& peers, const IndexedMesh& input, std::size_t n_faces,
                       Clock clock, int rounds) {
  std::vector<double> times;
  for (int round = 0; round <= rounds; ++round) {
    for (const Peer* peer : peers) {
      Meter meter;
      peer->decimate(input, n_faces, meter);
      if (round > 0) times.push_back(ms_of(meter, clock));
    }
  }
  std::string bytes;
  append(bytes, std::span<const double>(times));
  return bytes;
}

}  // namespace

FirstRun first_run(const Peer& peer, const IndexedMesh& input, std::size_t n_faces, Clock clock, double limit_s) {
  FirstRun run;
  std::string bytes;
  try {
    bytes = run_forked([&] { return run_once(peer, input, n_faces, clock); }, limit_s);
  } catch (const std::exception& error) {
    run.failure = error.what();
    return run;
  }
  std::string_view left = bytes;
  Header header{};
  take(left, std::span(&header, 1));
  run.ms = header.ms;
  if (header.has_peak != 0) run.peak_bytes = header.peak_bytes;
  run.answer.emplace();
  run.answer->positions.resize(header.n_positions);
  run.answer->faces.resize(header.n_faces);
  take(left, std::span(run.answer->positions));
  take(left, std::span(run.answer->faces));
  return run;
}

std::vector<std::vector<double>> time_interleaved(const std::vector<const Peer*>& peers, const IndexedMesh& input,
                                                  std::size_t n_faces, Clock clock, int rounds) {
  constexpr double no_limit_s = 1e6;  // each peer has kept to the limit in its first run
  const std::string bytes = run_forked([&] { return run_rounds(peers, input, n_faces, clock, rounds); }, no_limit_s);
  std::string_view left = bytes;
  std::vector<std::vector<double>> times(peers.size());
  while (!left.empty()) {
    for (std::vector<double>& of_peer : times) take(left, std::span(&of_peer.emplace_back(), 1));
  }
  return times;
}

}  // namespace whittle::bench
