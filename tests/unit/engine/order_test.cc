#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "oracle/brute_force.hh"
#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "support/transforms.hh"
#include "whittle/core/wedges.hh"

// Compares the engine's contractions with those of an algorithm that evaluates every edge anew after each contraction.

namespace whittle::test {
namespace {

struct Case {
  std::string name;
  IndexedMesh mesh;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// With three groups of faces, here and there.
IndexedMesh in_groups(IndexedMesh mesh) {
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    mesh.face_groups.push_back(static_cast<Index>((middle.x() > 0.3 ? 1 : 0) + (middle.y() > middle.x() ? 1 : 0)));
  }
  return mesh;
}

/// With labels instead: the areas of a region of few faces are the ones that end first.
IndexedMesh in_labels(IndexedMesh mesh) {
  mesh = in_groups(std::move(mesh));
  Attribute label{.name = "label", .kind = AttributeKind::category, .n_components = 1, .values = {}};
  label.values.assign(mesh.face_groups.begin(), mesh.face_groups.end());
  label.values.front() = 9;
  mesh.face_groups.clear();
  mesh.face_attributes.push_back(std::move(label));
  return mesh;
}

std::vector<Case> all_shapes() {
  return {{"tetrahedron", tetrahedron()},
          {"octahedron", octahedron()},
          {"icosahedron", icosahedron()},
          {"cube", cube()},
          {"tessellated_cube(4)", tessellated_cube(4)},
          {"csaszar_torus", csaszar_torus()},
          {"sphere(2)", sphere(2)},
          {"uv_sphere(6,20)", uv_sphere(6, 20)},
          {"torus(14,8)", torus(14, 8)},
          {"noisy_torus(16,8)", noisy_torus(16, 8, 1, 0.35, 0.03, 1)},
          {"noisy_sphere(2)", noisy_sphere(2, 0.05, 2)},
          {"blob(2)", blob(2, 3)},
          {"knot(40,6)", knot(40, 6)},
          {"grid(8,6)", grid(8, 6)},
          {"noisy_grid(9,8)", noisy_grid(9, 8, 0.3, 4)},
          {"two-sided noisy_grid(7,6)", with_backs(noisy_grid(7, 6, 0.3, 4))},
          {"half two-sided noisy_grid(7,6)", with_backs(noisy_grid(7, 6, 0.3, 4), 40)},
          {"terrain(11)", terrain(11, 5)},
          {"open_cylinder(12,5)", open_cylinder(12, 5)},
          {"moebius(14,3)", moebius(14, 3)},
          {"single_triangle", single_triangle()},
          {"two_triangles", two_triangles()},
          {"cone(24)", cone(24)},
          {"frustum(16)", frustum(16)},
          {"bracket(2)", bracket(2)},
          {"spheres(2,1)", spheres(2, 1)},
          {"boxes(2,2)", boxes(2, 2)},
          {"bow_tie", bow_tie()},
          {"bow-tied spheres", glued(spheres(2, 1, 0.0))},
          {"three_faces_on_an_edge", three_faces_on_an_edge()},
          {"book(3,4)", book(3, 4)},
          {"book(11,4)", book(11, 4)},
          {"two_cubes_on_an_edge(3)", two_cubes_on_an_edge(3)},
          {"pillow", pillow()},
          {"soup(icosahedron)", soup(icosahedron())},
          {"with_duplicate_faces(blob)", with_duplicate_faces(blob(1, 3), 7)},
          {"with_isolated_vertices(blob)", with_isolated_vertices(blob(1, 4), 9, 1)},
          {"inside_out(blob)", inside_out(blob(2, 6))},
          {"charted_cube(3)", charted_cube(3)},
          {"textured_torus(14,8)", textured_torus(14, 8)},
          {"blob(2) in groups", in_groups(blob(2, 3))},
          {"noisy_grid(9,8) in groups", in_groups(noisy_grid(9, 8, 0.3, 4))},
          {"bracket(2) in groups", in_groups(bracket(2))},
          {"two_cubes_on_an_edge(3) in groups", in_groups(two_cubes_on_an_edge(3))},
          {"blob(2) in labels", in_labels(blob(2, 5))},
          {"noisy_grid(8,8) in labels", in_labels(noisy_grid(8, 8, 0.3, 7))},
          {"moebius(14,3) in groups", in_groups(moebius(14, 3))},
          {"book(3,4) in groups", in_groups(book(3, 4))}};
}

struct Setting {
  std::string name;
  DecimateOptions options;
  /// Without regularisation every contraction on flat ground costs nothing but rounding, and rounding decides the
  /// order. There only the costs are compared, to a rounding floor (frame size 1, face weights of at most 1).
  bool order_is_defined = true;
  double threshold = 0;  ///< for pairs, in mean edge lengths
};

struct Settings {
  std::vector<Setting> list{{"defaults", {}}};

  template <class Change>
  void add(const std::string& name, const Change& change) {
    list.push_back({name, {}});
    change(list.back().options);
  }
  template <class Change>
  void add_memoryless(const std::string& name, const Change& change) {
    add("memoryless" + name, [&](DecimateOptions& o) {
      o.cost = Cost::memoryless;
      o.order = Order::exact;
      change(o);
    });
  }
  template <class Change>
  void add_threshold(double threshold, const std::string& name, const Change& change) {
    add("threshold " + name, change);
    list.back().threshold = threshold;
  }
};

void add_plain_quadrics(Settings& settings) {
  settings.add("uniform", [](DecimateOptions& o) { o.quadric.weights = Weights::uniform; });
  settings.add("area_angle", [](DecimateOptions& o) { o.quadric.weights = Weights::area_angle; });
  settings.add("midpoint", [](DecimateOptions& o) { o.quadric.placement = Placement::midpoint; });
  settings.add("endpoint", [](DecimateOptions& o) { o.quadric.placement = Placement::endpoint; });
  settings.add("locked border", [](DecimateOptions& o) { o.boundary = Boundary::locked; });
  settings.add("free border", [](DecimateOptions& o) { o.boundary = Boundary::free; });
  settings.add("flip 180", [](DecimateOptions& o) { o.max_normal_flip_deg = 180; });
  settings.add("flip 20", [](DecimateOptions& o) { o.max_normal_flip_deg = 20; });
  settings.add("unregularised", [](DecimateOptions& o) { o.quadric.regularization = 0; });
  settings.list.back().order_is_defined = false;
  settings.add("round triangles", [](DecimateOptions& o) { o.quadric.regularization = 4e-3; });
  settings.add("free topology", [](DecimateOptions& o) { o.topology = whittle::Topology::free; });
}

void add_lindstrom_turk(Settings& settings) {
  settings.add("lindstrom-turk, locked border", [](DecimateOptions& o) {
    o.cost = Cost::lindstrom_turk;
    o.boundary = Boundary::locked;
  });
  settings.add("lindstrom-turk, free topology", [](DecimateOptions& o) {
    o.cost = Cost::lindstrom_turk;
    o.topology = whittle::Topology::free;
  });
}

void add_costs(Settings& settings) {
  for (const CostTraits& traits : all_cost_traits) {
    settings.add(std::string(traits.name), [&traits](DecimateOptions& o) {
      o.cost = traits.cost;
      o.order = Order::exact;
    });
  }
}

void add_memoryless(Settings& settings) {
  settings.add_memoryless(", locked border", [](DecimateOptions& o) { o.boundary = Boundary::locked; });
  settings.add_memoryless(", free border", [](DecimateOptions& o) { o.boundary = Boundary::free; });
  settings.add_memoryless(", free topology", [](DecimateOptions& o) { o.topology = whittle::Topology::free; });
  settings.add_memoryless(", flip 180", [](DecimateOptions& o) { o.max_normal_flip_deg = 180; });
  settings.add_memoryless(", flip 20", [](DecimateOptions& o) { o.max_normal_flip_deg = 20; });
  settings.add_memoryless(", midpoint", [](DecimateOptions& o) { o.quadric.placement = Placement::midpoint; });
  settings.add_memoryless(", valence 1", [](DecimateOptions& o) { o.valence_weight = 1; });
  settings.add_memoryless(", radius ratio 0.4", [](DecimateOptions& o) { o.min_radius_ratio = 0.4; });
  settings.add_memoryless(", features 40", [](DecimateOptions& o) { o.feature_angle_deg = 40; });
}

void add_edge_length_and_shape(Settings& settings) {
  settings.add("isotropic 0.3", [](DecimateOptions& o) { o.isotropy = 0.3; });
  settings.add("isotropic 1", [](DecimateOptions& o) { o.isotropy = 1; });
  settings.add("valence 0.5", [](DecimateOptions& o) { o.valence_weight = 0.5; });
  settings.add("valence 4, isotropic 1", [](DecimateOptions& o) {
    o.valence_weight = 4;
    o.isotropy = 1;
  });
  settings.add("valence 1, lindstrom-turk", [](DecimateOptions& o) {
    o.valence_weight = 1;
    o.cost = Cost::lindstrom_turk;
  });
  settings.add("valence 1, free topology", [](DecimateOptions& o) {
    o.valence_weight = 1;
    o.topology = whittle::Topology::free;
  });
  settings.add("radius ratio 0.4", [](DecimateOptions& o) { o.min_radius_ratio = 0.4; });
}

void add_features(Settings& settings) {
  settings.add("features 40", [](DecimateOptions& o) { o.feature_angle_deg = 40; });
  settings.add("features 40, endpoint", [](DecimateOptions& o) {
    o.feature_angle_deg = 40;
    o.quadric.placement = Placement::endpoint;
  });
  settings.add("features 40, lindstrom-turk", [](DecimateOptions& o) {
    o.feature_angle_deg = 40;
    o.cost = Cost::lindstrom_turk;
  });
  settings.add("features 40, edge length", [](DecimateOptions& o) {
    o.feature_angle_deg = 40;
    o.cost = Cost::midpoint;
  });
  settings.add("features 25 within 0.02", [](DecimateOptions& o) {
    o.feature_angle_deg = 25;
    o.feature_tolerance = 0.02;
  });
}

void add_threshold_pairs(Settings& settings) {
  settings.add_threshold(0.7, "0.7", [](DecimateOptions&) {});
  settings.add_threshold(1.6, "1.6", [](DecimateOptions&) {});
  settings.add_threshold(1.6, "1.6, held hardly", [](DecimateOptions& o) { o.quadric.point_weight = 1e-9; });
  settings.add_threshold(2.1, "2.1, free topology", [](DecimateOptions& o) { o.topology = whittle::Topology::free; });
  settings.add_threshold(2.1, "2.1, flip 180", [](DecimateOptions& o) { o.max_normal_flip_deg = 180; });
  settings.add_threshold(2.1, "2.1, across walls, at most 3", [](DecimateOptions& o) {
    o.pairs.across_walls = true;
    o.pairs.max_pairs = 3;
  });
  settings.add_threshold(1.6, "1.6, midpoint", [](DecimateOptions& o) { o.quadric.placement = Placement::midpoint; });
  settings.add_threshold(1.6, "1.6, locked border", [](DecimateOptions& o) { o.boundary = Boundary::locked; });
}

std::vector<Setting> all_settings() {
  Settings settings;
  add_costs(settings);
  add_plain_quadrics(settings);
  add_lindstrom_turk(settings);
  add_memoryless(settings);
  add_edge_length_and_shape(settings);
  add_features(settings);
  add_threshold_pairs(settings);
  return settings.list;
}

double mean_edge_length(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const auto length = [&](Index v, Index w) { return (mesh.positions[v] - mesh.positions[w]).norm(); };
    sum += length(a, b) + length(b, c) + length(c, a);
  }
  return sum / (3.0 * static_cast<double>(mesh.faces.size()));
}

constexpr double rounding_floor = 1e-14;

std::vector<Contraction> contractions_of(const IndexedMesh& mesh, DecimateOptions options) {
  std::vector<Contraction> done;
  options.listener = [&](const Contraction& c) { done.push_back(c); };
  decimate(mesh, DecimateTarget::as_far_as_possible(), options);
  return done;
}

class ContractionOrder : public testing::TestWithParam<Case> {};

/// Where there are seams: with seams kept, too.
std::vector<Setting> settings_for(const IndexedMesh& mesh) {
  std::vector<Setting> settings = all_settings();
  if (seam_edges(mesh).empty()) return settings;
  std::vector<Setting> all = settings;
  for (Setting& setting : settings) {
    setting.name += ", seams kept";
    setting.options.seams = Seams::keep;
    all.push_back(std::move(setting));
  }
  return all;
}

TEST_P(ContractionOrder, IsThatOfBruteForce) {
  const IndexedMesh& mesh = GetParam().mesh;
  for (auto& [name, options, order_is_defined, threshold] : settings_for(mesh)) {
    options.pairs.threshold = threshold * mean_edge_length(mesh);
    SCOPED_TRACE(GetParam().name + ", " + name);
    const std::vector<Contraction> expected =
        BruteForceDecimater(mesh, options).run(DecimateTarget::as_far_as_possible());
    const std::vector<Contraction> found = contractions_of(mesh, options);
    const std::size_t n = std::min(expected.size(), found.size());
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_same = found[i].survivor == expected[i].survivor && found[i].removed == expected[i].removed;
      if (!order_is_defined && !is_same && found[i].cost <= rounding_floor && expected[i].cost <= rounding_floor) {
        std::cout << "[     NOTE ] " << GetParam().name << ", " << name << ": costs below the rounding floor from "
                  << "contraction " << i << " on, orders not compared\n";
        return;
      }
      ASSERT_TRUE(is_same) << "contraction " << i << " of " << expected.size() << ": " << found[i].removed << " into "
                           << found[i].survivor << " at " << found[i].cost << ", expected " << expected[i].removed
                           << " into " << expected[i].survivor << " at " << expected[i].cost;
      ASSERT_EQ(found[i].cost, expected[i].cost) << "contraction " << i;
      ASSERT_EQ(found[i].position, expected[i].position) << "contraction " << i;
    }
    EXPECT_EQ(found.size(), expected.size());
  }
}

/// On a mesh collapsed to a line all costs are 0. The lowest vertices are at the border.
TEST(ContractionOrderOfTies, IsThatOfBruteForceWhereALockedVertexSurvives) {
  for (const Case& named : all_shapes()) {
    if (!seam_edges(named.mesh).empty()) continue;  // there ties have another order where a vertex on a line survives
    IndexedMesh line = named.mesh;
    for (Vec3& p : line.positions) p = {0, 0, std::round(2 * p.z())};
    DecimateOptions options;
    options.cost = Cost::quadric;
    options.boundary = Boundary::locked;
    SCOPED_TRACE(named.name);
    const std::vector<Contraction> expected =
        BruteForceDecimater(line, options).run(DecimateTarget::as_far_as_possible());
    const std::vector<Contraction> found = contractions_of(line, options);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].survivor, expected[i].survivor) << "contraction " << i;
      EXPECT_EQ(found[i].removed, expected[i].removed) << "contraction " << i;
    }
  }
}

constexpr std::size_t n_faces_of_slow = 300;  // brute force takes longest on these

std::vector<Case> shapes_of(bool is_slow) {
  std::vector<Case> shapes = all_shapes();
  std::erase_if(shapes, [&](const Case& shape) { return (shape.mesh.faces.size() >= n_faces_of_slow) != is_slow; });
  return shapes;
}

std::string name_of_case(const testing::TestParamInfo<Case>& test) {
  std::string name = test.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Shapes, ContractionOrder, testing::ValuesIn(shapes_of(false)), name_of_case);
INSTANTIATE_TEST_SUITE_P(SlowShapes, ContractionOrder, testing::ValuesIn(shapes_of(true)), name_of_case);

}  // namespace
}  // namespace whittle::test
