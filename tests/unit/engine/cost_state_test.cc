#include "cost/cost_state.hh"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "complex/constraints.hh"
#include "cost/make_cost.hh"
#include "support/shapes/shapes.hh"
#include "whittle/engine/cost_traits.hh"

namespace whittle::test {
namespace {

/// A cost of which someone forgot what a stage leaves.
class ForgetfulCost : public PairCost {
 public:
  void rank(std::span<const Pair> /*pairs*/, std::span<PairEvaluation> /*ranks*/, double /*enough*/) const override {}
  Reach affects() const override { return Reach::none; }
  void merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& /*change*/) override {}
  void start(CostState&& /*before*/, unsigned /*threads*/) override {}
  Quadric quadric(Index /*v*/) const override { return {}; }
};
static_assert(std::is_abstract_v<ForgetfulCost>, "a cost that forgets its state must not compile");

/// A cost at the start of a stage.
struct Stage {
  Stage(const IndexedMesh& mesh, const DecimateOptions& options, CostState before)
      : complex(mesh.positions, mesh.faces, Frame{}, 1), cost(make_cost(complex, constraints, options, false)) {
    complex.connect({}, 1);
    cost->start(std::move(before), 1);
  }

  TriangleComplex complex;
  Constraints constraints;
  std::unique_ptr<PairCost> cost;
};

/// Planes that no face tells.
Quadric planes(double weight) {
  Quadric quadric;
  quadric.a = {weight, 0, 0, weight, 0, weight};
  return quadric;
}

/// By all that a cost says of a vertex.
std::vector<double> numbers(const Quadric& q) {
  return {q.a.xx, q.a.xy, q.a.xz, q.a.yy, q.a.yz, q.a.zz, q.b.x(), q.b.y(), q.b.z(), q.c};
}

TEST(CostState, LeavesWhatTheNextStageStartsFrom) {
  const IndexedMesh mesh = noisy_grid(6, 6, 0.2, 1);
  for (const CostTraits& traits : all_cost_traits) {
    SCOPED_TRACE(std::string(traits.name));
    DecimateOptions options;
    options.cost = traits.cost;
    CostState before;
    for (Index v = 0; v < mesh.positions.size(); v += 5) before.seams.push_back({v, planes(1 + v)});
    const Stage first(mesh, options, before);
    const std::vector<Index> vertices = first.complex.vertices_by_origin();
    const Stage second(mesh, options, first.cost->state(vertices));
    const Stage without(mesh, options, {});
    bool is_told = false;
    for (const Index v : vertices) {
      EXPECT_EQ(numbers(second.cost->quadric(v)), numbers(first.cost->quadric(v))) << v;
      is_told = is_told || numbers(without.cost->quadric(v)) != numbers(first.cost->quadric(v));
    }
    EXPECT_EQ(is_told, traits.cost == Cost::quadric || traits.cost == Cost::memoryless);
    EXPECT_EQ(second.cost->state(vertices).quadrics.size(), first.cost->state(vertices).quadrics.size());
    EXPECT_EQ(second.cost->state(vertices).seams.size(), first.cost->state(vertices).seams.size());
  }
}

TEST(CostState, TakesQuadricsOfFacesAsTheyAreGiven) {
  const IndexedMesh mesh = noisy_grid(6, 6, 0.2, 1);
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    DecimateOptions options;
    options.cost = cost;
    CostState before;
    before.face_area = MeanFaceArea(1, 1, mesh.faces.size());
    for (Index v = 0; v < mesh.positions.size(); ++v) before.faces.push_back({v, planes(1 + v)});
    const Stage stage(mesh, options, before);
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_EQ(numbers(stage.cost->quadric(v)), numbers(planes(1 + stage.complex.origin(v))));
    }
  }
}

TEST(CostState, GoesWithVerticesThatMove) {
  CostState state;
  state.quadrics = {{1, planes(3)}};
  const std::vector<Vec3> before{Vec3::Zero(), Vec3::Zero()};
  const std::vector<Vec3> after{Vec3::Zero(), Vec3(0.5, 0, 0)};
  state.move_origins(before, after);
  EXPECT_EQ(state.quadrics.front().quadric(Vec3(-0.5, 0, 0)), 0) << "where the vertex was";
  EXPECT_EQ(state.quadrics.front().quadric(Vec3::Zero()), 0.75);
}

}  // namespace
}  // namespace whittle::test
