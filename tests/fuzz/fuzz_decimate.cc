#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "decimate/run.hh"
#include "fuzz/check/decimation.hh"
#include "fuzz/check/promise.hh"
#include "fuzz/decode/decimate_bytes.hh"
#include "fuzz/decode/mesh_bytes.hh"
#include "fuzz/targets.hh"
#include "oracle/brute_force.hh"
#include "support/transforms.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/engine/attributes.hh"

namespace whittle::test {
namespace {

/// Runs the case. \param made is given what the listener is told
Decimation run(const DecimateCase& c, std::vector<Contraction>* made = nullptr) {
  DecimateOptions options = c.options;
  if (made != nullptr) options.listener = [made](const Contraction& contraction) { made->push_back(contraction); };
  unsigned n_calls = 0;
  if (c.n_calls_left) options.progress = [&](const Progress&) { return n_calls++ < *c.n_calls_left; };
  return decimate(c.mesh, c.target, options);
}

/// Some thousands of copies side by side: enough for loops to be shared among threads.
DecimateCase many_copies(const DecimateCase& c) {
  constexpr std::size_t n_faces = 20'000;
  DecimateCase many = c;
  const double step = 1.5 * diagonal(c.mesh);
  const std::size_t n_copies = n_faces / c.mesh.faces.size();
  const auto n_along = static_cast<std::size_t>(std::sqrt(static_cast<double>(n_copies)));
  many.mesh = {};
  many.options.locked.clear();
  many.options.feature_edges.clear();
  many.options.tolerances.clear();
  for (std::size_t i = 0; i < n_copies; ++i) {
    const auto first = static_cast<Index>(many.mesh.positions.size());
    const Vec3 offset(static_cast<double>(i % n_along) * step, static_cast<double>(i / n_along) * step, 0);
    for (const Vec3& p : c.mesh.positions) many.mesh.positions.push_back(p + offset);
    for (const auto& [x, y, z] : c.mesh.faces) many.mesh.faces.push_back({x + first, y + first, z + first});
    const std::vector<std::uint8_t>& locked = c.options.locked;
    many.options.locked.insert(many.options.locked.end(), locked.begin(), locked.end());
    const std::vector<double>& tolerances = c.options.tolerances;
    many.options.tolerances.insert(many.options.tolerances.end(), tolerances.begin(), tolerances.end());
    for (const auto& [a, b] : c.options.feature_edges) many.options.feature_edges.push_back({a + first, b + first});
  }
  return many;
}

void check_threads(const DecimateCase& c, std::uint64_t hash) {
  constexpr const char* promise = "no result depends on the number of threads";
  DecimateCase three = c;
  if (hash % 64 == 1) {
    three.options.threads = 3;
    check_same(run(c), run(three), promise);
  }
  const bool has_many_pairs = c.options.pairs.threshold > 0;
  const double size = diagonal(c.mesh);
  if (hash % 2048 != 2 || has_many_pairs || c.mesh.faces.empty() || !(size > 1e-100 && size < 1e100)) return;
  const DecimateCase one = many_copies(c);
  three = one;
  three.options.threads = 3;
  check_same(run(one), run(three), promise);
}

/// In units larger by a power of two all is the same to the bit.
void check_unit(const DecimateCase& c, const Decimation& d) {
  const double size = diagonal(c.mesh);
  if (!(size > 1e-50 && size < 1e50) || c.target.cost_limit()) return;
  constexpr double factor = 1024;
  DecimateCase larger = c;
  larger.mesh = scaled(c.mesh, factor);
  if (larger.options.pairs.threshold) *larger.options.pairs.threshold *= factor;
  if (c.target.error_limit()) {
    larger.target = c.target.or_max_error(factor * *c.target.error_limit(), factor * *c.target.border_error_limit());
  }
  for (double& tolerance : larger.options.tolerances) tolerance *= factor;
  Decimation other = run(larger);
  for (Vec3& p : other.mesh.positions) p /= factor;
  other.result.max_cost = d.result.max_cost;
  check_same(d, other, "no result depends on the unit");
}

double median_edge(const IndexedMesh& mesh) {
  std::vector<double> lengths{0};
  for (const auto& [a, b, c] : mesh.faces) lengths.push_back((mesh.positions[b] - mesh.positions[a]).norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Whether rounding may have put one contraction before the other. A cost of regularization ε alone, on flat ground or
/// along a straight border, is a share ε of its terms: it is known to about 1e-16 / ε of itself. So is the lower bound
/// under which a pair waits for its turn. No cost is known better than to the rounding of its terms, with faces as
/// large as the mesh. Equal costs above that go by vertex numbers, and costs without bounds are compared as they are.
bool is_tie(const DecimateOptions& options, double size, const Contraction& made, const Contraction& expected) {
  const bool has_bounds =
      options.effective_cost() == Cost::quadric && !(options.isotropy > 0) && !(options.valence_weight > 0);
  if (!has_bounds) return false;
  const double terms = std::pow(size, options.quadric.weights == Weights::uniform ? 2 : 4);
  if (made.cost <= 1e-15 * terms) return true;
  const double rounding = 1e-15 / options.quadric.regularization;
  return made.cost > expected.cost && made.cost - expected.cost <= rounding * made.cost;
}

/// Contractions in exact order are those of the definition. Not without regularization, where rounding decides, nor
/// where the definition has no guard: that against intersections. After a tie that goes otherwise nothing is compared.
void check_order(const DecimateCase& c, const std::vector<Contraction>& made) {
  const DecimateOptions& options = c.options;
  const bool is_exact = options.effective_order() == Order::exact;
  const bool has_features = options.feature_angle_deg || !options.feature_edges.empty();
  const double size = diagonal(c.mesh);
  // Beside one vertex far away rounding decides. A face that is r times as long as the others has costs that are known
  // to about 1e-16 r³ of the others', so that old costs are no lower bounds any more.
  const bool is_far_flung = size > 1e5 * median_edge(c.mesh);
  if (!is_exact || has_features || options.refuse_intersections || is_far_flung || c.n_calls_left ||
      c.target.cost_limit() || c.target.error_limit() || c.mesh.positions.empty() || c.mesh.faces.size() > 40 ||
      options.quadric.regularization < 1e-9 || !(size > 1e-50 && size < 1e50)) {
    return;
  }
  const std::vector<Contraction> expected = BruteForceDecimater(c.mesh, options).run(c.target);
  for (std::size_t i = 0; i < std::min(made.size(), expected.size()); ++i) {
    const bool is_same = made[i].survivor == expected[i].survivor && made[i].removed == expected[i].removed;
    if (!is_same && is_tie(options, size, made[i], expected[i])) return;
    require(is_same, "contractions are those of brute force");
    require(made[i].position == expected[i].position && made[i].cost == expected[i].cost,
            "contractions go where brute force goes");
  }
  require(made.size() == expected.size(), "there are as many contractions as by brute force");
}

/// In exact order blocks give what one pass gives.
void check_blocks_in_exact_order(DecimateCase c, const BlockPlan& plan) {
  if (c.n_calls_left) return;
  c.options.threads = 2;
  if (!why_not_in_blocks(c.mesh, c.target, c.options, nullptr, plan, false).empty()) return;
  Decimation in_blocks = whittle::run(c.mesh, c.target, c.options, nullptr, plan);
  break_normals(Frame::of_points(c.mesh.positions), c.options.normals, c.options.crease_angle_deg, in_blocks.mesh);
  check_same(run(c), in_blocks, "blocks keep the exact order");
}

/// What goes in blocks keeps all promises in blocks of a few faces.
void check_blocks(DecimateCase c) {
  constexpr BlockPlan plan{.fewest_faces = 1,
                           .fewest_faces_in_detail = 1,
                           .fewest_faces_again = 1,
                           .faces_per_block = 8,
                           .fewest_faces_left = 1,
                           .fewest_faces_left_before_rounds = 1,
                           .surplus = 1,
                           .fewest_faces_in_exact_order = 1,
                           .fewest_faces_again_in_exact_order = 1,
                           .faces_per_block_in_exact_order = {24, 16},
                           .least_done_in_exact_order = 0};
  if (!fronts_of_backs(c.mesh).empty()) return;  // `decimate` gives `run` one side alone
  if (is_exact_in_blocks(c.options)) return check_blocks_in_exact_order(c, plan);
  if (!why_not_in_blocks(c.mesh, c.target, c.options, nullptr, plan, false).empty()) return;
  std::vector<Contraction> made;
  unsigned n_calls = 0;
  if (c.n_calls_left) c.options.progress = [&](const Progress&) { return n_calls++ < *c.n_calls_left; };
  c.options.listener = [&](const Contraction& contraction) { made.push_back(contraction); };
  c.options.threads = 1;
  const Decimation one = whittle::run(c.mesh, c.target, c.options, nullptr, plan);
  check_decimation(c, one, made);
  if (c.n_calls_left) return;
  c.options.threads = 3;
  check_same(one, whittle::run(c.mesh, c.target, c.options, nullptr, plan),
             "no result depends on the number of threads");
}

void check_index_only(const DecimateCase& c) {
  if (c.target.error_limit()) return;  // positions of the result decide
  if (!cost_traits(c.options.effective_cost()).why_not.placement.empty()) return;
  DecimateCase at_ends = c;
  at_ends.options.quadric.placement = Placement::endpoint;
  at_ends.mesh.origins.clear();
  const Decimation d = run(at_ends);
  const IndexOnlyDecimation small = decimate_index_only(c.mesh, c.target, c.options);
  if (c.n_calls_left) return;
  require(small.faces.size() == d.mesh.faces.size(), "decimation by indices is that at end points");
  for (std::size_t f = 0; f < small.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      require(small.faces[f][i] == d.mesh.origins[d.mesh.faces[f][i]], "decimation by indices is that at end points");
    }
  }
}

void check(const DecimateCase& c, std::uint64_t hash) {
  std::vector<Contraction> made;
  Decimation d;
  try {
    d = run(c, &made);
  } catch (const std::invalid_argument&) {
    require(!is_valid(c), "what is documented is taken");
    return;
  }
  require(is_valid(c), "what is not documented is refused");
  try {
    check_decimation(c, d, made);
  } catch (const BrokenPromise& error) {
    throw BrokenPromise(error.what() + std::string("\nresult ") + text_of(d.mesh));
  }
  check_blocks(c);
  check_threads(c, hash);
  if (hash % 8 == 3) check_unit(c, d);
  if (hash % 32 == 4) check_order(c, made);
  if (hash % 8 == 5) check_index_only(c);
}

}  // namespace

void fuzz_decimate(std::string_view bytes) {
  ByteSource source(bytes);
  const DecimateCase c = decode_decimate_case(source);
  try {
    check(c, hash_of(bytes));
  } catch (const std::exception& error) {
    throw BrokenPromise(error.what() + std::string("\n") + text_of(c));
  }
}

}  // namespace whittle::test
