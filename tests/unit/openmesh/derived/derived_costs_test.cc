// Classes that users derive from our cost modules: what they override counts, in each decimater.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <whittle/engine/formula/edge_length_term.hh>

#include "derived.hh"

namespace whittle::test::derived {
namespace {

using Costs =
    testing::Types<ModGarlandHeckbertT<Mesh>, ModMemorylessT<Mesh>, ModLindstromTurkT<Mesh>, ModMidpointT<Mesh>>;
template <class ModuleT>
class DerivedCosts : public testing::Test {};
TYPED_TEST_SUITE(DerivedCosts, Costs);

TYPED_TEST(DerivedCosts, RefuseCollapsesInEachDecimater) { expect_region_kept_by_each_decimater<TypeParam>(true); }

void expect_same_runs(const Outcome& expected, const Outcome& run, const std::string& context) {
  expect_same_contractions(expected.contractions, run.contractions, context);
  EXPECT_EQ(run.result.stop, expected.result.stop) << context;
  EXPECT_EQ(run.result.max_cost, expected.result.max_cost) << context;
}

/// Meshes with borders, lines and vertices that are locked.
std::vector<Mesh> meshes() {
  std::vector<Mesh> result;
  for (const IndexedMesh& s : {shape(), noisy_grid(16, 16, 0.2, 9), bracket(4)}) {
    result.push_back(open_mesh<Mesh>(s));
    result.back().request_vertex_status();
    result.back().request_edge_status();
  }
  for (const OpenMesh::EdgeHandle e : result[1].edges()) {
    const auto [a, b] = ends(result[1], e);
    if (a / 17 == 8 && b / 17 == 8) result[1].status(e).set_feature(true);
  }
  for (const VertexHandle v : result[2].vertices()) result[2].status(v).set_locked(v.idx() % 7 == 0);
  return result;
}

TYPED_TEST(DerivedCosts, ThatReturnOurValuesChangeNothing) {
  const auto weigh = [](TypeParam& module) { module.set_valence_weight(0.5); };
  for (const Mesh& mesh : meshes()) {
    const auto far = DecimateTarget::as_far_as_possible();
    const Outcome expected = run<TypeParam>(mesh, far);
    EXPECT_GT(expected.contractions.size(), 50U);
    expect_same_runs(expected, run_by<TypeParam>(mesh, far, own_value), "as far as possible");
    expect_same_runs(run<TypeParam>(mesh, to_vertices(120), weigh),
                     run_by<TypeParam>(mesh, to_vertices(120), own_value, weigh), "valences");
    const double limit = expected.contractions[expected.contractions.size() / 2].cost;
    expect_same_runs(run<TypeParam>(mesh, DecimateTarget::max_cost(limit)),
                     run_by<TypeParam>(mesh, DecimateTarget::max_cost(limit), own_value), "limit as a target");
    const auto set_limit = [limit](TypeParam& module) { module.set_max_cost(limit); };
    expect_same_runs(run<TypeParam>(mesh, far, set_limit), run_by<TypeParam>(mesh, far, own_value, set_limit),
                     "limit of the module");
  }
}

TEST(DerivedCost, ThatReturnsOurValuesChangesNothingWithOptions) {
  using Module = ModGarlandHeckbertT<Mesh>;
  const std::vector<std::function<void(Module&)>> set_ups = {
      [](Module& m) { m.set_options({.placement = Placement::midpoint}); }, [](Module& m) { m.set_isotropy(0.4); }};
  for (const Mesh& mesh : meshes()) {
    for (const auto& set_up : set_ups) {
      expect_same_runs(run<Module>(mesh, to_vertices(100), set_up),
                       run_by<Module>(mesh, to_vertices(100), own_value, set_up), "options");
    }
  }
}

std::vector<std::array<Index, 2>> pairs_of(const Outcome& run) {
  std::vector<std::array<Index, 2>> pairs;
  for (const Contraction& made : run.contractions) pairs.push_back({made.removed, made.survivor});
  return pairs;
}

TEST(DerivedCost, ThatReturnsOurValuesChangesNothingWhereVerticesStay) {
  // Which vertex is taken as the first differs, and so does the last digit of costs.
  using Module = ModGarlandHeckbertT<Mesh>;
  const auto at_ends = [](Module& m) { m.set_options({.placement = Placement::endpoint}); };
  for (const Mesh& mesh : meshes()) {
    EXPECT_EQ(pairs_of(run<Module>(mesh, to_vertices(100), at_ends)),
              pairs_of(run_by<Module>(mesh, to_vertices(100), own_value, at_ends)));
  }
}

/// Another order of the pairs, which nothing changes.
float order_of(VertexHandle a, VertexHandle b) {
  const auto low = static_cast<unsigned>(std::min(a, b).idx());
  const auto high = static_cast<unsigned>(std::max(a, b).idx());
  return static_cast<float>((low * 2654435761U + high * 40503U) >> 12U);
}
const auto in_other_order = [](const Info& collapse, const std::function<float()>&) {
  return order_of(collapse.v0, collapse.v1);
};

/// The same order by another way: `evaluate` is overridden.
template <class ModuleT>
class ByOtherCost : public ModuleT {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ByOtherCost>;
  using ModuleT::evaluate;
  explicit ByOtherCost(Mesh& mesh) : ModuleT(mesh) {}
  PairEvaluation evaluate(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    PairEvaluation evaluation = ModuleT::evaluate(first, second, constraint);
    evaluation.cost = evaluation.bound = order_of(first, second);
    return evaluation;
  }
};

TEST(DerivedCost, RanksByItsValues) {
  for (const Mesh& mesh : meshes()) {
    const auto far = DecimateTarget::as_far_as_possible();
    const Outcome expected = run<ByOtherCost<ModMidpointT<Mesh>>>(mesh, far);
    const Outcome by_priority = run_by<ModMidpointT<Mesh>>(mesh, far, in_other_order);
    EXPECT_GT(expected.contractions.size(), 50U);
    EXPECT_EQ(pairs_of(by_priority), pairs_of(expected));
    for (const Contraction& made : by_priority.contractions) EXPECT_GT(made.cost, 0) << "lengths are told as costs";
  }
}

TEST(DerivedCost, RanksBesideOurValues) {
  // Half of the pairs cost twice as much, in a unit of which floats are a power.
  const auto dearer = [](const Info& collapse, const std::function<float()>& own) {
    return own() * (order_of(collapse.v0, collapse.v1) > 5e5F ? 2 : 1);
  };
  const Mesh mesh = open_mesh<Mesh>(shape());
  const Outcome run = run_by<ModLindstromTurkT<Mesh>>(mesh, to_vertices(100), dearer);
  double last = 0;
  for (const Contraction& made : run.contractions) {
    const bool is_dearer =
        order_of(VertexHandle(static_cast<int>(made.removed)), VertexHandle(static_cast<int>(made.survivor))) > 5e5F;
    const double rank = made.cost * (is_dearer ? 64 : 1);
    EXPECT_GT(rank, last / 1000) << "the order has nothing to do with the values";
    last = std::max(last, rank);
  }
  EXPECT_EQ(run.contractions.size(), 188U);
}

TYPED_TEST(DerivedCosts, MayAllowOneDirectionOnly) {
  const auto into_lower = [](const Info& collapse, const std::function<float()>& own) {
    return collapse.v1 < collapse.v0 ? own() : illegal;
  };
  for (const Mesh& mesh : meshes()) {
    const Outcome run = run_by<TypeParam>(mesh, to_vertices(150), into_lower);
    EXPECT_GT(run.contractions.size(), 20U) << mesh.n_vertices();
    for (const Contraction& made : run.contractions) EXPECT_GT(made.removed, made.survivor);
    ASSERT_EQ(run.refusals.size(), 1U);
  }
}

TEST(DerivedCost, OfVerticesAtTheirPlacesGoesInTheDirectionAllowed) {
  const auto into_lower = [](const Info& collapse, const std::function<float()>& own) {
    return collapse.v1 < collapse.v0 ? own() : illegal;
  };
  const IndexedMesh before = shape();
  const auto at_ends = [](ModGarlandHeckbertT<Mesh>& m) { m.set_options({.placement = Placement::endpoint}); };
  const Outcome run = run_by<ModGarlandHeckbertT<Mesh>>(open_mesh<Mesh>(before), to_vertices(150), into_lower, at_ends);
  EXPECT_EQ(run.contractions.size(), 138U);
  for (const Contraction& made : run.contractions) {
    EXPECT_GT(made.removed, made.survivor);
    EXPECT_EQ(made.position, before.positions[made.survivor]);
  }
}

TYPED_TEST(DerivedCosts, KeepTheLimitOfTheCostWhateverRanks) {
  const Mesh mesh = open_mesh<Mesh>(shape());
  const Outcome free = run<TypeParam>(mesh, to_vertices(150));
  const double limit = free.result.max_cost;
  const auto far = DecimateTarget::as_far_as_possible();
  const Outcome limited = run_by<TypeParam>(mesh, far, in_other_order, [=](TypeParam& m) { m.set_max_cost(limit); });
  EXPECT_GT(limited.contractions.size(), 30U);
  EXPECT_EQ(limited.result.stop, StopReason::cost);
  double most = 0;
  for (const Contraction& made : limited.contractions) most = std::max(most, made.cost);
  EXPECT_LE(most, limit);
  EXPECT_EQ(limited.result.max_cost, most);
}

/// An override that can't be named from outside.
class Hidden : public ModGarlandHeckbertT<Mesh> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<Hidden>;
  explicit Hidden(Mesh& mesh) : ModGarlandHeckbertT<Mesh>(mesh) {}

 private:
  float collapse_priority(const Info&) override { return illegal; }
};
class Overloaded : public ModGarlandHeckbertT<Mesh> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<Overloaded>;
  explicit Overloaded(Mesh& mesh) : ModGarlandHeckbertT<Mesh>(mesh) {}
  float collapse_priority(const Info&) override { return illegal; }
  float collapse_priority(int) const { return 1; }
};
class Inherited : public Overloaded {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<Inherited>;
  using Overloaded::Overloaded;
};

TEST(DerivedCost, HoweverItOverridesCounts) {
  const Mesh mesh = open_mesh<Mesh>(shape());
  const auto far = DecimateTarget::as_far_as_possible();
  EXPECT_EQ(run<Hidden>(mesh, far).result.n_contractions, 0U);
  EXPECT_EQ(run<Overloaded>(mesh, far).result.n_contractions, 0U);
  EXPECT_EQ(run<Inherited>(mesh, far).result.n_contractions, 0U);
}

/// Gives a cost that is none to all pairs in the region.
template <class ModuleT>
class WithoutCost : public ModuleT {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<WithoutCost>;
  using ModuleT::evaluate;
  explicit WithoutCost(Mesh& mesh) : ModuleT(mesh) {}
  PairEvaluation evaluate(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    PairEvaluation evaluation = ModuleT::evaluate(first, second, constraint);
    if (is_in_region(region, first) || is_in_region(region, second)) evaluation.cost = evaluation.bound = no_cost;
    return evaluation;
  }
  IndexedMesh region = shape();
  double no_cost = 0;
};
/// The same, said only when a place is settled.
template <class ModuleT>
class WithoutFinalCost : public ModuleT {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<WithoutFinalCost>;
  explicit WithoutFinalCost(Mesh& mesh) : ModuleT(mesh) {}
  double final_cost(VertexHandle first, VertexHandle second, const PairEvaluation& evaluation,
                    const Vec3& position) const override {
    if (is_in_region(region, first) || is_in_region(region, second)) return no_cost;
    return ModuleT::final_cost(first, second, evaluation, position);
  }
  IndexedMesh region = shape();
  double no_cost = 0;
};

template <class DecimaterT, class ModuleT>
void expect_kept_without_cost(double no_cost, const std::string& context) {
  const IndexedMesh before = shape();
  Mesh mesh = open_mesh<Mesh>(before);
  DecimaterT decimater(mesh);
  add_module<ModuleT>(decimater).no_cost = no_cost;
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(), 50U) << context;
  for (const VertexHandle v : mesh.all_vertices()) {
    if (!is_in_region(before, v)) continue;
    EXPECT_FALSE(mesh.status(v).deleted()) << context;
    EXPECT_EQ(to_vec3(mesh.point(v)), before.positions[static_cast<std::size_t>(v.idx())]) << context;
  }
  if constexpr (requires { decimater.result(); }) {
    EXPECT_EQ(decimater.result().stop, StopReason::exhausted) << context;
    EXPECT_EQ(decimater.module_refusals().size(), 1U) << context;
  }
}

TYPED_TEST(DerivedCosts, WithoutACostRefuse) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Stock = OpenMesh::Decimater::DecimaterT<Mesh>;
  using Pairs = PairDecimaterT<Mesh>;
  for (const double no_cost : {infinity, nan, -1.0}) {
    const std::string context = std::to_string(no_cost);
    expect_kept_without_cost<Stock, WithoutCost<TypeParam>>(no_cost, "stock, " + context);
    expect_kept_without_cost<Pairs, WithoutCost<TypeParam>>(no_cost, "pairs, " + context);
    expect_kept_without_cost<Stock, WithoutFinalCost<TypeParam>>(no_cost, "stock, " + context + " at last");
    expect_kept_without_cost<Pairs, WithoutFinalCost<TypeParam>>(no_cost, "pairs, " + context + " at last");
  }
}

TYPED_TEST(DerivedCosts, MustCallWhatTheyOverride) {
  expect_that_calls_are_missed<Forgetful<TypeParam, true>>();
  expect_that_calls_are_missed<Forgetful<TypeParam, false>>();
}

/// Garland–Heckbert reversed: the greatest cost comes first.
template <class MeshT>
class ModReversedT : public ModGarlandHeckbertT<MeshT> {
 public:
  explicit ModReversedT(MeshT& mesh) : ModGarlandHeckbertT<MeshT>(mesh) {}
  using Handle = OpenMesh::Decimater::ModHandleT<ModReversedT>;
  using ModGarlandHeckbertT<MeshT>::evaluate;

  PairEvaluation evaluate(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    PairEvaluation evaluation = ModGarlandHeckbertT<MeshT>::evaluate(first, second, constraint);
    evaluation.cost = evaluation.bound = 1 / (1 + evaluation.cost);
    return evaluation;
  }
};

/// A user's own cost: the length of the edge, placed at its middle, like ModMidpointT.
template <class MeshT>
class ModLengthT : public PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModLengthT, MeshT, Length);
  explicit ModLengthT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) {}
  double cost_dimension() const override { return 1; }

 private:
  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    return evaluate_midpoint(this->position(first), this->position(second), constraint);
  }
  Reach plain_reach() const override { return Reach::ends; }
};

/// The same, but a cost that is none to all pairs in the region, which stays none when valences are weighed.
template <class MeshT>
class ModLengthElsewhereT : public PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModLengthElsewhereT, MeshT, LengthElsewhere);
  explicit ModLengthElsewhereT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) { this->set_valence_weight(1); }
  double cost_dimension() const override { return 1; }
  IndexedMesh region = shape();
  double no_cost = 0;

 private:
  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    PairEvaluation evaluation = evaluate_midpoint(this->position(first), this->position(second), constraint);
    if (is_in_region(region, first) || is_in_region(region, second)) evaluation.cost = no_cost;
    return evaluation;
  }
  Reach plain_reach() const override { return Reach::ends; }
};

TEST(DerivedModules, WithoutACostRefuseWhenValencesAreWeighed) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double no_cost : {infinity, std::numeric_limits<double>::quiet_NaN(), -1.0, -1e-300}) {
    const std::string context = std::to_string(no_cost);
    using Module = ModLengthElsewhereT<Mesh>;
    expect_kept_without_cost<OpenMesh::Decimater::DecimaterT<Mesh>, Module>(no_cost, "stock, " + context);
    expect_kept_without_cost<PairDecimaterT<Mesh>, Module>(no_cost, "pairs, " + context);
  }
}

template <class ModuleT>
std::vector<Contraction> contractions_by(Mesh mesh, const DecimateTarget& target, Driver* driver = nullptr) {
  PairDecimaterT<Mesh> decimater(mesh);
  add_module<ModuleT>(decimater);
  std::vector<Contraction> result;
  decimater.set_listener([&](const Contraction& made) { result.push_back(made); });
  EXPECT_TRUE(decimater.initialize());
  decimater.decimate(target);
  if (driver != nullptr) *driver = decimater.last_driver();
  return result;
}

TEST(DerivedModules, WhatTheyOverrideCounts) {
  const Mesh mesh = open_mesh<Mesh>(noisy_torus(24, 12, 1, 0.4, 0.03, 3));
  Driver driver{};
  const auto reversed = contractions_by<ModReversedT<Mesh>>(mesh, to_faces(500), &driver);
  EXPECT_EQ(driver, Driver::mesh);
  ASSERT_FALSE(reversed.empty());
  const auto plain = contractions_by<ModGarlandHeckbertT<Mesh>>(mesh, to_faces(500));
  EXPECT_FALSE(same_bits(reversed.front(), plain.front()));
}

TEST(DerivedModules, ACostOfOnesOwnIsAskedAndNotTakenForQuadrics) {
  const Mesh mesh = open_mesh<Mesh>(noisy_torus(24, 12, 1, 0.4, 0.03, 3));
  Driver driver{};
  const auto own = contractions_by<ModLengthT<Mesh>>(mesh, to_faces(200), &driver);
  EXPECT_EQ(driver, Driver::mesh);
  expect_same_contractions(contractions_by<ModMidpointT<Mesh>>(mesh, to_faces(200)), own, "torus");
}

}  // namespace
}  // namespace whittle::test::derived
