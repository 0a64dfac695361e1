#include "whittle/progressive/levels.hh"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "whittle/engine/detail/bisect.hh"
#include "whittle/engine/two_sided_sheets.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/progressive/replay.hh"

namespace whittle::progressive {
namespace {

void check(const std::vector<double>& errors) {
  const auto is_length = [](double error) { return error > 0 && std::isfinite(error); };
  if (errors.empty() || !std::all_of(errors.begin(), errors.end(), is_length) ||
      !std::is_sorted(errors.begin(), errors.end())) {
    throw std::invalid_argument("levels_within: errors are lengths above 0, ascending");
  }
}

class LevelSearch {
 public:
  LevelSearch(const IndexedMesh& mesh, Replay& replay, const SimplifyOptions& options, const LevelProof& is_within)
      : mesh_(mesh), replay_(replay), options_(options), is_within_(is_within) {}

  ProvenLevel find(double error);

 private:
  bool is_within(double error, const Decimation& level) const {
    return !level.mesh.faces.empty() && is_within_(level, error);
  }
  Decimation level_after(std::size_t n_contractions) {
    replay_.go_to(replay_.level_after(n_contractions));
    return replay_.decimation();
  }

  const IndexedMesh& mesh_;
  Replay& replay_;
  const SimplifyOptions& options_;
  const LevelProof& is_within_;
  std::size_t least_ = 0;  ///< contractions that keep within the error before
};

/// The last of the levels that bisection finds to be within the error.
ProvenLevel LevelSearch::find(double error) {
  constexpr std::size_t accuracy = 200;  // of the faces, two a contraction
  Decimation found = level_after(least_);
  const auto gap = [&found] { return std::max<std::size_t>(1, found.mesh.faces.size() / accuracy); };
  const auto holds = [&](std::size_t n_contractions) {
    Decimation level = level_after(n_contractions);
    if (!is_within(error, level)) return false;
    found = std::move(level);
    return true;
  };
  least_ = whittle::detail::bisect(least_, replay_.steps().contractions.size() + 1, gap, holds);
  if (least_ == 0 && !is_within(error, found)) {
    std::ostringstream text;
    text << "not even all faces of the input, as they are written, are proven to be within " << error;
    throw std::runtime_error(text.str());
  }
  ProvenLevel level{{std::move(found), *options_.decimate.cost, {}, 0, 0}, error};
  Decimation polished = level;
  const PolishResult polish = polish_decimation(mesh_, options_, polished);
  if (polish.n_passes > 0 && is_within(error, polished)) {
    static_cast<Decimation&>(level) = std::move(polished);
    level.polish = polish;
  }
  fit_attributes_of(mesh_, options_, level);
  return level;
}

/// \pre `mesh` has no two-sided sheets
std::vector<ProvenLevel> levels_of_surface(const IndexedMesh& mesh, const std::vector<double>& errors, Effort effort,
                                           const SimplifyOptions& options, const LevelProof& is_within) {
  const auto last = DecimateTarget::faces(1);
  SimplifyOptions settled = with_effort(effort, options, mesh, last);
  settled.decimate.keep_steps = true;
  Decimation run = decimate(mesh, last, settled.decimate);
  std::vector<ProvenLevel> levels;
  if (run.result.stop == StopReason::cancelled) return levels;
  Replay replay(mesh, std::move(run.steps), settled.decimate.normals);
  LevelSearch search(mesh, replay, settled, is_within);
  for (const double error : errors) levels.push_back(search.find(error));
  return levels;
}

std::vector<ProvenLevel> levels_of_sheets(const TwoSidedSheets& sheets, const std::vector<double>& errors,
                                          Effort effort, const SimplifyOptions& options, const LevelProof& is_within) {
  const auto add_backs = [&](Decimation& level) {
    sheets.add_backs(options.decimate.normals, options.decimate.threads, level);
  };
  const auto is_within_with_backs = [&](const Decimation& level, double distance) {
    Decimation both = level;
    add_backs(both);
    return is_within(both, distance);
  };
  SimplifyOptions own = options;
  own.decimate = sheets.options_without_backs(options.decimate);
  std::vector<ProvenLevel> levels =
      levels_of_surface(sheets.without_backs(), errors, effort, own, is_within_with_backs);
  for (ProvenLevel& level : levels) add_backs(level);
  return levels;
}

}  // namespace

std::vector<ProvenLevel> levels_within(const IndexedMesh& mesh, const std::vector<double>& errors, Effort effort,
                                       const SimplifyOptions& options, const LevelProof& is_within) {
  check(errors);
  const auto is_level_within = [&](const Decimation& level, double distance) {
    const metrics::CertifyOptions how{.threads = options.decimate.threads, .vertex_map = level.vertex_map};
    return metrics::certify(mesh, level.mesh, distance, how).verdict == Verdict::proven;
  };
  const LevelProof proof = is_within ? is_within : is_level_within;
  if (const TwoSidedSheets sheets(mesh, options.decimate.threads); sheets.any()) {
    return levels_of_sheets(sheets, errors, effort, options, proof);
  }
  return levels_of_surface(mesh, errors, effort, options, proof);
}

}  // namespace whittle::progressive
