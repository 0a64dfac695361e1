// Hosts that take part in a decimation, without a mesh of OpenMesh.
#include "whittle/engine/host.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"

namespace whittle::test {
namespace {

/// Made up from the numbers of a pair: a whole number, so that sums of it are exact. At most 400,000.
double made_up(Index first, Index second) {
  return 1 + static_cast<double>((first * std::uint64_t{7919} + second * std::uint64_t{104'729}) % 400'000);
}

/// Merges at the middle, at a cost that is made up. A contraction makes all others dearer by `rise`. The final cost is
/// `factor` times the rank.
class MadeUpHost : public DecimationHost, public HostedCost {
 public:
  explicit MadeUpHost(const IndexedMesh& mesh, double rise = 0, double factor = 1)
      : rise_(rise), factor_(factor), frame_(Frame::of_points(mesh.positions)) {
    for (const Vec3& p : mesh.positions) positions_.push_back(frame_.to_frame(p));
  }

  HostedCost* cost() override { return this; }
  bool follow(const HostedContraction& made, const Contraction& contraction) override {
    EXPECT_EQ(made.rank.cost, cost_now(made.first, made.second));
    EXPECT_EQ(contraction.cost, factor_ * made.rank.cost);
    EXPECT_EQ(made.before[0], positions_[made.first]);
    EXPECT_EQ(made.before[1], positions_[made.second]);
    positions_[made.survivor] = made.position;
    contractions.push_back(contraction);
    return true;
  }

  PairEvaluation rank(Index first, Index second, PairConstraint /*constraint*/) override {
    return {0, cost_now(first, second), 0.5 * (positions_[first] + positions_[second])};
  }
  CandidatePositions place(Index /*first*/, Index /*second*/, PairConstraint /*constraint*/,
                           const PairEvaluation& rank) override {
    CandidatePositions candidates;
    candidates.add(rank.position);
    return candidates;
  }
  double final_cost(const HostedContraction& contraction) override { return factor_ * contraction.rank.cost; }
  Reach reach() const override { return Reach::ends; }
  double dimension() const override { return 0; }

  std::vector<Contraction> contractions;

 private:
  double cost_now(Index first, Index second) const {
    return made_up(first, second) + rise_ * static_cast<double>(contractions.size());
  }

  double rise_, factor_;
  Frame frame_;
  std::vector<Vec3> positions_;  ///< in the frame
};

DecimateOptions in_exact_order() {
  DecimateOptions options;
  options.order = Order::exact;
  return options;
}

TEST(Host, ThatDoesNothingChangesNothing) {
  for (const auto& [name, mesh] : all_meshes()) {
    DecimationHost host;
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 3);
    const Decimation with = decimate(mesh, target, {}, host);
    const Decimation without = decimate(mesh, target);
    EXPECT_EQ(with.mesh.positions, without.mesh.positions) << name;
    EXPECT_EQ(with.mesh.faces, without.mesh.faces) << name;
    EXPECT_EQ(with.result.n_contractions, without.result.n_contractions) << name;
  }
}

TEST(Host, ItsRefusalsHold) {
  class Refusing : public DecimationHost {
    bool refuses(const HostedContraction& contraction) override {
      return contraction.first % 3 == 0 || contraction.second % 3 == 0;
    }
  } host;
  const IndexedMesh mesh = blob(3, 5);
  const Decimation d = decimate(mesh, DecimateTarget::as_far_as_possible(), {}, host);
  EXPECT_EQ(d.result.stop, StopReason::exhausted);
  EXPECT_GT(d.result.n_contractions, 50U);
  for (Index v = 0; v < mesh.positions.size(); v += 3) {
    EXPECT_EQ(d.mesh.positions[d.vertex_map[v]], mesh.positions[v]) << v;
  }
}

TEST(Host, KeepsTheTopologyIfItMust) {
  class Keeping : public DecimationHost {
    bool keeps_topology() const override { return true; }
  } host;
  DecimateOptions options;
  options.topology = whittle::Topology::free;
  const IndexedMesh mesh = torus(24, 6, 1.0, 0.1);
  const Decimation d = decimate(mesh, DecimateTarget::faces(12), options, host);
  EXPECT_EQ(topology(d.mesh).euler(), 0);
  EXPECT_EQ(d.result.stop, StopReason::exhausted);
  EXPECT_GT(d.result.refusals[Refusal::link], 0U);
  EXPECT_GT(d.result.refused_at_end[Refusal::link], 0U);
}

TEST(HostedCost, ThatRisesUntoldIsAskedAgain) {
  const IndexedMesh mesh = noisy_torus(24, 12, 1, 0.4, 0.03, 1);
  const DecimateTarget target = DecimateTarget::vertices(100);
  MadeUpHost steady(mesh);
  MadeUpHost rising(mesh, 1000);
  const Decimation expected = decimate(mesh, target, in_exact_order(), steady);
  const Decimation d = decimate(mesh, target, in_exact_order(), rising);
  EXPECT_EQ(d.result.n_vertices, 100U);
  // All costs rise alike, so the order is that of costs that don't.
  ASSERT_EQ(rising.contractions.size(), steady.contractions.size());
  for (std::size_t i = 0; i < steady.contractions.size(); ++i) {
    EXPECT_EQ(rising.contractions[i].removed, steady.contractions[i].removed) << i;
    EXPECT_EQ(rising.contractions[i].cost, steady.contractions[i].cost + 1000.0 * static_cast<double>(i)) << i;
  }
  EXPECT_EQ(d.mesh.positions, expected.mesh.positions);
}

TEST(HostedCost, IsThatOfThePairInApproximateOrderToo) {
  const IndexedMesh mesh = noisy_torus(24, 12, 1, 0.4, 0.03, 2);
  DecimateOptions options;
  options.order = Order::approximate;
  MadeUpHost host(mesh);  // compares the cost of each contraction
  EXPECT_EQ(decimate(mesh, DecimateTarget::vertices(100), options, host).result.n_vertices, 100U);
  EXPECT_EQ(host.contractions.size(), mesh.positions.size() - 100);
}

TEST(HostedCost, TheFinalCostIsWhatTheLimitIsFor) {
  const IndexedMesh mesh = blob(3, 6);
  MadeUpHost host(mesh, 0, 2);  // ranks are at most 400,000
  const Decimation d = decimate(mesh, DecimateTarget::max_cost(500'000), in_exact_order(), host);
  EXPECT_EQ(d.result.stop, StopReason::cost);
  EXPECT_LE(d.result.max_cost, 500'000);
  EXPECT_GT(d.result.max_cost, 450'000);
  EXPECT_GT(d.result.n_contractions, 100U);
}

TEST(HostedCost, GivesPositionsForQuadricsIfTheyAreWanted) {
  const IndexedMesh mesh = blob(3, 7);
  MadeUpHost host(mesh);
  DecimateOptions options = in_exact_order();
  options.keep_quadrics = true;
  const Decimation d = decimate(mesh, DecimateTarget::faces(300), options, host);
  ASSERT_EQ(d.quadrics.size(), d.mesh.positions.size());
  const Frame frame = Frame::of_points(mesh.positions);
  for (std::size_t v = 0; v < d.quadrics.size(); ++v) {
    EXPECT_EQ(frame.to_model(d.quadrics[v].position), d.mesh.positions[v]) << v;
    EXPECT_EQ(d.quadrics[v].quadric.c, 0) << v;
  }
}

}  // namespace
}  // namespace whittle::test
