#include "whittle/engine/detail/without_backs.hh"

#include <algorithm>
#include <limits>

#include "decimate/run.hh"

namespace whittle::detail {
namespace {

/// When vertices become one in a run: the number of contractions made by then.
class MergeTimes {
 public:
  MergeTimes(std::size_t n_vertices, const std::vector<Contraction>& contractions)
      : survivor_(n_vertices), removed_after_(n_vertices, never) {
    for (std::size_t i = 0; i < contractions.size(); ++i) {
      survivor_[contractions[i].removed] = contractions[i].survivor;
      removed_after_[contractions[i].removed] = i + 1;
    }
  }

  /// When two corners of a face become one; a number above all others if they don't.
  std::size_t of(const Triangle& face) const {
    return std::min({of(face[0], face[1]), of(face[1], face[2]), of(face[2], face[0])});
  }

 private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  std::size_t of(Index a, Index b) const {
    std::size_t time = 0;
    while (a != b && time != never) {
      if (removed_after_[a] > removed_after_[b]) std::swap(a, b);
      time = removed_after_[a];
      if (time != never) a = survivor_[a];
    }
    return time;
  }

  std::vector<Index> survivor_;
  std::vector<std::size_t> removed_after_;
};

/// How many faces are left in the course of a run.
struct Counts {
  std::vector<std::uint64_t> without_backs;  ///< by number of contractions
  std::vector<std::uint64_t> with_backs;
};

/// Those of a run that is made to find out.
DecimateOptions options_of_rehearsal(DecimateOptions options) {
  options.keep_steps = true;
  options.keep_quadrics = false;
  options.pauses = {};
  options.tolerances.clear();
  if (options.progress) {
    options.progress = [callback = options.progress](Progress progress) {
      progress.fraction = 0;
      return callback(progress);
    };
  }
  return options;
}

/// None if the run joins faces: then some vanish without two corners becoming one.
std::optional<Counts> counts_of_run(const TwoSidedSheets& sheets, std::uint64_t least, const DecimateOptions& options) {
  const IndexedMesh& mesh = sheets.without_backs();
  const Decimation rehearsed = run(mesh, DecimateTarget::faces(least), options, nullptr, {});
  const auto joins_faces = [](const Contraction& contraction) { return contraction.joins_faces; };
  if (std::ranges::any_of(rehearsed.steps.contractions, joins_faces)) return std::nullopt;
  const std::size_t n = rehearsed.steps.contractions.size();
  const MergeTimes times(mesh.positions.size(), rehearsed.steps.contractions);
  Counts counts{std::vector<std::uint64_t>(n + 1), std::vector<std::uint64_t>(n + 1)};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh.faces[f])) continue;
    const std::size_t last = std::min(n + 1, times.of(mesh.faces[f])) - 1;
    counts.without_backs[last] += 1;
    counts.with_backs[last] += sheets.has_back(f) ? 2 : 1;
  }
  for (std::size_t i = n; i-- > 0;) {
    counts.without_backs[i] += counts.without_backs[i + 1];
    counts.with_backs[i] += counts.with_backs[i + 1];
  }
  return counts;
}

std::uint64_t count_at(const Counts& counts, std::uint64_t n_with_backs) {
  const auto found = std::partition_point(counts.with_backs.begin(), counts.with_backs.end(),
                                          [n_with_backs](std::uint64_t n) { return n > n_with_backs; });
  if (found == counts.with_backs.end()) return n_with_backs / 2;  // it leaves no more with backs, in any case
  return counts.without_backs[static_cast<std::size_t>(found - counts.with_backs.begin())];
}

/// The same by runs: from above, as a face less without backs is two less at most.
std::uint64_t count_by_runs(const TwoSidedSheets& sheets, std::uint64_t n_with_backs, const DecimateOptions& options) {
  const IndexedMesh& mesh = sheets.without_backs();
  const auto asked = DecimateTarget::faces(n_with_backs);
  auto own = DecimateTarget::faces(std::min<std::uint64_t>(n_with_backs, mesh.faces.size()));
  for (;;) {
    const Decimation rehearsed = run(mesh, own, options, nullptr, {});
    const auto lower = lower_target_without_backs(sheets, asked, own, rehearsed.face_origins);
    if (!lower || rehearsed.result.stop != StopReason::target) return *own.n_faces();
    own = *lower;
  }
}

}  // namespace

std::vector<DecimateTarget> targets_without_backs(const TwoSidedSheets& sheets,
                                                  const std::vector<DecimateTarget>& targets, DecimateOptions options) {
  const std::size_t n_without_backs = sheets.without_backs().faces.size();
  const bool has_others = sheets.mesh().faces.size() < 2 * n_without_backs;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const DecimateTarget& target : targets) least = std::min(least, target.n_faces().value_or(least));
  options = options_of_rehearsal(std::move(options));
  std::optional<Counts> counts;
  if (has_others && least < sheets.mesh().faces.size()) counts = counts_of_run(sheets, least / 2, options);
  std::vector<DecimateTarget> own = targets;
  for (DecimateTarget& target : own) {
    if (!target.n_faces()) continue;
    const std::uint64_t n = *target.n_faces();
    if (n >= sheets.mesh().faces.size()) {
      target = target.or_faces(n_without_backs);
    } else if (!has_others) {
      target = target.or_faces(n / 2);
    } else {
      target = target.or_faces(counts ? count_at(*counts, n) : count_by_runs(sheets, n, options));
    }
  }
  return own;
}

std::optional<DecimateTarget> lower_target_without_backs(const TwoSidedSheets& sheets, const DecimateTarget& asked,
                                                         const DecimateTarget& tried,
                                                         const std::vector<Index>& face_origins) {
  if (!asked.n_faces() || *tried.n_faces() <= *asked.n_faces() / 2) return std::nullopt;
  const std::uint64_t n = sheets.n_faces_with_backs(face_origins);
  if (n <= *asked.n_faces()) return std::nullopt;
  const std::uint64_t surplus = (n - *asked.n_faces() + 1) / 2;  // of faces with backs, which are two each
  return tried.or_faces(std::max(*asked.n_faces() / 2, *tried.n_faces() - std::min(surplus, *tried.n_faces())));
}

}  // namespace whittle::detail
