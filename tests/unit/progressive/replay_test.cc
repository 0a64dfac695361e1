#include "whittle/progressive/replay.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "support/suites.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::progressive {
namespace {

using test::NamedMesh;

template <class Item>
bool has_same_bytes(const std::vector<Item>& a, const std::vector<Item>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

void expect_same(const Decimation& level, const Decimation& direct, const std::string& what) {
  EXPECT_TRUE(has_same_bytes(level.mesh.positions, direct.mesh.positions)) << what;
  EXPECT_EQ(level.mesh.faces, direct.mesh.faces) << what;
  EXPECT_TRUE(has_same_bytes(level.mesh.normals, direct.mesh.normals)) << what;
  EXPECT_EQ(level.mesh.wedges, direct.mesh.wedges) << what;
  EXPECT_TRUE(has_same_bytes(level.mesh.colors, direct.mesh.colors)) << what;
  EXPECT_EQ(level.mesh.origins, direct.mesh.origins) << what;
  EXPECT_EQ(level.face_origins, direct.face_origins) << what;
  EXPECT_EQ(level.vertex_map, direct.vertex_map) << what;
  EXPECT_EQ(level.result.n_contractions, direct.result.n_contractions) << what;
  EXPECT_EQ(level.result.n_vertices, direct.result.n_vertices) << what;
  EXPECT_EQ(level.result.n_faces, direct.result.n_faces) << what;
}

/// With random colours and normals.
IndexedMesh with_attributes(IndexedMesh mesh) {
  test::Random random(7);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 direction = random.uniform_vector(-1, 1).normalized();
    mesh.normals.push_back(
        {static_cast<float>(direction.x()), static_cast<float>(direction.y()), static_cast<float>(direction.z())});
    mesh.colors.push_back({static_cast<float>(random.uniform()), static_cast<float>(random.uniform()), 0, 1});
  }
  return mesh;
}

struct Settings {
  std::string name;
  DecimateOptions options;
};

/// All in exact order.
std::vector<Settings> exact_settings() {
  std::vector<Settings> settings(5);
  settings[0].name = "plain";
  settings[1].name = "endpoint";
  settings[1].options.quadric.placement = Placement::endpoint;
  settings[2].name = "threshold pairs";
  settings[2].options.pairs.threshold = std::numeric_limits<double>::infinity();
  settings[3].name = "free topology";
  settings[3].options.topology = Topology::free;
  settings[4].name = "memoryless";
  settings[4].options.cost = Cost::memoryless;
  settings[4].options.order = Order::exact;
  settings.push_back(settings[2]);
  settings.back().name = "threshold pairs, free topology";
  settings.back().options.topology = Topology::free;
  for (Settings& one : settings) {
    one.options.keep_steps = true;
    one.options.threads = 1;
  }
  return settings;
}

/// Each level, down and up again, as a run to that level gives it.
void expect_replays(const IndexedMesh& mesh, const DecimateOptions& options, const std::string& what) {
  const Decimation whole = decimate(mesh, DecimateTarget::faces(1), options);
  Replay replay(mesh, whole.steps);
  expect_same(replay.decimation(), whole, what + ", last level");
  const std::size_t n = whole.steps.contractions.size();
  const std::size_t stride = std::max<std::size_t>(1, n / 12);
  std::vector<Decimation> levels;
  for (std::size_t i = 0; i <= n; i += stride) {
    replay.go_to(replay.level_after(i));
    levels.push_back(replay.decimation());
    if (levels.back().result.n_faces == 0) continue;
    const auto target = DecimateTarget::faces(levels.back().result.n_faces);
    replay.go_to(*replay.level_of_faces(levels.back().result.n_faces));
    expect_same(replay.decimation(), decimate(mesh, target, options), what + ", level " + std::to_string(i));
  }
  for (std::size_t i = levels.size(); i-- > 0;) {
    replay.go_to(replay.level_after(i * stride));
    expect_same(replay.decimation(), levels[i], what + ", backwards to " + std::to_string(i * stride));
  }
  replay.go_to(0);
  for (Index v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(replay.position(v), mesh.positions[v]) << what;
  for (Index f = 0; f < mesh.faces.size(); ++f) EXPECT_EQ(replay.corners(f), mesh.faces[f]) << what;
}

TEST(Replay, HasEachLevelThatARunInExactOrderHas) {
  for (const Settings& settings : exact_settings()) {
    for (const NamedMesh& shape : test::all_meshes()) {
      expect_replays(with_attributes(shape.mesh), settings.options, shape.name + ", " + settings.name);
    }
  }
}

/// Every level of a mesh, or one in `stride`, as a run to that level gives it; then the way back.
void expect_each_level(const IndexedMesh& mesh, double threshold_rel, std::size_t stride) {
  DecimateOptions options;
  options.keep_steps = true;
  if (threshold_rel > 0) options.pairs.threshold = threshold_rel * diagonal_of(bounds_of(mesh));
  Replay replay(mesh, decimate(mesh, DecimateTarget::faces(1), options).steps);
  const std::size_t n = replay.n_steps();
  for (std::size_t i = 0; i <= n; i += stride) {
    replay.go_to(i);
    const std::uint64_t n_faces = replay.n_faces();
    if (n_faces == 0) break;
    replay.go_to(*replay.level_of_faces(n_faces));
    expect_same(replay.decimation(), decimate(mesh, DecimateTarget::faces(n_faces), options),
                "level " + std::to_string(i));
    if (testing::Test::HasFailure()) return;
  }
  replay.go_to(0);
  for (Index v = 0; v < mesh.positions.size(); ++v) ASSERT_EQ(replay.position(v), mesh.positions[v]);
  for (Index f = 0; f < mesh.faces.size(); ++f) ASSERT_EQ(replay.corners(f), mesh.faces[f]);
}

TEST(SlowReplayOnRealMesh, HasEachLevelOfBones) {
  WHITTLE_REAL_MESH_OR_SKIP(path, "bones.off");
  expect_each_level(io::read_mesh(path).mesh, 0.02, 1);
}

/// WHITTLE_REPLAY_STRIDE=1 compares every level, which takes a quarter of an hour.
TEST(SlowReplayOnRealMesh, HasLevelsOfTheBunny) {
  WHITTLE_REAL_MESH_OR_SKIP(path, "bunny.obj");
  const char* const stride = std::getenv("WHITTLE_REPLAY_STRIDE");
  expect_each_level(io::read_mesh(path).mesh, 0, stride != nullptr ? std::stoul(stride) : 500);
}

/// Faces that coincide by and by, with threshold pairs between random triangles on few points.
TEST(Replay, LeavesTheFacesThatARunLeavesWhereTheyCoincide) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    test::Random random(seed);
    IndexedMesh mesh;
    const std::size_t n = 5 + random.below(8);
    for (std::size_t v = 0; v < n; ++v) mesh.positions.push_back(random.uniform_vector(-1, 1));
    const std::size_t n_faces = 6 + random.below(30);
    for (std::size_t f = 0; f < n_faces; ++f) {
      const auto vertex = [&] { return static_cast<Index>(random.below(n)); };
      mesh.faces.push_back({vertex(), vertex(), vertex()});
    }
    for (const Settings& settings : exact_settings()) {
      if (settings.name == "memoryless") continue;
      const std::string what = settings.name + ", seed " + std::to_string(seed);
      expect_replays(mesh, settings.options, what);
    }
  }
}

/// Pauses, polish at the end, flips, normals.
TEST(Replay, EndsWhereSimplifyEnds) {
  for (const NamedMesh& shape : test::all_meshes()) {
    const IndexedMesh mesh = with_attributes(shape.mesh);
    for (const auto& [effort, normals] :
         {std::pair(Effort::fast, Normals::recompute), std::pair(Effort::normal, Normals::keep),
          std::pair(Effort::best, Normals::recompute)}) {
      SimplifyOptions options;
      options.decimate.keep_steps = true;
      options.decimate.normals = normals;
      const Simplification simplified =
          simplify(mesh, DecimateTarget::faces(mesh.faces.size() / 4 + 1), effort, options);
      Replay replay(mesh, simplified.steps, normals);
      const std::string what = shape.name + ", effort " + std::to_string(static_cast<int>(effort));
      expect_same(replay.decimation(), simplified, what);
      replay.go_to(0);
      replay.go_to(replay.n_steps());
      expect_same(replay.decimation(), simplified, what + ", again");
    }
  }
}

/// With one side behind the others, and with normals of either side.
TEST(Replay, HasBothSidesOfSheets) {
  const IndexedMesh surface = test::noisy_grid(7, 6, 0.3, 2);
  for (const std::size_t n_backs : {std::size_t{84}, std::size_t{30}}) {
    IndexedMesh mesh = test::with_backs(surface, n_backs);
    for (const Settings& settings : exact_settings()) {
      if (settings.options.pairs.threshold > 0) continue;
      expect_replays(mesh, settings.options, settings.name + ", backs " + std::to_string(n_backs));
    }
    mesh = with_attributes(mesh);
    for (const auto& [effort, normals] :
         {std::pair(Effort::fast, Normals::recompute), std::pair(Effort::normal, Normals::keep),
          std::pair(Effort::best, Normals::recompute), std::pair(Effort::best, Normals::keep)}) {
      SimplifyOptions options;
      options.decimate.keep_steps = true;
      options.decimate.normals = normals;
      const Simplification simplified = simplify(mesh, DecimateTarget::faces(40), effort, options);
      Replay replay(mesh, simplified.steps, normals);
      expect_same(replay.decimation(), simplified, "effort " + std::to_string(static_cast<int>(effort)));
      replay.go_to(0);
      EXPECT_EQ(replay.decimation().mesh.faces, mesh.faces);
      replay.go_to(replay.n_steps());
      expect_same(replay.decimation(), simplified, "again");
    }
  }
}

TEST(Replay, EndsWhereARunWithALimitOfTheErrorEnds) {
  const IndexedMesh mesh = test::noisy_sphere(3, 0.02, 3);
  SimplifyOptions options;
  options.decimate.keep_steps = true;
  const Simplification simplified = simplify(mesh, DecimateTarget::faces(8).or_max_error(0.1), Effort::normal, options);
  ASSERT_LT(simplified.mesh.faces.size(), mesh.faces.size() / 2);
  expect_same(Replay(mesh, simplified.steps).decimation(), simplified, "limit of the error");
}

/// The contractions of blocks are in the order of cost over all blocks, so levels on the way are fine everywhere alike.
/// But where blocks meet they are finer than those of a run to that level. Block by block they would be 12 times as
/// far.
TEST(SlowReplay, HasUsableLevelsWhereARunGoesInBlocks) {
  const IndexedMesh mesh = test::knot(600, 120);
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.keep_steps = true;
  const Decimation decimated = decimate(mesh, DecimateTarget::faces(2000), options);
  ASSERT_EQ(decimated.result.why_in_one_pass, "");
  ASSERT_GE(decimated.steps.pass_ends.size(), 2U);
  Replay replay(mesh, decimated.steps);
  expect_same(replay.decimation(), decimated, "last level");
  for (const std::uint64_t n_faces : {50000U, 10000U, 4000U}) {
    replay.go_to(*replay.level_of_faces(n_faces));
    const Decimation level = replay.decimation();
    const Decimation direct = decimate(mesh, DecimateTarget::faces(n_faces), options);
    const auto mean = [&](const IndexedMesh& other) { return metrics::surface_distance(mesh, other).mean; };
    EXPECT_LE(mean(level.mesh), 1.8 * mean(direct.mesh)) << n_faces;
  }
}

TEST(Replay, FindsLevelsByCounts) {
  const IndexedMesh mesh = test::sphere(3);
  DecimateOptions options;
  options.keep_steps = true;
  const Decimation decimated = decimate(mesh, DecimateTarget::faces(100), options);
  Replay replay(mesh, decimated.steps);
  EXPECT_EQ(replay.level_of_faces(99), std::nullopt);
  EXPECT_EQ(replay.level_of_faces(2000), 0U);
  EXPECT_EQ(replay.level_of_vertices(0), std::nullopt);
  EXPECT_EQ(replay.level_at(1), replay.n_steps());
  EXPECT_EQ(replay.level_at(0), 0U);
  EXPECT_EQ(replay.level_of_cost(std::numeric_limits<double>::infinity()), replay.n_steps());
  EXPECT_EQ(replay.level_of_cost(-1), 0U);
  replay.go_to(*replay.level_of_vertices(200));
  EXPECT_EQ(replay.n_vertices(), 200U);
  replay.go_to(*replay.level_of_faces(501));
  EXPECT_EQ(replay.n_faces(), 500U);
  const double cost = replay.cost();
  replay.go_to(replay.level_of_cost(cost));
  EXPECT_EQ(replay.cost(), cost);
  EXPECT_THROW(replay.go_to(replay.n_steps() + 1), std::out_of_range);
}

TEST(Replay, RejectsStepsThatCannotBeMade) {
  const IndexedMesh mesh = test::icosahedron();
  const auto replay = [&](std::vector<Contraction> contractions, std::vector<PassEnd> ends = {}) {
    return Replay(mesh, {std::move(contractions), std::move(ends)});
  };
  const auto made = [](Index survivor, Index removed, const Vec3& position, double cost) {
    return Contraction{survivor, removed, position, cost, false, false};
  };
  const Vec3 at = Vec3::Zero();
  const double nan = std::nan("");
  EXPECT_NO_THROW(replay({made(0, 1, at, 0)}));
  EXPECT_THROW(replay({made(0, 0, at, 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 12, at, 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(12, 0, at, 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 1, at, 0), made(1, 2, at, 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 1, at, 0), made(2, 1, at, 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 1, Vec3(0, nan, 0), 0)}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 1, at, nan)}), std::invalid_argument);
  EXPECT_THROW(replay({}, {{1, {}, {}}}), std::invalid_argument);
  EXPECT_THROW(replay({}, {{0, {{12, at}}, {}}}), std::invalid_argument);
  EXPECT_THROW(replay({}, {{0, {}, {{20, {0, 1, 2}}}}}), std::invalid_argument);
  EXPECT_THROW(replay({}, {{0, {}, {{0, {0, 1, 1}}}}}), std::invalid_argument);
  EXPECT_THROW(replay({made(0, 1, at, 0)}, {{1, {}, {{0, {0, 1, 2}}}}}), std::invalid_argument);
  IndexedMesh wrong = mesh;
  wrong.faces[3][1] = 12;
  EXPECT_THROW(Replay(wrong, {}), std::invalid_argument);
  wrong = mesh;
  wrong.positions[3].x() = nan;
  EXPECT_THROW(Replay(wrong, {}), std::invalid_argument);
  wrong = mesh;
  wrong.colors.resize(3);
  EXPECT_THROW(Replay(wrong, {}), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::progressive
