#include "blocks/level.hh"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>

#include "blocks/ladder.hh"
#include "blocks/shared_stars.hh"
#include "blocks/stitch.hh"
#include "loop/contraction_log.hh"
#include "loop/surface_of_faces.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

/// A block, and what goes with it.
struct Job {
  DecimateOptions options;  ///< of the block alone
  std::optional<Block> block;
  ContractionLog log;  ///< if contractions are told
};

/// Large rounds, as long as much is left to do; then smaller ones, which keep nearer to the order of cost. At last
/// hardly any pairs matter.
RoundSize size_of_round(std::uint64_t n_wanted, std::size_t n_left) {
  constexpr std::uint64_t fewest = 16;
  const double share_wanted = static_cast<double>(n_wanted) / static_cast<double>(n_left);
  const auto size = [&](double share, double slack) {
    const auto most = static_cast<std::uint64_t>(share * static_cast<double>(n_left));
    return RoundSize{std::min(n_wanted, std::max(fewest, most)), slack};
  };
  if (share_wanted > 0.6) return size(share_of_large_round, slack_of_large_round);
  return share_wanted > 0.02 ? size(0.15, 1.3) : size(1, 3);
}

class Level {
 public:
  Level(const LevelContext& context, const LevelPlan& plan, WorkingSurface& surface)
      : context_(context),
        plan_(plan),
        surface_(surface),
        partition_(make_partition(surface, plan.faces_per_block, plan.first_share, context.stage.options.threads)),
        locked_(surface.of_vertices(context.stage.options.locked)),
        areas_(surface.of_faces(std::vector<Index>(context.stage.areas.of.begin(), context.stage.areas.of.end()))),
        jobs_(partition_.n_blocks()),
        done_(partition_.n_blocks()),
        nonmanifold_(surface.is_input() ? jobs_.size() + 1 : 0) {
    context_.progress.set_surface([this] { return surface_now(); });
  }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
  ~Level() { context_.progress.set_surface({}); }

  std::optional<double> run(const LevelGoal& goal, StageReport& report);
  /// \pre there is one block, and it goes in rounds
  void contract_as_one(const DecimateTarget& target, StageReport& report);
  void begin(const std::vector<std::size_t>& sample);
  /// Finds the cost that leaves as many of the sample's inner vertices as wanted, and runs the sample up to it.
  /// \pre the sample has begun
  double climb(const std::vector<std::size_t>& sample, double surplus);
  std::vector<std::size_t> choose_sample(std::size_t every) const;

 private:
  struct Round {
    std::uint64_t n_turns;
    float cost;  ///< that might have been
  };
  double climb_in_rounds(const std::vector<std::size_t>& sample, double goal);
  Round contract_in_step(const std::vector<std::size_t>& blocks, const RoundSize& size);
  std::size_t n_inner_vertices_left(const std::vector<std::size_t>& blocks) const;
  void begin_results();
  void end(StageReport& report);
  const DecimateOptions& options() const { return context_.stage.options; }
  unsigned threads() const { return options().threads; }
  bool is_told() const { return context_.stage.keeps_steps || options().listener; }
  double share() const {
    const auto n_input = static_cast<double>(context_.input.faces.size());
    return std::min(1.0, context_.target_share * n_input / static_cast<double>(surface_.faces.size()));
  }
  std::vector<std::size_t> largest_first_of_others() const;
  DecimateTarget least_left(const Block& block, std::size_t number) const;
  void begin(std::size_t number);
  void finish(std::size_t number);
  IndexedMesh surface_now() const;
  bool is_futile(const LevelGoal& goal);
  double n_nonmanifold(const std::vector<std::size_t>& sample) const;
  void run_others(double cost, std::optional<SharedStars>& shared_stars);
  void begin_log();
  std::span<Contraction> log_of(std::size_t number);
  void tell(StageReport& report);
  void sum_up(DecimateResult& total) const;

  const LevelContext& context_;
  LevelPlan plan_;
  WorkingSurface& surface_;
  Partition partition_;
  std::vector<std::uint8_t> locked_;
  std::vector<Index> areas_;  ///< of the surface's faces, or empty
  RoundScratchPool scratch_;
  std::vector<std::unique_ptr<Job>> jobs_;       ///< a block each; null where it was not begun
  std::vector<std::atomic<const Block*>> done_;  ///< blocks that have finished; else null
  std::vector<NonmanifoldCounts> nonmanifold_;
  BlockResults results_;
  LargeArray<Contraction> log_;  ///< if contractions are told: those of each block
  std::vector<std::size_t> first_in_log_;
};

/// Every eighth block, or so, spread evenly; at least eight.
std::vector<std::size_t> Level::choose_sample(std::size_t every) const {
  const std::size_t n = std::min(jobs_.size(), std::max<std::size_t>(8, jobs_.size() / every));
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < n; ++i) sample.push_back((2 * i + 1) * jobs_.size() / (2 * n));
  return sample;
}

/// The blocks not begun yet. Large ones come first, so that no thread begins one when the others have ended.
std::vector<std::size_t> Level::largest_first_of_others() const {
  std::vector<std::size_t> others;
  for (std::size_t number = 0; number < jobs_.size(); ++number) {
    if (!jobs_[number]) others.push_back(number);
  }
  const auto size = [this](std::size_t number) { return partition_.faces.of(number).size(); };
  std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  return others;
}

/// The target's share of the block's faces, and of its vertices that aren't frozen: so that all blocks together don't
/// pass the target. A contraction takes two faces, one of them perhaps below the share.
DecimateTarget Level::least_left(const Block& block, std::size_t number) const {
  const auto part_of = [this](std::size_t n) {
    return static_cast<std::uint64_t>(std::ceil(share() * static_cast<double>(n)));
  };
  return DecimateTarget::faces(part_of(partition_.faces.of(number).size()) + 1)
      .or_vertices(block.n_frozen_vertices() + part_of(block.n_inner_vertices()));
}

void Level::begin(std::size_t number) {
  auto job = std::make_unique<Job>();
  job->options = options();
  job->options.threads = jobs_.size() > 1 ? 1 : threads();  // of several blocks each has a thread
  job->options.locked = {};
  job->options.progress = [&progress = context_.progress, is_trial = plan_.is_trial, is_all = jobs_.size() == 1,
                           last = std::optional<std::uint64_t>{}](const Progress& p) mutable {
    const std::uint64_t n_gone = last.value_or(p.n_faces) - p.n_faces;
    last = p.n_faces;
    return progress.advance(is_trial ? 0 : n_gone, is_all && !is_trial ? &p.surface : nullptr);
  };
  job->options.listener = {};
  StageContext context{job->options, context_.stage.frame};
  context.limits = context_.stage.limits;
  context.role = plan_.role;
  context.locked = locked_;
  context.areas.of = areas_;
  if (!log_.empty()) {
    job->log.end = log_.data() + first_in_log_[number];
    context.log = &job->log;
  }
  job->block.emplace(surface_, partition_, number, context, scratch_);
  if (!nonmanifold_.empty()) nonmanifold_[number] = job->block->count_nonmanifold();
  job->block->start(least_left(*job->block, number));
  jobs_[number] = std::move(job);
}

void Level::finish(std::size_t number) {
  Job& job = *jobs_[number];
  for (Contraction& contraction : log_of(number)) {
    for (Index* const v : {&contraction.survivor, &contraction.removed}) *v = job.block->number_of(*v);
  }
  tell_by_input(context_.input.positions, context_.stage.frame, surface_.origins, log_of(number));
  job.block->finish(results_);
  done_[number].store(&*job.block, std::memory_order_release);
}

/// What blocks that are done have left, and the others as they were. Other blocks may be at work.
IndexedMesh Level::surface_now() const {
  std::vector<Vec3> points;
  reserve_large(points, surface_.positions.size());
  for (const Vec3& position : surface_.positions) points.push_back(surface_.frame.to_frame(position));
  std::vector<Triangle> faces;
  for (std::size_t number = 0; number < done_.size(); ++number) {
    const Block* const block = done_[number].load(std::memory_order_acquire);
    for (const Index f : partition_.faces.of(number)) {
      if (block == nullptr) {
        faces.push_back(surface_.faces[f]);
      } else if (results_.is_face_left[f] != 0) {
        faces.push_back(mapped(surface_.faces[f], results_.merged_into));
      }
    }
    if (block == nullptr) continue;
    for (const Block::Survivor& survivor : block->survivors()) points[survivor.vertex] = survivor.position;
  }
  const Frame& frame = context_.stage.frame;
  return surface_of_faces(std::move(faces), points.size(), [&](Index v) { return frame.to_model(points[v]); });
}

/// Makes room in the log: a block makes fewer contractions than it has vertices.
void Level::begin_log() {
  first_in_log_.push_back(0);
  for (std::size_t number = 0; number < jobs_.size(); ++number) {
    first_in_log_.push_back(first_in_log_.back() + partition_.vertices.of(number).size());
  }
  log_.resize(first_in_log_.back());
}

/// What a block has done so far.
std::span<Contraction> Level::log_of(std::size_t number) {
  if (log_.empty() || !jobs_[number]) return {};
  return {log_.data() + first_in_log_[number], jobs_[number]->log.end};
}

/// Tells what all blocks have done, in the order of cost.
void Level::tell(StageReport& report) {
  std::vector<std::span<const Contraction>> logs;
  for (std::size_t number = 0; number < jobs_.size(); ++number) logs.push_back(log_of(number));
  std::vector<Contraction> told;
  std::vector<Contraction>& all = context_.stage.keeps_steps ? report.steps.contractions : told;
  const std::size_t n_before = all.size();
  add_by_cost(logs, all);
  if (options().listener) {
    for (std::size_t i = n_before; i < all.size(); ++i) options().listener(all[i]);
  }
  if (context_.stage.keeps_steps) end_pass(report.steps);
}

void Level::begin(const std::vector<std::size_t>& sample) {
  for_each_block(sample.size(), threads(), [&](std::size_t i) { begin(sample[i]); });
}

double Level::climb(const std::vector<std::size_t>& sample, double surplus) {
  const auto sum = [&](auto n_of) {
    return std::accumulate(sample.begin(), sample.end(), 0.0, [&](double so_far, std::size_t number) {
      return so_far + static_cast<double>(n_of(*jobs_[number]->block));
    });
  };
  const double goal = sum([](const Block& block) { return block.n_inner_vertices(); }) * share() * surplus;
  if (jobs_[sample.front()]->block->rounds() != nullptr) return climb_in_rounds(sample, goal);
  CostLadder ladder(surface_.cost_state.face_area->first());
  double n_left = 0;
  do {
    for_each_block(sample.size(), threads(), [&](std::size_t i) { jobs_[sample[i]]->block->run(ladder.cost()); });
    n_left = sum([](const Block& block) { return block.n_inner_vertices_left(); });
  } while (!context_.progress.is_cancelled() && ladder.climb(n_left / goal));
  return ladder.cost();
}

/// All blocks of the sample in step. \param goal number of inner vertices that are to be left
/// \return the highest cost of a round
double Level::climb_in_rounds(const std::vector<std::size_t>& sample, double goal) {
  constexpr double share = share_of_large_round;
  constexpr double enough = 1.02;
  float cost = 0;
  while (!context_.progress.is_cancelled()) {
    const auto n_left = static_cast<double>(n_inner_vertices_left(sample));
    if (n_left <= enough * goal) break;
    // Of the pairs that cost least about half can be contracted, so the last rounds are of a cost that leaves enough.
    const bool is_last = n_left - goal < share * n_left;
    const double n_pairs = is_last ? 2.2 * (n_left - goal) : share * n_left;
    const RoundSize size{static_cast<std::uint64_t>(n_pairs), is_last ? 1 : slack_of_large_round};
    const Round round = contract_in_step(sample, size);
    cost = std::max(cost, round.cost);
    if (round.n_turns == 0) break;
  }
  return cost;
}

/// A round. \pre the blocks have begun
Level::Round Level::contract_in_step(const std::vector<std::size_t>& blocks, const RoundSize& size) {
  const auto rounds_of = [&](std::size_t i) -> Rounds& { return *jobs_[blocks[i]]->block->rounds(); };
  for_each_block(blocks.size(), threads(), [&](std::size_t i) { rounds_of(i).begin_round(); });
  std::vector<const CostCounts*> counts;
  for (std::size_t i = 0; i < blocks.size(); ++i) counts.push_back(&rounds_of(i).cost_counts());
  const std::vector<RoundLimit> limits = limits_of_parts(counts, size);
  std::vector<std::uint64_t> n_turns(blocks.size());
  for_each_block(blocks.size(), threads(), [&](std::size_t i) { n_turns[i] = rounds_of(i).contract(limits[i]); });
  return {std::accumulate(n_turns.begin(), n_turns.end(), std::uint64_t{0}), limits.front().cost};
}

std::size_t Level::n_inner_vertices_left(const std::vector<std::size_t>& blocks) const {
  return std::accumulate(blocks.begin(), blocks.end(), std::size_t{0}, [this](std::size_t n, std::size_t number) {
    return n + jobs_[number]->block->n_inner_vertices_left();
  });
}

/// How many contractions the target asks for at least. One takes two faces at most.
std::uint64_t n_wanted(const Rounds& rounds, const DecimateTarget& target) {
  const std::uint64_t n_vertices = rounds.n_vertices();
  const std::uint64_t n_faces = rounds.n_faces();
  std::uint64_t wanted = n_vertices;
  if (target.n_vertices()) wanted = std::min(wanted, n_vertices - std::min(n_vertices, *target.n_vertices()));
  if (target.n_faces()) wanted = std::min(wanted, (n_faces - std::min(n_faces, *target.n_faces()) + 1) / 2);
  return wanted;
}

void Level::contract_as_one(const DecimateTarget& target, StageReport& report) {
  begin_results();
  begin(0);
  if (!nonmanifold_.empty()) nonmanifold_.back() = {};  // no vertex is shared
  Block& block = *jobs_.front()->block;
  Rounds& rounds = *block.rounds();
  rounds.start(target);
  while (const std::uint64_t wanted = n_wanted(rounds, target)) {
    rounds.begin_round();
    const CostCounts* const counts = &rounds.cost_counts();
    const RoundSize size = size_of_round(wanted, block.n_inner_vertices_left());
    if (rounds.contract(limits_of_parts({&counts, 1}, size).front()) == 0) break;
    if (context_.progress.is_cancelled()) break;
  }
  finish(0);
  end(report);
}

/// \pre the surface is what is left
void Level::sum_up(DecimateResult& total) const {
  for (const auto& job : jobs_) {
    if (job) total += job->block->result();
  }
  total.n_vertices = surface_.positions.size();
  total.n_faces = surface_.faces.size();
  total.refused_at_end = {};
  for (const NonmanifoldCounts& counts : nonmanifold_) total.before += {0, counts.edges, counts.vertices};
}

/// Runs two blocks. \return whether their pairs wait for each other so that too little can be done: on some regular
/// meshes the exact order goes from one end to the other.
bool Level::is_futile(const LevelGoal& goal) {
  const std::array<std::size_t, 2> tried{jobs_.size() / 4, 3 * jobs_.size() / 4};
  for_each_block(tried.front() == tried.back() ? 1 : 2, threads(), [&](std::size_t i) {
    begin(tried[i]);
    jobs_[tried[i]]->block->run(*goal.cost);
    finish(tried[i]);
  });
  double done = 0;
  double wanted = 0;
  for (const auto& job : jobs_) {
    if (!job) continue;
    done += static_cast<double>(job->block->result().n_contractions);
    wanted += (1 - share()) * static_cast<double>(job->block->n_inner_vertices());
  }
  return done < goal.least_done * wanted;
}

/// About how many edges and vertices of the input aren't manifold. \pre the sample has begun
double Level::n_nonmanifold(const std::vector<std::size_t>& sample) const {
  std::uint64_t n = 0;
  for (const std::size_t number : sample) n += nonmanifold_[number].edges + nonmanifold_[number].vertices;
  return static_cast<double>(n) * static_cast<double>(jobs_.size()) / static_cast<double>(sample.size());
}

void Level::run_others(double cost, std::optional<SharedStars>& shared_stars) {
  const std::vector<std::size_t> others = largest_first_of_others();
  for_each_block(others.size() + 1, threads(), [&](std::size_t i) {
    if (context_.progress.is_cancelled()) return;
    if (i == 0) {
      if (nonmanifold_.empty()) return;
      if (!shared_stars) shared_stars.emplace(surface_, partition_);
      nonmanifold_.back() = shared_stars->count_nonmanifold();
      return;
    }
    const std::size_t number = others[i - 1];
    begin(number);
    jobs_[number]->block->run(cost);
    finish(number);
  });
}

void Level::begin_results() {
  results_.merged_into.resize(surface_.positions.size());
  std::iota(results_.merged_into.begin(), results_.merged_into.end(), Index{0});
  results_.is_face_left.assign(surface_.faces.size(), 1);
  if (is_told()) begin_log();
}

/// Puts together what blocks have left.
void Level::end(StageReport& report) {
  std::vector<const Block*> blocks;
  for (const auto& job : jobs_) {
    if (job) blocks.push_back(&*job->block);
  }
  surface_ = stitch(surface_, partition_, blocks, results_, threads());
  if (!log_.empty()) tell(report);
  sum_up(report.result);
}

std::optional<double> Level::run(const LevelGoal& goal, StageReport& report) {
  begin_results();
  // In the exact order blocks have to know what pairs with a shared vertex cost at least.
  std::optional<SharedStars> shared_stars;
  if (surface_.is_input() && plan_.role == Role::in_exact_order) {
    shared_stars.emplace(surface_, partition_);
    surface_.cost_state.quadrics = shared_stars->quadrics(options());
  }
  std::optional<double> cost = goal.cost;
  if (!cost) {
    const std::vector<std::size_t> sample = choose_sample(8);
    begin(sample);
    if (n_nonmanifold(sample) > goal.most_nonmanifold) return std::nullopt;
    cost = climb(sample, goal.surplus);
    for_each_block(sample.size(), threads(), [&](std::size_t i) { finish(sample[i]); });
  }
  if (goal.least_done > 0 && is_futile(goal) && !context_.progress.is_cancelled()) return std::nullopt;
  run_others(*cost, shared_stars);
  end(report);
  return cost;
}

}  // namespace

double find_cost(const LevelContext& context, const LevelPlan& plan, double surplus, WorkingSurface& surface) {
  Level level(context, plan, surface);
  const std::vector<std::size_t> sample = level.choose_sample(16);
  level.begin(sample);
  return level.climb(sample, surplus);
}

std::optional<double> run_level(const LevelContext& context, const LevelPlan& plan, const LevelGoal& goal,
                                WorkingSurface& surface, StageReport& report) {
  return Level(context, plan, surface).run(goal, report);
}

void contract_in_rounds(const LevelContext& context, const DecimateTarget& target, WorkingSurface& surface,
                        StageReport& report) {
  const LevelPlan all{surface.faces.size(), 0.5, Role::alone};
  Level(context, all, surface).contract_as_one(target, report);
}

}  // namespace whittle
