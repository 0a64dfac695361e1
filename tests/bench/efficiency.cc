#include "bench/efficiency.hh"

#include <iostream>

#include "bench/measure.hh"
#include "bench/results/csv.hh"
#include "bench/smooth_surfaces.hh"
#include "terminal/table.hh"

namespace whittle::bench {
namespace {

constexpr std::size_t faces_in_per_face_out = 100;

/// "1.321 / 1.287 / 2.86": mean, root mean square and largest error over the least ones. \param least of one face
std::string cell(const FirstRun& run, const SmoothSurface& surface, const Errors& least, std::size_t n_samples) {
  if (!run.answer) return run.failure;
  const auto n_faces = static_cast<double>(run.answer->faces.size());
  const Errors errors = errors_of(*run.answer, surface, n_samples);
  return formatted("%.3f", n_faces * errors.mean / least.mean) + " / " +
         formatted("%.3f", n_faces * errors.rms / least.rms) + " / " +
         formatted("%.2f", n_faces * errors.max / least.max);
}

}  // namespace

std::string efficiency_text(std::size_t n_faces, const std::vector<NamedPeer>& peers, std::size_t n_samples,
                            const Rounds& rounds) {
  std::vector<std::vector<std::string>> rows{{std::to_string(n_faces) + " faces"}};
  for (const NamedPeer& peer : peers) rows.push_back({peer.name});
  for (const SmoothSurface& surface : smooth_surfaces()) {
    std::cerr << "== " << surface.name << " to " << n_faces << " faces" << std::endl;
    rows.front().push_back(surface.name);
    const Errors least = least_errors(surface);
    const IndexedMesh input = surface.mesh(faces_in_per_face_out * n_faces);
    for (std::size_t i = 0; i < peers.size(); ++i) {
      const FirstRun run = first_run(*peers[i].peer, input, n_faces, rounds.clock, rounds.limit_s);
      rows[i + 1].push_back(cell(run, surface, least, n_samples));
    }
  }
  app::Table table;
  for (std::vector<std::string>& row : rows) table.add(std::move(row));
  return table.text();
}

}  // namespace whittle::bench
