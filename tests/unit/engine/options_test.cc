#include "whittle/engine/options.hh"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/shapes/shapes.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

// `decimate` and `simplify` need a target that names what it counts: neither `{}` nor `{100}` compiles.
template <class Mesh>
concept DecimatesWithoutTarget = requires(const Mesh& mesh) {
  decimate(mesh, {});
};
template <class Mesh>
concept DecimatesToABareNumber = requires(const Mesh& mesh) {
  decimate(mesh, {100});
};
template <class Mesh>
concept SimplifiesWithoutTarget = requires(const Mesh& mesh) {
  simplify(mesh, {});
};
static_assert(!DecimatesWithoutTarget<IndexedMesh>);
static_assert(!DecimatesToABareNumber<IndexedMesh>);
static_assert(!SimplifiesWithoutTarget<IndexedMesh>);

TEST(DecimateTarget, CombinesLimits) {
  const DecimateTarget target = DecimateTarget::faces(100).or_vertices(60).or_max_cost(0.5).or_faces(80);
  EXPECT_EQ(target.n_faces(), 80U);
  EXPECT_EQ(target.n_vertices(), 60U);
  EXPECT_EQ(target.cost_limit(), 0.5);
  EXPECT_TRUE(target.is_reached_at(80, 1000));
  EXPECT_TRUE(target.is_reached_at(1000, 60));
  EXPECT_FALSE(target.is_reached_at(81, 61));
  EXPECT_FALSE(DecimateTarget::as_far_as_possible().is_reached_at(0, 0));
}

TEST(DecimateOptions, OwnWhatTheyAreGiven) {
  const IndexedMesh mesh = bracket(2);
  DecimateOptions options;
  options.feature_edges = feature_edges(mesh, 30);  // a temporary
  options.locked = std::vector<std::uint8_t>(mesh.positions.size());
  options.locked[3] = 1;
  const Decimation d = decimate(mesh, DecimateTarget::as_far_as_possible(), options);
  EXPECT_FALSE(d.feature_edges.empty());
  EXPECT_EQ(d.mesh.positions[d.vertex_map[3]], mesh.positions[3]);
}

TEST(DecimateOptions, AreRefusedWhereTheProgramRefusesThem) {
  const auto message_of = [](const DecimateOptions& options) -> std::string {
    try {
      decimate(blob(1, 1), DecimateTarget::faces(20), options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  DecimateOptions options;
  options.pairs.threshold = 0.1;
  options.isotropy = 0.5;
  EXPECT_EQ(message_of(options),
            "decimate: pairs.threshold doesn't go with isotropy: vertices that no edge joins go with plain quadrics "
            "alone");
  options.isotropy = 0;
  options.valence_weight = 1;
  EXPECT_NE(message_of(options), "");
  options = {};
  options.boundary = Boundary::free;
  options.quadric.boundary_weight = 7;
  EXPECT_EQ(message_of(options),
            "decimate: boundary_weight doesn't go with free borders: nothing holds borders that are free");
  options = {};
  options.pairs.max_pairs = 0;
  EXPECT_NE(message_of(options), "");
}

TEST(DecimateOptions, RefuseAttributesOfAWrongLength) {
  const auto is_refused = [](const auto& change) {
    IndexedMesh mesh = blob(1, 1);
    change(mesh);
    bool by_decimate = false;
    bool by_simplify = false;
    try {
      decimate(mesh, DecimateTarget::faces(20));
    } catch (const std::invalid_argument&) {
      by_decimate = true;
    }
    try {
      simplify(mesh, DecimateTarget::faces(20));
    } catch (const std::invalid_argument&) {
      by_simplify = true;
    }
    return by_decimate && by_simplify;
  };
  EXPECT_FALSE(is_refused([](IndexedMesh&) {}));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.colors.resize(m.positions.size() - 1); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.normals.resize(1); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.origins.resize(m.positions.size() + 1); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.attributes.push_back({.name = "uv", .values = {1, 2, 3}}); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.attributes.push_back({.name = "uv", .n_components = 0}); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.face_attributes.push_back({.name = "part", .values = {1}}); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.wedges.resize(m.faces.size()); }));
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.wedges.assign(3 * m.faces.size(), 0); })) << "at many vertices";
  EXPECT_TRUE(is_refused([](IndexedMesh& m) { m.face_groups.resize(m.faces.size() - 1); }));
}

TEST(DecimateResult, WarnsOfPairsThatAreLeftOut) {
  const auto kinds_of = [](const IndexedMesh& mesh, const DecimateOptions& options) {
    std::vector<WarningKind> kinds;
    for (const Warning& warning : decimate(mesh, DecimateTarget::faces(50), options).result.warnings) {
      EXPECT_FALSE(warning.text.empty());
      kinds.push_back(warning.kind);
    }
    return kinds;
  };
  IndexedMesh mesh = blob(2, 1);
  DecimateOptions options;
  EXPECT_TRUE(kinds_of(mesh, options).empty());
  options.pairs = {.threshold = 0.5, .max_pairs = 1, .across_walls = true};
  EXPECT_EQ(kinds_of(mesh, options), std::vector{WarningKind::pairs_capped});
}

}  // namespace
}  // namespace whittle::test
