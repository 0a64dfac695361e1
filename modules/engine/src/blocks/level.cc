#include "blocks/level.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "blocks/ladder.hh"
#include "blocks/shared_stars.hh"
#include "blocks/stitch.hh"
#include "loop/contraction_log.hh"
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

class Level {
 public:
  Level(const LevelContext& context, const LevelPlan& plan, const LevelRemainder* before)
      : context_(context),
        plan_(plan),
        before_(before),
        surface_(before ? Surface{before->positions, Frame{}, before->faces}
                        : Surface{context.input.positions, context.frame, context.input.faces}),
        partition_(make_partition(surface_, plan.faces_per_block, plan.first_share, context.options.threads)),
        areas_(areas()),
        jobs_(partition_.n_blocks()) {}

  LevelRemainder run(const LevelGoal& goal, CostState cost_state);
  double find_cost(double surplus, const CostState& cost_state);

 private:
  unsigned threads() const { return context_.options.threads; }
  double share() const {
    const auto n_input = static_cast<double>(context_.input.faces.size());
    return std::min(1.0, context_.target_share * n_input / static_cast<double>(surface_.faces.size()));
  }
  std::vector<std::size_t> choose_sample(std::size_t every) const;
  std::vector<std::size_t> largest_first_of_others() const;
  std::vector<std::uint8_t> locked() const;
  std::vector<Index> areas() const;
  std::span<const GuardedPair> refusals() const {
    return before_ ? std::span(before_->refusals) : std::span<const GuardedPair>();
  }
  DecimateTarget least_left(const Block& block, std::size_t number) const;
  void begin(std::size_t number, const CostState& cost_state);
  void finish(std::size_t number);
  double climb(const std::vector<std::size_t>& sample, double surplus, const CostState& cost_state);
  bool is_futile(const LevelGoal& goal, const CostState& cost_state);
  void begin_log();
  std::span<Contraction> log_of(std::size_t number);
  void tell();
  void sum_up(LevelRemainder& remainder);

  const LevelContext& context_;
  LevelPlan plan_;
  const LevelRemainder* before_;
  Surface surface_;
  Partition partition_;
  std::vector<std::uint8_t> locked_;
  std::vector<Index> areas_;                ///< of the surface's faces, or empty
  std::vector<std::unique_ptr<Job>> jobs_;  ///< a block each; null where it was not begun
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

std::vector<Index> Level::areas() const {
  const std::span<const Index> of_input = context_.areas;
  if (of_input.empty() || before_ == nullptr) return {of_input.begin(), of_input.end()};
  std::vector<Index> here;
  for (const Index f : before_->face_origins) here.push_back(of_input[f]);
  return here;
}

std::vector<std::uint8_t> Level::locked() const {
  const std::vector<std::uint8_t>& locked = context_.options.locked;
  return before_ ? before_->of_vertices(locked) : locked;
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

void Level::begin(std::size_t number, const CostState& cost_state) {
  auto job = std::make_unique<Job>();
  job->options = context_.options;
  job->options.threads = 1;
  job->options.locked = {};
  job->options.progress = [&progress = context_.progress, is_trial = plan_.is_trial,
                           last = std::optional<std::uint64_t>{}](const Progress& p) mutable {
    const std::uint64_t n_gone = last.value_or(p.n_faces) - p.n_faces;
    last = p.n_faces;
    return progress.advance(is_trial ? 0 : n_gone);
  };
  job->options.listener = {};
  LoopContext context;
  context.role = plan_.role;
  context.refusals = refusals();
  context.areas.of = areas_;
  context.displacement_limit = context_.displacement_limit;
  if (!log_.empty()) {
    job->log.end = log_.data() + first_in_log_[number];
    context.log = &job->log;
  }
  job->block.emplace(surface_, partition_, number, locked_, cost_state, job->options, context);
  if (!before_) nonmanifold_[number] = job->block->count_nonmanifold();
  job->block->start(least_left(*job->block, number), context_.frame);
  jobs_[number] = std::move(job);
}

void Level::finish(std::size_t number) {
  Job& job = *jobs_[number];
  for (Contraction& contraction : log_of(number)) {
    for (Index* const v : {&contraction.survivor, &contraction.removed}) *v = job.block->number_of(*v);
  }
  tell_by_input(context_.input.positions, context_.frame, before_ ? before_->origins : std::vector<Index>{},
                log_of(number));
  job.block->finish(results_);
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
void Level::tell() {
  std::vector<std::span<const Contraction>> logs;
  for (std::size_t number = 0; number < jobs_.size(); ++number) logs.push_back(log_of(number));
  std::vector<Contraction> told;
  std::vector<Contraction>& all = context_.steps != nullptr ? context_.steps->contractions : told;
  const std::size_t n_before = all.size();
  add_by_cost(logs, all);
  if (context_.options.listener) {
    for (std::size_t i = n_before; i < all.size(); ++i) context_.options.listener(all[i]);
  }
  if (context_.steps != nullptr) end_pass(*context_.steps);
}

/// Finds the cost that leaves as many of the sample's inner vertices as wanted, and runs the sample up to it.
double Level::climb(const std::vector<std::size_t>& sample, double surplus, const CostState& cost_state) {
  for_each_block(sample.size(), threads(), [&](std::size_t i) { begin(sample[i], cost_state); });
  const auto sum = [&](auto n_of) {
    return std::accumulate(sample.begin(), sample.end(), 0.0, [&](double so_far, std::size_t number) {
      return so_far + static_cast<double>(n_of(*jobs_[number]->block));
    });
  };
  const double goal = sum([](const Block& block) { return block.n_inner_vertices(); }) * share() * surplus;
  CostLadder ladder(cost_state.face_area->first());
  double n_left = 0;
  do {
    for_each_block(sample.size(), threads(), [&](std::size_t i) { jobs_[sample[i]]->block->run(ladder.cost()); });
    n_left = sum([](const Block& block) { return block.n_inner_vertices_left(); });
  } while (!context_.progress.is_cancelled() && ladder.climb(n_left / goal));
  return ladder.cost();
}

void Level::sum_up(LevelRemainder& remainder) {
  DecimateResult& total = remainder.result;
  if (before_) {
    total = before_->result;
    remainder.nonmanifold = before_->nonmanifold;
  }
  for (const auto& job : jobs_) {
    if (!job) continue;
    const DecimateResult& one = job->block->result();
    total.n_contractions += one.n_contractions;
    total.max_cost = std::max(total.max_cost, one.max_cost);
    total.n_degenerate_faces += one.n_degenerate_faces;
    total.n_coincident_faces += one.n_coincident_faces;
    total.refusals += one.refusals;
  }
  for (const NonmanifoldCounts& counts : nonmanifold_) {
    remainder.nonmanifold.edges += counts.edges;
    remainder.nonmanifold.vertices += counts.vertices;
  }
}

/// Runs two blocks. \return whether their pairs wait for each other so that too little can be done: on some regular
/// meshes the exact order goes from one end to the other.
bool Level::is_futile(const LevelGoal& goal, const CostState& cost_state) {
  const std::array<std::size_t, 2> tried{jobs_.size() / 4, 3 * jobs_.size() / 4};
  for_each_block(tried.front() == tried.back() ? 1 : 2, threads(), [&](std::size_t i) {
    begin(tried[i], cost_state);
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

double Level::find_cost(double surplus, const CostState& cost_state) {
  locked_ = locked();
  nonmanifold_.resize(jobs_.size());
  return climb(choose_sample(16), surplus, cost_state);
}

LevelRemainder Level::run(const LevelGoal& goal, CostState cost_state) {
  results_.merged_into.resize(surface_.positions.size());
  std::iota(results_.merged_into.begin(), results_.merged_into.end(), Index{0});
  results_.is_face_left.assign(surface_.faces.size(), 1);
  locked_ = locked();
  if (context_.is_told()) begin_log();
  if (!before_) nonmanifold_.resize(jobs_.size() + 1);
  // In the exact order blocks have to know what pairs with a shared vertex cost at least.
  std::optional<SharedStars> shared_stars;
  if (!before_ && plan_.role == Role::in_exact_order) {
    shared_stars.emplace(surface_, partition_);
    cost_state.quadrics = shared_stars->quadrics(context_.options);
  }

  LevelRemainder remainder;
  remainder.cost_state.face_area = cost_state.face_area;
  if (goal.cost) {
    remainder.cost_limit = *goal.cost;
  } else {
    const std::vector<std::size_t> sample = choose_sample(8);
    remainder.cost_limit = climb(sample, goal.surplus, cost_state);
    for_each_block(sample.size(), threads(), [&](std::size_t i) { finish(sample[i]); });
  }
  if (goal.least_done > 0 && is_futile(goal, cost_state) && !context_.progress.is_cancelled()) {
    remainder.is_futile = true;
    return remainder;
  }
  const std::vector<std::size_t> others = largest_first_of_others();
  for_each_block(others.size() + 1, threads(), [&](std::size_t i) {
    if (context_.progress.is_cancelled()) return;
    if (i == 0) {
      if (before_) return;
      if (!shared_stars) shared_stars.emplace(surface_, partition_);
      nonmanifold_.back() = shared_stars->count_nonmanifold();
      return;
    }
    const std::size_t number = others[i - 1];
    begin(number, cost_state);
    jobs_[number]->block->run(remainder.cost_limit);
    finish(number);
  });
  std::vector<const Block*> blocks;
  for (const auto& job : jobs_) {
    if (job) blocks.push_back(&*job->block);
  }
  stitch(surface_, partition_, blocks, results_, cost_state, before_, threads(), remainder);
  if (!log_.empty()) tell();
  sum_up(remainder);
  return remainder;
}

}  // namespace

double find_cost(const LevelContext& context, const LevelPlan& plan, double surplus, const CostState& cost_state) {
  return Level(context, plan, nullptr).find_cost(surplus, cost_state);
}

LevelRemainder run_level(const LevelContext& context, const LevelPlan& plan, const LevelGoal& goal,
                         CostState cost_state, const LevelRemainder* before) {
  return Level(context, plan, before).run(goal, std::move(cost_state));
}

}  // namespace whittle
